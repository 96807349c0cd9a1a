#!/usr/bin/env bash
# Works with the program for some time and measures whether its memory grows.
# usage: packaging/soak.sh [--minutes N] [--seed S]      (default: 20 minutes, seed 1)
# Two soaks run at the same time: the window offscreen by a script (open, plan, stop, edit, undo, plan again, replay,
# export, save, open the copy), and sessions with their threads. Each writes a line a cycle: seconds, resident
# megabytes, resident megabytes after free memory was given back to the system, megabytes that are allocated. Slopes
# are least-squares lines through the last two columns over the second half (means of cycles that come again). Prints a row of the table of packaging/reliability.sh for each soak:
#   name | tried (cycles) | clean | defects | seconds | peak MB | seed
# The slope of resident memory has a standard error near 1 MB/h in 20 minutes, since pages come and go; that of the
# memory that is allocated is exact. Fails where allocated memory grows by more than 1 MB/h, where resident memory does
# so by more than twice the standard error, or where a soak ends with an error.
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
  [ -x "$programs/$program" ] || packaging/build.sh release "$program" || exit 1
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

# A cycle takes more than a second, and the program is ended when time is over. A script may have 1 MiB.
write_script() {
  local cycle cycles=$((minutes * 60))
  [ "$cycles" -le 1800 ] || cycles=1800
  for cycle in $(seq 1 "$cycles"); do
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

# report NAME FILE STATUS PERIOD: prints the row and the slopes; fails where the soak has not kept what it must.
# Cycles differ from each other and come again after PERIOD cycles: slopes are those of the means of whole periods.
report() {
  awk -v name="$1" -v status="$3" -v period="$4" -v seed="$seed" '
    {
      if ($2 > peak) peak = $2
      end = $1
      g = int((NR - 1) / period)
      t[g] += $1 / period; trimmed[g] += $3 / period; allocated[g] += $4 / period
    }
    END {
      groups = int(NR / period)
      first = int(groups / 2)
      for (g = first; g < groups; g++) { n++; st += t[g]; sy += trimmed[g]; sz += allocated[g] }
      for (g = first; g < groups; g++) {
        a += (t[g] - st / n) * (trimmed[g] - sy / n)
        c += (t[g] - st / n) * (allocated[g] - sz / n)
        b += (t[g] - st / n) ^ 2
      }
      enough = n > 4 && b > 0
      slope = enough ? 3600 * a / b : 0
      growth = enough ? 3600 * c / b : 0
      for (g = first; enough && g < groups; g++)
        scatter += (trimmed[g] - sy / n - slope / 3600 * (t[g] - st / n)) ^ 2
      uncertainty = enough ? 3600 * sqrt(scatter / (n - 2) / b) : 0
      defects = (status != 0 || !enough || growth > 1 || slope - 2 * uncertainty > 1) ? 1 : 0
      printf "%s, resident %+.2f (standard error %.2f) MB/h, allocated %+.2f MB/h | %d | %d | %d | %.0f | %.0f | %s\n",
        name, slope, uncertainty, growth, NR, NR - (status != 0), defects, end, peak, seed
      printf "%s: means of %d cycles in the second half: after trimming %.2f to %.2f MB, allocated %.2f to %.2f MB\n",
        name, period, trimmed[first], trimmed[groups - 1], allocated[first], allocated[groups - 1]
      if (!enough) printf "%s: too few cycles for a slope\n", name
      exit defects
    }' "$2"
}

failed=0
# The period is the number of scenarios that a soak takes turns with.
while read -r soak status period; do
  touch "$folder/$soak.txt"
  report "soak-$soak" "$folder/$soak.txt" "$status" "$period" || { failed=1; tail -n 3 "$folder/$soak.err"; }
  [ -z "${SOAK_KEEP:-}" ] || cp "$folder/$soak.txt" "$SOAK_KEEP"
done <<END
window $window_status 3
session $session_status 4
END
exit "$failed"
