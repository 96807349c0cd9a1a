#!/usr/bin/env bash
# Configures and builds one preset, quietly: the log is shown only when something fails. An option that is not given has
# its default, whatever an earlier call left in the build folder.
# usage: packaging/build.sh PRESET [TARGET...] [-- CMAKE_OPTION...]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
targets=()
while [ $# -gt 0 ] && [ "$1" != "--" ]; do
  targets+=(--target "$1")
  shift
done
[ $# -eq 0 ] || shift

log=build/$preset.log
mkdir -p build
echo "building $preset (log: $log)"
defaults=(-DGLISSADE_UNITY=ON -DGLISSADE_PRECOMPILE=ON -DGLISSADE_TESTS=ON -DGLISSADE_BENCHMARKS=OFF)
if ! { cmake --preset "$preset" "${defaults[@]}" "$@" &&
       cmake --build "build/$preset" "${targets[@]}"; } >"$log" 2>&1; then
  grep -nE 'error|CMake Error|FAILED' "$log" | head -n 20 >&2 || true
  tail -n 30 "$log" >&2
  echo "build.sh: the build of $preset failed; its log is $log" >&2
  exit 1
fi
