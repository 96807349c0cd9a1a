#!/usr/bin/env bash
# Runs everything that attacks Glissade, and writes the results as a table. packaging/RELIABILITY.md is a summary of them.
# Takes hours; --quick, some minutes. Rows are kept in build/reliability/COMMIT and not run again for that commit, so
# that the command can be interrupted, and rows can be run one by one. The table names rows that were not run.
# usage: packaging/reliability.sh [--quick] [--seed N] [--fuzz-seconds N] [--only PATTERN] [--out FILE] [--work DIR]
#        [--no-build] [--list]
# --fuzz-seconds  libFuzzer runs so long on each target (600)
# --only    runs the campaigns whose names hold the PATTERN (a regular expression), and writes the table with all rows
# --work    keeps the rows in another folder
# --no-build runs what is built already (release, asan, fuzz)
# --list    prints the names of the campaigns
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2

usage() {
  sed -n '/^# usage: /,/^#  /s/^# //p' "$0" >&2
  exit 2
}
quick='' seed=1 fuzz_seconds='' out=build/reliability/table.md build=yes work='' only='' list=''
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=--quick ;;
    --no-build) build='' ;;
    --list) list=yes ;;
    --seed) [ $# -ge 2 ] || usage; seed=$2; shift ;;
    --fuzz-seconds) [ $# -ge 2 ] || usage; fuzz_seconds=$2; shift ;;
    --only) [ $# -ge 2 ] || usage; only=$2; shift ;;
    --out) [ $# -ge 2 ] || usage; out=$2; shift ;;
    --work) [ $# -ge 2 ] || usage; work=$2; shift ;;
    *) usage ;;
  esac
  shift
done

if [ -n "$quick" ]; then
  variants=20 truncations=20 paths=300 mutations=2000 default_fuzz_seconds=10 kills=100 sessions=100 soak_minutes=1 trapped=60 mutants=400 shape_mutants=100
else
  variants=200 truncations=1000000 paths=10000 mutations=80000 default_fuzz_seconds=600 kills=1000 sessions=1000 soak_minutes=20 trapped=1000 mutants=10000 shape_mutants=500
fi
: "${fuzz_seconds:=$default_fuzz_seconds}"

# The commit that is tried; with what was changed since.
commit=$(git rev-parse --short HEAD 2>/dev/null || echo unknown)
[ -z "$(git status --porcelain 2>/dev/null)" ] || commit=$commit-changed
[ -n "$work" ] || work=$PWD/build/reliability/$commit$quick
mkdir -p "$work" "$(dirname "$out")"
export LC_ALL=C.UTF-8

release=build/release/bin
formats="stl-text stl-binary obj ply ply-binary dae glb gltf urdf step-box step-plate step-split iges brep scenario semantics
  product cfg study path-csv path-json path-path assembly-plan record journal"
# The messages of the STEP importer are written by the build.
targets="$(ls tests/fuzz/corpus) step-protocol"

no_build=''
[ -n "$build" ] || no_build=--no-build

rows_of() { echo "$work/${1// /-}.rows"; }
order=()

# campaign NAME NEEDED COMMAND...: collects the rows "name | tried | clean | defects | seconds | peak MB | seed" that
# the command prints on its standard output. NEEDED is a program that has to be there, or "-". Findings are on the
# standard error; both are kept beside the rows.
campaign() {
  local name=$1 needed=$2
  shift 2
  order+=("$name")
  if [ -n "$list" ]; then echo "$name"; return; fi
  local rows
  rows=$(rows_of "$name")
  [ ! -s "$rows" ] || return
  [[ "$name" =~ $only ]] || return
  if [ "$needed" != - ] && [ ! -x "$needed" ]; then
    echo "$needed is missing" >"$rows.missing"
    return
  fi
  echo "$(date +%T) $name"
  "$@" >"$rows.output" 2>"$rows.errors"
  grep -aE '^[^|]+( \| [^|]+){6}$' "$rows.output" >"$rows"
  grep -aE 'DEFECT|PENETRATES|REFUSED|good file|is a defect' "$rows.errors" | head -n 20
  if [ -s "$rows" ]; then
    rm -f "$rows.missing"
  else
    tail -n 5 "$rows.errors"
    echo "no rows were printed" >"$rows.missing"
  fi
}

# tests NAME PROGRAM FILTER: a row of GoogleTest's totals.
tests() {
  local output passed failed milliseconds
  output=$("$2" --gtest_filter="$3" 2>&1)
  passed=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) test.*/\1/p' <<<"$output")
  failed=$(grep -c '^\[  FAILED  \].*ms)$' <<<"$output")
  milliseconds=$(sed -n 's/^\[==========\] .* ran. (\([0-9]*\) ms total)$/\1/p' <<<"$output")
  [ -n "$milliseconds" ] || { tail -n 5 <<<"$output" >&2; return; }
  echo "$1 (tests) | $((passed + failed)) | $passed | $failed | $((milliseconds / 1000)) | - | -"
  sed -n 's/^ROW //p' <<<"$output"  # what a test has counted
}

words() {
  export GLISSADE_WORD_SESSIONS=$sessions GLISSADE_WORD_SEED=$seed
  tests "words of a person in sessions" "$release/words_test" '*'
}

shape_mutants() {
  export GLISSADE_SHAPE_MUTANTS=$shape_mutants GLISSADE_SHAPE_SEED=$seed
  tests "bodies that go from STEP files" "$release/import_test" 'StepShapeMutants.*'
}

forbidden_samples() {
  export GLISSADE_FORBIDDEN=all
  tests "forbidden places of samples" "$release/forbidden_samples_test" '*'
}

forbidden_directions() {
  export GLISSADE_FORBIDDEN=all
  tests "forbidden directions" "$release/check_test" 'HullClearance.*:KeptDirections.*'
}

saves() { GLISSADE_SAVE_KILLS=$kills GLISSADE_SAVE_SEED=$seed "$release/save_reliability_test"; }

if [ -n "$build" ] && [ -z "$list" ]; then
  packaging/setup.sh build run test && packaging/build.sh release || exit 1
  packaging/build.sh release session_soak || exit 1
  [[ "mutations truncations" =~ $only ]] && { packaging/build.sh asan mutate_readers || exit 1; }
fi

for format in $formats; do
  campaign "malformed $format" "$release/malformed_campaign" "$release/malformed_campaign" "$release/glissade-cli" \
    "$work/malformed/$format" build/release/tests/step_files/files "$seed" "$variants" "$truncations" "$format"
done
for target in $targets; do
  campaign "every truncation in memory $target" build/asan/bin/mutate_readers \
    build/asan/bin/mutate_readers build/asan/tests/fuzz/corpus --target "$target" --inputs truncations
done
for target in $targets; do
  campaign "mutations in memory $target" build/asan/bin/mutate_readers \
    build/asan/bin/mutate_readers build/asan/tests/fuzz/corpus --target "$target" --mutations "$mutations" --seed "$seed"
done
for target in $targets; do
  campaign "libFuzzer $target" - packaging/fuzz.sh $no_build --seconds "$fuzz_seconds" --seed "$seed" "$target"
done
campaign "certified paths" "$release/path_oracle" \
  "$release/path_oracle" campaign "$release/path_maker" "$work/paths" "$seed" "$paths"
campaign "trapped parts" "$release/check_attack" \
  "$release/check_attack" trapped "$release/glissade-cli" "$work/trapped" "$seed" "$trapped"
campaign "trapped parts that have lost faces" "$release/check_attack" \
  "$release/check_attack" open "$release/glissade-cli" "$work/open" "$seed" "$((trapped / 4))"
campaign "overlaps" "$release/check_attack" \
  "$release/check_attack" overlaps "$release/glissade-cli" "$work/overlaps" "$seed" "$trapped"
campaign "mutated paths and plans" "$release/check_attack" \
  "$release/check_attack" mutants "$release/glissade-cli" "$work/mutants" "$seed" "$mutants"
campaign "plans with words of their own" "$release/check_attack" \
  "$release/check_attack" words "$release/glissade-cli" "$work/plan-words" build/release/tests/step_files/files/fits.step \
  "$seed" "$mutants"
campaign "bodies that go from STEP files" "$release/import_test" shape_mutants
campaign "system calls of importers" "$release/confinement_test" \
  tests "system calls of importers" "$release/confinement_test" 'SystemCalls.*:Confinement.*'
campaign "exceptions in the window" "$release/window_exceptions_test" \
  tests "exceptions in the window" "$release/window_exceptions_test" '*'
campaign "exceptions in sessions" "$release/session_exceptions_test" \
  tests "exceptions in sessions" "$release/session_exceptions_test" '*'
campaign "kills and failed system calls of saves" "$release/save_reliability_test" saves
campaign "words of a person in sessions" "$release/words_test" words
campaign "forbidden places in every strategy" "$release/forbidden_places_test" \
  tests "forbidden places in every strategy" "$release/forbidden_places_test" '*'
campaign "forbidden places of samples" "$release/forbidden_samples_test" forbidden_samples
campaign "forbidden directions" "$release/check_test" forbidden_directions
campaign "soak" "$release/session_soak" packaging/soak.sh --minutes "$soak_minutes" --seed "$seed"
[ -z "$list" ] || exit 0

table() {
  for name in "${order[@]}"; do
    local rows
    rows=$(rows_of "$name")
    if [ -s "$rows" ]; then
      cat "$rows"
    else
      echo "$name | not run: $(cat "$rows.missing" 2>/dev/null || echo 'left out by --only') | | | | | "
    fi
  done
}

{
  echo "# Reliability"
  echo
  echo "\`packaging/reliability.sh${quick:+ $quick}\` wrote this table on $(date -u +%F) for commit $commit."
  echo "A row is one campaign. A defect is a crash, a signal, exit code 70, a hang, memory over the limit, a refusal"
  echo "without a message, triangles or bodies that are missing without a warning, a certified path that penetrates, a false path or"
  echo "plan that is called valid, a plan that is called valid by its own words, a refusal that names nothing, or a file that a save loses. Seconds are summed over the processes of a campaign; MB are the largest of one process."
  echo "*Malformed* are seeded changes of a sound file, *truncated* are all of its beginnings; both are given to"
  echo "\`glissade-cli\`. *In memory* means: to the reader itself, built with the address sanitizer."
  echo "What the campaigns do is in \`tests/oracle\`, \`tests/reliability\`, \`tests/fuzz\` and the scripts in \`packaging\`."
  echo
  echo "| what | tried | clean | defects | seconds | peak MB | seed |"
  echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"
  table | sed 's/^/| /; s/$/ |/'
} >"$out"
echo "wrote $out"
table | awk -F' [|] ' '$4 + 0 > 0 || $2 ~ /^not run/ { bad = 1 } END { exit bad }'
