#!/usr/bin/env bash
# A day's work in the real window: a STEP product becomes a scenario with real keys. Then scripts see its fits, plan,
# compare two paths, section, measure, report, film and plan the sequence. The window is closed, and all is there again.
# usage: xvfb_working_day.sh GLISSADE STEP_FILE
set -u
glissade=$1
product=$2
TOOLS=
. "${BASH_SOURCE%/*}/xvfb_display.sh"
scenario=$work/product.json
log=$work/glissade.log

# window_of NAME: waits until a window has this name; prints its id.
window_of() {
  local id
  for _ in $(seq 300); do
    id=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1)
    [ -z "$id" ] || { echo "$id"; return; }
    sleep 0.1
  done
}

# press NAME KEY...: into the window of this name.
press() {
  local id
  id=$(window_of "$1")
  shift
  [ -n "$id" ] && xdotool windowfocus --sync "$id" && sleep 0.3 && xdotool "$@"
}

# carry_out SCRIPT: in a window of its own.
carry_out() {
  "$glissade" "$scenario" --size 1200x760 --script "$1" >"$log" 2>&1 || fail "$1: exit code $?"
}

for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done

# With keys: the dialog of parts, a run, Ctrl+S.
"$glissade" "$product" --size 1200x760 >"$log" 2>&1 &
window=$!
[ -n "$(window_of '^New scenario from parts$')" ] || fail "the dialog of parts does not open"
# Return does nothing until the file is read.
for _ in $(seq 100); do
  xdotool search --onlyvisible --name '^New scenario from parts$' >/dev/null 2>&1 || break
  press '^New scenario from parts$' key Return
  sleep 0.3
done
press ' — Glissade$' key F5 || fail "the scenario is not made"
sleep 2
press ' — Glissade$' key ctrl+s || fail "the window is gone"
press '^Save the scenario$' type "$scenario" || fail "Ctrl+S asks for no file"
press '^Save the scenario$' key Return
for _ in $(seq 100); do
  grep -q '"paths"' "$scenario" 2>/dev/null && break
  sleep 0.5
  press ' — Glissade$' key ctrl+s
done
grep -q '"paths"' "$scenario" || fail "the path is not saved"
press ' — Glissade$' key ctrl+q
for _ in $(seq 100); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
kill -0 "$window" 2>/dev/null && fail "Ctrl+Q does not quit"

cd "$work" || exit 1
cat >day.script <<END
open-sample teaching/scenario.json
action run.start
wait solved 60
action paths.keep
action run.restart-new-seed
wait solved 60
action paths.keep
expect-kept-paths 2
action paths.compare
compare-screenshot compare.png
open $scenario
expect-kept-paths 1
action fits.find
expect-fits cylindrical 3
section x 0.5
screenshot section.png
section x off
action measure.clearance
click-body bolt
click-body screw
expect-measure mm
action run.start
wait solved 60
report-path report.html
report-path report.pdf
export-sweep sweep.stl
plan-sequence all
expect-sequence steps 4
show-step 2
explode 1
screenshot exploded.png
explode 0
action sequence.show-product
export-sequence instruction.pdf
save-view front
save $scenario
END
carry_out day.script
cat >again.script <<END
expect-kept-paths 1
expect-kept-path @1 proved
expect-sequence steps 4
expect-sequence proved 4
END
carry_out again.script
for file in compare.png section.png exploded.png report.html report.pdf sweep.stl instruction.pdf; do
  [ -s "$file" ] || fail "$file was not written"
done
echo "passed"
