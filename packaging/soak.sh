#!/usr/bin/env bash
# Works with the program for some time and measures whether its memory grows.
# usage: packaging/soak.sh [--minutes N] [--seed S]      (default: 20 minutes, seed 1)
# Two soaks run at the same time: the window offscreen by a script (open, plan, stop, edit, undo, plan again, replay,
# export, save, open the copy), and sessions with their threads. Each writes a line a cycle: seconds, resident
# megabytes, resident megabytes after free memory was given back to the system. The slope is a least-squares line
# through the last column over the second half. Prints a row of packaging/RELIABILITY.md for each soak:
#   name | tried (cycles) | clean | defects | seconds | peak MB | seed
# Fails above 1 MB/h, or where a soak ends with an error.
set -uo pipefail
cd "$(dirname "$0")/.."

minutes=20
seed=1
while [ $# -gt 0 ]; do
  case "$1" in
    --minutes) minutes=$2; shift 2 ;;
    --seed) seed=$2; shift 2 ;;
    *) sed -n '3p' "$0" >&2; exit 2 ;;
  esac
done
programs=build/release/bin
for program in glissade-offscreen session_soak; do
  [ -x "$programs/$program" ] || packaging/build.sh release "$program" -- -DGLISSADE_TESTS=ON || exit 1
done

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -m 700 "$folder/runtime"
export HOME=$folder XDG_RUNTIME_DIR=$folder/runtime XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache
export MESA_SHADER_CACHE_DISABLE=true LC_ALL=C.UTF-8

# write_cycle SAMPLE STRATEGY EDIT SEED
write_cycle() {
  cat <<END
open $PWD/samples/$1/scenario.json
select-strategy $2
action run.start
steps 5
action run.stop
place $3 5,0,0 0,0,0
action edit.undo
action edit.redo
action edit.undo
action run.start
wait ended 1000000
screenshot $folder/picture.png
save-recording $folder/run.json
action replay.last
seek 100
action replay.close
save $folder/copy.json
open $folder/copy.json
action run.start
steps 5
action run.stop
memory $folder/window.txt
END
}

# Enough cycles for any number of minutes: the program is ended when time is over.
write_script() {
  local cycle
  for cycle in $(seq 1 $((minutes * 120))); do
    case $((cycle % 3)) in
      0) write_cycle environment-1 auto environment ;;
      1) write_cycle sliding-plane auto wall ;;
      2) write_cycle teaching gts O1 ;;
    esac
  done
}

seconds=$((minutes * 60))
write_script >"$folder/window.script"
timeout --preserve-status --signal=KILL "$seconds" \
  "$programs/glissade-offscreen" --script "$folder/window.script" --seed "$seed" 2>"$folder/window.err" &
window=$!
"$programs/session_soak" "$seconds" "$seed" "$folder/session.txt" 2>"$folder/session.err"
session_status=$?
wait "$window"
window_status=$?
[ "$window_status" -ne 137 ] || window_status=0  # ended because time was over

# report NAME FILE STATUS: prints the row and the slope; fails where the soak has not kept what it must.
report() {
  awk -v name="$1" -v status="$3" -v seed="$seed" '
    { t[NR] = $1; resident[NR] = $2; trimmed[NR] = $3; if ($2 > peak) peak = $2 }
    END {
      for (i = int(NR / 2) + 1; i <= NR; i++) { n++; st += t[i]; sy += trimmed[i] }
      if (n > 1) {
        mt = st / n; my = sy / n
        for (i = int(NR / 2) + 1; i <= NR; i++) { a += (t[i] - mt) * (trimmed[i] - my); b += (t[i] - mt) ^ 2 }
      }
      enough = n > 4 && b > 0
      slope = enough ? 3600 * a / b : 0
      defects = (status != 0 || !enough || slope > 1) ? 1 : 0
      printf "%s | %d | %d | %d | %.0f | %.0f | %s\n", name, NR, NR - (status != 0), defects, t[NR], peak, seed
      printf "%s: slope %.2f MB/h, resident %.1f to %.1f MB, after trimming %.1f to %.1f MB\n", name, slope,
        resident[int(NR / 2) + 1], resident[NR], trimmed[int(NR / 2) + 1], trimmed[NR]
      if (!enough) printf "%s: too few cycles for a slope\n", name
      exit defects
    }' "$2"
}

failed=0
for soak in window session; do
  status=${soak}_status
  touch "$folder/$soak.txt"
  report "soak-$soak" "$folder/$soak.txt" "${!status}" || { failed=1; tail -n 3 "$folder/$soak.err"; }
  [ -z "${SOAK_KEEP:-}" ] || cp "$folder/$soak.txt" "$SOAK_KEEP"
done
exit "$failed"
