#!/usr/bin/env bash
# A step of an assembly plan that its search does not find, in the real window, with keys only: a cube in a channel with
# four bends, 0.4 mm wider than the cube. The plan ends stuck, the part is moved by hand, and keys lead the cube out along
# the walls. The path is proved, becomes the step of the plan, and is saved. `auto` alone does not leave this channel
# within 90 s.
# usage: xvfb_step_by_hand.sh GLISSADE GLISSADE_CLI
# Pictures of the stops are kept in GLISSADE_STEP_PICTURES where it is set.
set -u
glissade=$1
cli=$2
SCREEN=1280x720
TOOLS=
. "${BASH_SOURCE%/*}/xvfb_display.sh"
log=$work/glissade.log
scenario=$work/channel.json

# The channel in cells of a grid, and the solid cells and two plates around it as one mesh.
awk 'BEGIN {
  side = 0.1; cell = side + 0.0004
  split("0,0 1,0 2,0 2,1 2,2 3,2 4,2 4,1 4,0 5,0 6,0", channel, " ")
  for (i in channel) free[channel[i]] = 1
  for (x = -1; x <= 5; ++x) for (z = -1; z <= 3; ++z) if (!((x "," z) in free)) box(x, 0, z, 1, 1, 1)
  box(2, -0.75, 1, 7, 0.5, 5); box(2, 0.75, 1, 7, 0.5, 5)
}
function box(x, y, z, a, b, c,   i, f, corner) {
  for (i = 0; i < 8; ++i)
    printf "v %.9f %.9f %.9f\n", (x + a * (int(i / 4) - 0.5)) * cell, (y + b * (int(i / 2) % 2 - 0.5)) * cell,
           (z + c * (i % 2 - 0.5)) * cell
  split("1 2 4 3 5 7 8 6 1 5 6 2 3 4 8 7 1 3 7 5 2 6 8 4", corner, " ")
  for (f = 0; f < 6; ++f)
    print "f", corner[4*f+1] + count, corner[4*f+2] + count, corner[4*f+3] + count, corner[4*f+4] + count
  count += 8
}' >"$work/housing.obj"
cat >"$scenario" <<'JSON'
{"format": "glissade-scenario", "version": 1, "planner": "interactive", "seed": 1,
 "assets": [{"id": "housing", "path": "housing.obj", "unit": 1.0, "up_axis": "z"}],
 "object": {"id": "cube", "name": "Cube", "geometry": {"box": [0.1, 0.1, 0.1]}},
 "start": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}, "goal": "out",
 "bodies": [{"id": "housing", "name": "Housing", "mobility": "static", "geometry": {"mesh": "housing"},
   "pose": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}}],
 "workspace": {"min": [-0.6, -0.6, -0.6], "max": [1.4, 0.6, 0.9]}}
JSON

for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done
look() { [ -z "${GLISSADE_STEP_PICTURES:-}" ] || import -window root "$GLISSADE_STEP_PICTURES/step-$1.png"; }
keys() { xdotool key --delay 60 "$@"; sleep 0.5; }
# hold KEY SECONDS
hold() { xdotool keydown "$1"; sleep "$2"; xdotool keyup "$1"; }
# comes TEXT TIMES: Ctrl+S until the scenario's file has this text; false after so many times.
comes() {
  for _ in $(seq "$2"); do
    keys ctrl+s
    grep -q "$1" "$scenario" 2>/dev/null && return
    sleep 0.5
  done
  return 1
}
# saved TEXT: the same, and a failure where it does not come.
saved() {
  comes "$1" 60 && return
  look failed
  fail "the scenario has no $1"
}
# lead: leads the cube out, from wherever it is in the channel. True as soon as the step has its motion.
lead() {
  for leg in d w d s d; do
    hold "$leg" 8
    look "$leg"
    comes '"motions"' 1 && return
  done
  comes '"motions"' 20
}

"$glissade" "$scenario" --size 1270x710 >"$log" 2>&1 &
window=$!
for _ in $(seq 300); do xdotool search --onlyvisible --name ' — Glissade$' >/dev/null 2>&1 && break; sleep 0.1; done
id=$(xdotool search --onlyvisible --name ' — Glissade$' | tail -n 1)
[ -n "$id" ] || fail "the window does not come"
xdotool windowfocus --sync "$id" 2>/dev/null

keys ctrl+j
saved '"end": "stuck"'
look stuck
keys alt+9 Home ctrl+alt+m
sleep 2
look by-hand
keys ctrl+2 F5
sleep 3
look searching
# On a busy machine the hand comes less far in the same time: F12 takes it to where the search is stuck.
for _ in 1 2 3; do
  lead && break
  keys F12 ctrl+2
  sleep 6
  look taken
done
saved '"motions"'
saved '"end": "complete"'
look complete
grep -q 'by hand' "$scenario" || fail "the motion of the step is not the hand's"
keys ctrl+q
for _ in $(seq 100); do kill -0 "$window" 2>/dev/null || break; sleep 0.1; done
kill -0 "$window" 2>/dev/null && fail "Ctrl+Q does not quit: something is not saved"
"$cli" info "$scenario" >/dev/null || fail "the scenario that was saved is not read"
echo "passed"
