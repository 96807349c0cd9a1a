#!/usr/bin/env bash
# A day's work in the real window, with keys only: a STEP product becomes a scenario, its fits and a path are found, the
# sequence is planned, one of its steps is moved by hand, a direction is forbidden, a step is moved to another place, the
# work instruction and a film are written, all is saved, and opened again.
# usage: xvfb_day_by_keys.sh GLISSADE STEP_FILE LANGUAGE THEME SCALE
# Pictures of the stops are kept in GLISSADE_DAY_PICTURES where it is set.
set -u
[ -n "${GLISSADE_DAY:-}" ] || { echo "skipped: set GLISSADE_DAY; it takes some minutes"; exit 77; }
glissade=$1
product=$2
language=$3
theme=$4
export QT_SCALE_FACTOR=$5
SCREEN=1280x720
[ "$5" = 1 ] || SCREEN=1920x1080
TOOLS=
. "${BASH_SOURCE%/*}/xvfb_display.sh"
scenario=$work/product.json
log=$work/glissade.log

# top: the window that is above all others. Dialogs are made after the window.
top() { xdotool search --onlyvisible --pid "$window" --name . 2>/dev/null | tail -n 1; }
# titled NAME: a window whose title has this text is there within half a minute.
titled() {
  for _ in $(seq 300); do
    xdotool search --onlyvisible --name "$1" >/dev/null 2>&1 && return
    sleep 0.1
  done
  fail "no window is called $1"
}
# keys KEY...: to the window that is above all others.
keys() {
  local id
  for _ in $(seq 50); do id=$(top); [ -z "$id" ] || break; sleep 0.1; done
  xdotool windowfocus --sync "$id" 2>/dev/null
  sleep 0.2
  xdotool key --delay 60 "$@"
  sleep 0.4
}
# answer FILE: types a file's name into the dialog that asks for it, and waits until it is written.
answer() {
  sleep 1
  xdotool windowfocus --sync "$(top)" 2>/dev/null
  xdotool type --delay 15 "$1"
  keys Return
  for _ in $(seq 3000); do [ -s "$1" ] && return; sleep 0.1; done
  look failed
  fail "$1 is not written"
}
# saved TEXT: Ctrl+S until the scenario's file has this text.
saved() {
  for _ in $(seq 60); do
    keys ctrl+s
    grep -q "$1" "$scenario" 2>/dev/null && return
    sleep 0.5
  done
  look failed
  fail "the scenario has no $1"
}
# look NAME: a picture of the stop.
look() {
  [ -z "${GLISSADE_DAY_PICTURES:-}" ] || import -window root "$GLISSADE_DAY_PICTURES/$1-$language-$theme.png"
}
open_window() {
  "$glissade" "$@" --language "$language" --theme "$theme" --size 1270x710 >"$log" 2>&1 &
  window=$!
}
for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done

ended='"end": "\(complete\|stuck\)"'
open_window "$product"
sleep 3
look parts
# Return does nothing until the file is read.
for _ in $(seq 100); do
  keys Return
  xdotool search --onlyvisible --name ' — Glissade$' >/dev/null 2>&1 && break
done
titled ' — Glissade$'
keys ctrl+i
sleep 3
look fits
keys F5
sleep 3
look path
keys ctrl+s
answer "$scenario"
saved '"paths"'

keys ctrl+j
# Saving works while the plan grows, too.
saved '"plan"'
saved "$ended"
look sequence
# The first row is now the part that is removed first, which F5 moves.
keys ctrl+alt+j
keys alt+9 Home
look step
keys ctrl+alt+m
sleep 2
look by-hand
keys F5
# The run begins when the hand moves the part.
xdotool keydown d; sleep 0.3; xdotool keyup d
saved '"by hand"'
sleep 1
saved "$ended"
look taken

keys alt+9 Home
keys alt+Down
saved '"places"'
sleep 1
saved "$ended"
keys alt+9 Home
keys Menu
look menu
keys Escape
keys ctrl+k
xdotool type --delay 15 "$([ "$language" = fr ] && echo "interdire cette direction" || echo "forbid this direction")"
look palette
keys Return
saved '"forbidden"'
sleep 1
saved "$ended"
keys ctrl+shift+i
answer "$work/instruction.pdf"
keys ctrl+k
xdotool type --delay 15 "film"
look film
keys Return
answer "$work/film.webm"

keys ctrl+s
sleep 1
keys ctrl+q
for _ in $(seq 100); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
kill -0 "$window" 2>/dev/null && fail "Ctrl+Q does not quit: something is not saved"
echo "passed"
