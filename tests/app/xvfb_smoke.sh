#!/usr/bin/env bash
# The real OpenGL window on a virtual display, with real keys and mouse: it opens, draws, orbits,
# steers, starts and quits.
# usage: xvfb_smoke.sh GLISSADE SOURCE_DIR
set -u
glissade=$1
source_dir=$2
TOOLS=xwd
. "${BASH_SOURCE%/*}/xvfb_display.sh"
# The rows 250 to 550 of the screen, of 4 bytes a pixel: there the 3D view has no cube, axes or scale, which are painted
# over it. So a difference there is one of the scene, as long as no panel changes.
picture() {
  xwd -root -silent -display "$display" >"$work/screen" || fail "no picture can be taken"
  tail -c $((1280 * 800 * 4)) "$work/screen" | tail -c +$((1280 * 250 * 4 + 1)) | head -c $((1280 * 300 * 4)) >"$work/$1"
}

# expect_change BEFORE AFTER WHAT: takes pictures until one differs from BEFORE; fails with WHAT.
expect_change() {
  for _ in $(seq 60); do
    picture "$2"
    cmp -s "$work/$1" "$work/$2" || { sleep 0.5; picture "$2"; return; }
    sleep 0.25
  done
  fail "$3"
}

for option in --help --version; do
  env -u DISPLAY "$glissade" $option >"$work/glissade.log" 2>&1 || fail "$option needs a display"
done

for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done
picture empty
"$glissade" "$source_dir/samples/environment-1/scenario.json" --size 1280x720 >"$work/glissade.log" 2>&1 &
window=$!
for _ in $(seq 100); do
  id=$(xdotool search --name 'Glissade' 2>/dev/null | tail -n 1)
  [ -n "$id" ] && break
  kill -0 "$window" 2>/dev/null || fail "the program ended"
  sleep 0.1
done
[ -n "$id" ] || fail "no window appeared"
expect_change empty opened "nothing is drawn"

# Drag in the middle of the view: the camera orbits.
xdotool mousemove 640 360 mousedown 1 mousemove 700 380 mousemove 760 400 mouseup 1
expect_change opened orbited "dragging does not orbit"

# Keys over the view: the object moves.
xdotool windowfocus "$id" 2>/dev/null
xdotool mousemove 640 360 click 1
xdotool keydown d; sleep 1; xdotool keyup d
expect_change orbited steered "keys do not steer"

xdotool key F5
expect_change steered planning "F5 does not start"
xdotool key shift+F5
sleep 0.5
kill -0 "$window" 2>/dev/null || fail "the program ended"
xdotool key ctrl+q
# If the run has found a path meanwhile, the program asks whether to keep it: the second button discards it.
question() { xdotool search --onlyvisible --name '^Keep the path.$' 2>/dev/null | head -n 1; }
for _ in $(seq 100); do
  kill -0 "$window" 2>/dev/null || { echo "passed"; exit 0; }
  asked=$(question)
  if [ -n "$asked" ] && xdotool windowfocus "$asked" 2>/dev/null; then sleep 0.3; xdotool key Tab space; fi
  sleep 0.1
done
fail "Ctrl+Q does not quit"
