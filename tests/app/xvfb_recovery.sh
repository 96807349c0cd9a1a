#!/usr/bin/env bash
# kill -9 of the real window while it has unsaved edits: the next start offers them, opens them, and saves them over
# the file; a file that changed meanwhile is asked about. On a virtual display, by keys only.
# usage: xvfb_recovery.sh GLISSADE SOURCE_DIR [PICTURES [OPTION...]]
# Pictures of the dialogs are left in the folder PICTURES; OPTIONs are given to the window (--theme dark, --language fr).
set -u
glissade=$1
source_dir=$2
pictures=${3:-}
shift $(($# < 3 ? $# : 3))
options=("$@")
TOOLS=python3
. "${BASH_SOURCE%/*}/xvfb_display.sh"
scenario=$work/scenario.json
cp "$source_dir/samples/teaching/scenario.json" "$scenario"

# xwd would leave out windows with another visual than the root's.
picture() { [ -z "$pictures" ] || { mkdir -p "$pictures"; cp "$work/frame/Xvfb_screen0" "$pictures/$1.xwd"; }; }
running() { kill -0 "$window" 2>/dev/null || fail "the program ended"; }

# until_true SECONDS WHAT COMMAND...
until_true() {
  local left=$(($1 * 10)) what=$2
  shift 2
  while ! "$@" >/dev/null 2>&1; do
    left=$((left - 1))
    [ "$left" -gt 0 ] || { picture failed; fail "$what"; }
    sleep 0.1
  done
}
# Windows that are shown: the main window, and a dialog.
shown() { xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1; }
is_shown() { [ -n "$(shown "$1")" ]; }
is_gone() { [ -z "$(shown "$1")" ]; }
# Without a window manager nobody else gives the focus to a window.
keys() {
  local to=$1
  shift
  xdotool windowfocus "$(shown "$to")" 2>/dev/null
  sleep 0.3
  xdotool key "$@"
}
start() {
  "$glissade" "$scenario" --size 1280x720 ${options[@]+"${options[@]}"} >"$work/glissade.log" 2>&1 &
  window=$!
  until_true 20 "no window appeared" is_shown 'Glissade$'
  sleep 1
}
# By the fourth number of the file the ends are swapped or not.
start_of() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["start"]["position"])' "$1"; }
swapped() { [ "$(start_of "$scenario")" = "$(python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["goal"]["position"])' "$source_dir/samples/teaching/scenario.json")" ]; }
unsaved() { ls "$work"/data/Glissade/unsaved/* 2>/dev/null | grep -q .; }
# Not the file that is being written: it counts once it is renamed.
edits_kept() { grep -qs 'glissade-scenario' "$work"/data/Glissade/unsaved/*.edits; }

until_true 10 "no display" xdotool getdisplaygeometry
before=$(sha256sum "$scenario")
start
keys 'Glissade$' ctrl+alt+4
until_true 20 "edits are not written" edits_kept
running
kill -9 "$window"
wait "$window" 2>/dev/null
[ "$before" = "$(sha256sum "$scenario")" ] || fail "the file was written without being saved"

# The edits are offered; Enter opens them.
dialog='Unsaved edits|Modifications non enregistr'
start
until_true 20 "the edits are not offered" is_shown "$dialog"
picture recovery
keys "$dialog" Return
until_true 20 "the dialog stays" is_gone "$dialog"
sleep 1
running
picture recovered
[ "$before" = "$(sha256sum "$scenario")" ] || fail "the file was written without being saved"

# Somebody else changes the file: saving asks. Alt+O overwrites, and the other version stays.
sed 's/"Four bodies"/"Changed elsewhere"/' "$scenario" >"$work/other.json" && cp "$work/other.json" "$scenario"
keys 'Glissade$' ctrl+s
conflict='The file was changed|Le fichier a '
until_true 20 "a file that changed is not asked about" is_shown "$conflict"
picture conflict
grep -q 'Changed elsewhere' "$scenario" || fail "the other version was overwritten without an answer"
keys "$conflict" "${OVERWRITE_KEY:-alt+o}"
until_true 20 "the dialog stays" is_gone "$conflict"
until_true 10 "the edits were not saved" swapped
grep -rqs 'Changed elsewhere' "$work/.earlier-versions" || fail "the other version is lost"
keys 'Glissade$' "${FILE_MENU_KEY:-alt+f}"
sleep 0.5
xdotool key ${VERSIONS_KEYS:-v}
sleep 0.5
picture versions
xdotool key Escape Escape Escape
keys 'Glissade$' ctrl+q
for _ in $(seq 50); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
kill -0 "$window" 2>/dev/null && fail "Ctrl+Q does not quit"

# What was saved is not offered again.
start
sleep 2
is_gone "$dialog" || fail "edits that were saved are offered again"
running
echo passed
