#!/usr/bin/env bash
# Runs everything that attacks Glissade, and writes what it came to as a table: packaging/RELIABILITY.md.
# Takes hours; --quick, some minutes. A campaign that cannot run is named as not run.
# usage: packaging/reliability.sh [--quick] [--seed N] [--out FILE] [--work DIR] [--no-build]
# --work keeps the rows of each campaign in DIR; campaigns that have rows there are not run again.
# --no-build runs what is built already, and names the rest as not run.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2

usage() {
  sed -n 's/^# usage: /usage: /p' "$0" >&2
  exit 2
}
quick='' seed=1 out=packaging/RELIABILITY.md build=yes work=''
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=--quick ;;
    --no-build) build='' ;;
    --seed) [ $# -ge 2 ] || usage; seed=$2; shift ;;
    --out) [ $# -ge 2 ] || usage; out=$2; shift ;;
    --work) [ $# -ge 2 ] || usage; work=$2; shift ;;
    *) usage ;;
  esac
  shift
done

if [ -n "$quick" ]; then
  variants=20 truncations=20 paths=300 mutations=2000 fuzz_seconds=10 kills=100 soak_minutes=1
else
  variants=200 truncations=100 paths=10000 mutations=100000 fuzz_seconds=600 kills=1000 soak_minutes=20
fi

programs=build/release/bin
if [ -z "$work" ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
mkdir -p "$work"
export LC_ALL=C.UTF-8

# rows_of WHAT: the file of a campaign's rows.
rows_of() { echo "$work/${1// /-}.rows"; }
order=()

# begin WHAT: notes the place of the campaign in the table; false where it has rows already.
begin() {
  order+=("$(rows_of "$1")")
  rm -f "$(rows_of "$1").missing"
  [ ! -s "$(rows_of "$1")" ] && echo "$1"
}
not_run() { echo "$1 | not run: $2 | | | | | " >"$(rows_of "$1").missing"; }

# run_rows WHAT COMMAND...: collects the rows "name | tried | clean | defects | seconds | peak MB | seed" that a
# campaign prints. Findings are on its standard error.
run_rows() {
  local what=$1
  shift
  "$@" >"$work/output" 2>"$work/errors"
  grep -aE '^[^|]+( \| [^|]+){6}$' "$work/output" >"$(rows_of "$what")"
  grep -aE 'DEFECT|PENETRATES|REFUSED|good file' "$work/errors" | head -n 20
  if [ ! -s "$(rows_of "$what")" ]; then
    tail -n 5 "$work/errors"
    not_run "$what" "no rows were printed"
  fi
}

# run_program WHAT PROGRAM ARGUMENT...: where it is built.
run_program() {
  local what=$1 program=$2
  begin "$what" || return
  if [ -x "$program" ]; then run_rows "$@"; else not_run "$what" "$program is missing"; fi
}

# run_tests WHAT PROGRAM FILTER: a row of GoogleTest's totals.
run_tests() {
  local what=$1 program=$2 filter=$3
  begin "$what" || return
  [ -x "$program" ] || { not_run "$what" "$program is missing"; return; }
  "$program" --gtest_filter="$filter" >"$work/output" 2>&1
  local passed failed milliseconds
  passed=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) test.*/\1/p' "$work/output")
  failed=$(grep -c '^\[  FAILED  \].*ms)$' "$work/output")
  milliseconds=$(sed -n 's/^\[==========\] .* ran. (\([0-9]*\) ms total)$/\1/p' "$work/output")
  if [ -z "$milliseconds" ]; then
    not_run "$what" "the program ended early"
  else
    echo "$what (tests) | $((passed + failed)) | $passed | $failed | $((milliseconds / 1000)) | - | -" >"$(rows_of "$what")"
  fi
}

build_release() {
  packaging/setup.sh build run test && packaging/build.sh release -- -DGLISSADE_TESTS=ON
}
[ -z "$build" ] || build_release || exit 1

run_program "malformed files" "$programs/malformed_campaign" "$programs/glissade-cli" "$work/malformed" \
  build/release/tests/step_files/files "$seed" "$variants" "$truncations"
run_program "certified paths" "$programs/path_oracle" campaign "$programs/path_maker" "$work/paths" "$seed" "$paths"
run_tests "system calls of importers" "$programs/confinement_test" 'SystemCalls.*:Confinement.*'
export GLISSADE_SAVE_KILLS=$kills GLISSADE_SAVE_SEED=$seed
run_program "kills and failed system calls of saves" "$programs/save_reliability_test"
if [ -d tests/fuzz ]; then
  [ -z "$build" ] || packaging/build.sh asan mutate_readers -- -DGLISSADE_TESTS=ON
  run_program "mutations in memory" build/asan/bin/mutate_readers tests/fuzz/corpus --mutations "$mutations" --seed "$seed"
fi
if [ -n "$build" ]; then
  run_program "fuzzers" packaging/fuzz.sh --seconds "$fuzz_seconds" --seed "$seed"
  run_program "soak" packaging/soak.sh --minutes "$soak_minutes" --seed "$seed"
else
  begin "fuzzers" && not_run "fuzzers" "they build what they need"
  begin "soak" && not_run "soak" "it builds what it needs"
fi

for rows in "${order[@]}"; do
  if [ -s "$rows" ]; then cat "$rows"; else cat "$rows.missing"; fi
done >"$work/table"

{
  echo "# Reliability"
  echo
  echo "\`packaging/reliability.sh${quick:+ $quick}\` wrote this table on $(date -u +%F) for commit" \
    "$(git rev-parse --short HEAD 2>/dev/null || echo unknown)."
  echo "A row is one campaign. A defect is a crash, a signal, exit code 70, a hang, memory over the limit, a refusal"
  echo "without a message, triangles that are missing without a warning, a certified path that penetrates, or a file that"
  echo "a save loses. Seconds are summed over the processes of a campaign; MB are the largest of one process."
  echo "What the campaigns do is in \`tests/oracle\`, \`tests/reliability\` and the scripts beside this file."
  echo
  echo "| what | tried | clean | defects | seconds | peak MB | seed |"
  echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"
  sed 's/^/| /; s/$/ |/' "$work/table"
} >"$out"
echo "wrote $out"
awk -F' [|] ' '$4 + 0 > 0 { bad = 1 } END { exit bad }' "$work/table"
