#!/usr/bin/env bash
# Measures Glissade beside its peers, all in one run on this machine, and writes one page of results:
# OUT/benchmarks.html. Leave the machine alone meanwhile. Takes hours; --quick, some minutes. What OUT holds
# of a study already is gone on with.
# With --products, the STEP files and scenarios of a folder are taken apart as others do it, too: OUT/six_axes.md.
# usage: packaging/benchmarks.sh OUT [--quick] [--jobs N] [--products FOLDER]
set -euo pipefail
caller=$PWD
cd "$(dirname "$0")/.."

usage() {
  echo "usage: packaging/benchmarks.sh OUT [--quick] [--jobs N] [--products FOLDER]" >&2
  exit 2
}
out='' quick='' jobs=1 products=''
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=--quick ;;
    --jobs) [ $# -ge 2 ] || usage; jobs=$2; shift ;;
    --products) [ $# -ge 2 ] || usage; products=$(cd "$caller" && realpath -- "$2"); shift ;;
    -*) usage ;;
    *) [ -z "$out" ] || usage; out=$1 ;;
  esac
  shift
done
[ -n "$out" ] || usage
case "$out" in /*) ;; *) out=$caller/$out ;; esac

programs=(collision nearest_neighbours octree growth)
studies=(automatic public-problems made-problems)

packaging/setup.sh build run test bench
# shellcheck disable=SC2086
packaging/build.sh release glissade-cli glissade-import "${programs[@]/%/_benchmark}" six_axes_comparison generate-made-problems work_ratchet -- -DGLISSADE_BENCHMARKS=ON

mkdir -p "$out"
: >"$out/commands.txt"
commit=$(git describe --always --dirty 2>/dev/null || echo unknown)

# measure COMMAND...: carries it out, and notes it for the page.
measure() {
  local line=$*
  echo "${line//"$out"/OUT}" >>"$out/commands.txt"
  echo "$line"
  "build/release/bin/$1" "${@:2}"
}

for program in "${programs[@]}"; do
  options=("--benchmark_out=$out/$program.json" --benchmark_out_format=json "--benchmark_context=commit=$commit")
  if [ -n "$quick" ]; then
    options+=(--benchmark_min_time=0.02)
    case "$program" in
      growth|nearest_neighbours) options+=('--benchmark_filter=/(100|1000|10000)(/|$)') ;;
    esac
  fi
  measure "${program}_benchmark" "${options[@]}"
done

# The work of more problems, seeds and products than the tests count, beside what the project has recorded of them.
ratchet=tests/ratchet
seeds=3
[ -z "$quick" ] || seeds=1
echo "work_ratchet cases.txt, benchmark_cases.txt >OUT/work.txt" | tee -a "$out/commands.txt"
build/release/bin/work_ratchet $ratchet/cases.txt $ratchet/work.csv build/release/bin samples \
  build/release/tests/step_files/files build/release/$ratchet/made ../shared/problems/omplapp \
  build/release/tests/ratchet/libglissade_heap_count.so --more $ratchet/benchmark_cases.txt \
  --seeds "$seeds" >"$out/work.txt" || cat "$out/work.txt"

if [ -n "$products" ]; then
  mapfile -t files < <(find "$products" -maxdepth 1 \( -name '*.st*p' -o -name '*.json' \) | sort)
  echo "six_axes_comparison FOLDER/* >OUT/six_axes.md" | tee -a "$out/commands.txt"
  build/release/bin/six_axes_comparison "${files[@]}" >"$out/six_axes.md"
fi

build/release/bin/generate-made-problems build/made-problems
for study in "${studies[@]}"; do
  if [ "$study" = public-problems ] && [ ! -d ../shared/problems/omplapp ]; then
    echo "public-problems: left out, ../shared/problems/omplapp is not there" | tee -a "$out/commands.txt"
    continue
  fi
  # shellcheck disable=SC2086
  measure glissade-cli study "samples/studies/$study.json" --out "$out/$study" --jobs "$jobs" $quick
done

echo "glissade-cli benchmark-page OUT" >>"$out/commands.txt"
build/release/bin/glissade-cli benchmark-page "$out"
