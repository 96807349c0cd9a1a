#!/usr/bin/env bash
# Runs libFuzzer over the readers of all formats, one after another, and prints one row for each:
#   name | tried | clean | defects | seconds | peak MB | seed
# New inputs go to build/fuzz-corpus and are used again by the next run; inputs that are defects go to build/fuzz-defects.
# usage: packaging/fuzz.sh [--seconds N] [--seed N] [--no-build] [TARGET...]     (--seconds: of each target; 600)
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2

seconds=600
seed=1
build=yes
targets=()
while [ $# -gt 0 ]; do
  case "$1" in
    --seconds) seconds=$2; shift 2 ;;
    --seed) seed=$2; shift 2 ;;
    --no-build) build=''; shift ;;
    -*) sed -n '/^# usage/s/^# //p' "$0" >&2; exit 2 ;;
    *) targets+=("$1"); shift ;;
  esac
done
if [ -n "$build" ]; then
  packaging/setup.sh build test || exit 1
  packaging/build.sh fuzz fuzz_readers -- -DGLISSADE_PRECOMPILE=OFF || exit 1
fi
corpus=build/fuzz/tests/fuzz/corpus
[ "${#targets[@]}" -gt 0 ] || mapfile -t targets < <(find "$corpus" -mindepth 1 -maxdepth 1 -type d -printf '%f\n' | sort)
[ -x build/fuzz/bin/fuzz_readers ] || { echo "build/fuzz/bin/fuzz_readers is missing" >&2; exit 1; }

defective=0
for target in "${targets[@]}"; do
  found=build/fuzz-corpus/$target
  defects=build/fuzz-defects/$target
  log=build/fuzz-$target.log
  mkdir -p "$found" "$defects"
  before=$(find "$defects" -type f | wc -l)
  began=$(date +%s)
  tried=0
  peak=0
  # A defect ends libFuzzer: it is started anew until the time is over.
  while left=$((seconds - ($(date +%s) - began))) && [ "$left" -gt 0 ]; do
    GLISSADE_FUZZ_TARGET=$target ASAN_OPTIONS=detect_leaks=0 build/fuzz/bin/fuzz_readers \
      -seed="$seed" -max_total_time="$left" -max_len=65536 -timeout=10 -rss_limit_mb=2048 \
      -artifact_prefix="$defects/" -print_final_stats=1 "$found" "$corpus/$target" >"$log" 2>&1 && ended=1 || ended=0
    tried=$((tried + $(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1 || echo 0)))
    rss=$(sed -n 's/^stat::peak_rss_mb: *//p' "$log" | tail -n 1)
    [ "${rss:-0}" -le "$peak" ] || peak=$rss
    [ "$ended" -eq 0 ] || break
    if ! grep -q "^stat::" "$log"; then tail -n 5 "$log" >&2; break; fi
  done
  count=$(($(find "$defects" -type f | wc -l) - before))
  defective=$((defective + count))
  echo "libFuzzer on $target | $tried | $((tried - count)) | $count | $(($(date +%s) - began)) | $peak | $seed"
done
[ "$defective" -eq 0 ]
