#!/usr/bin/env bash
# Carries out the scripts that build, in several orders, with a CMake that only notes its options: each script states all
# that it needs, whatever another one left in the build folder.
# usage: build_options_test.sh SOURCE_FOLDER
set -uo pipefail
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tree/build" "$work/bin"
cp -r "$source/packaging" "$work/tree/"
# Notes which packages a script asks for; none is installed.
printf '#!/bin/sh\necho " $* " >"$PACKAGES"\n' >"$work/tree/packaging/setup.sh"
# Keeps the options in a file as CMake keeps them in its cache; the programs themselves are not made.
cat >"$work/bin/cmake" <<'CMAKE'
#!/usr/bin/env bash
[ "$1" = --preset ] || exit 0
for option in "$@"; do
  case "$option" in -DGLISSADE_*) sed -i "/^${option%%=*}=/d" "$CACHE"; echo "$option" >>"$CACHE" ;; esac
done
CMAKE
chmod +x "$work/bin/cmake" "$work/tree/packaging/setup.sh"
export PATH=$work/bin:$PATH CACHE=$work/cache PACKAGES=$work/packages

failed=0
# expect SCRIPT OPTION=VALUE: the script was the last one that ran.
expect() {
  grep -qx -- "-D$2" "$CACHE" && return
  echo "after $1, $2 is not what CMake was told:"
  cat "$CACHE"
  failed=1
}
# installs SCRIPT USE: the script that ran last has asked for the packages of this use.
installs() {
  grep -q " $2 " "$PACKAGES" && return
  echo "$1 does not install the packages of '$2':"
  cat "$PACKAGES"
  failed=1
}
run() { (cd "$work/tree" && "packaging/$1" "${@:2}" >/dev/null 2>&1 </dev/null); }

for before in run.sh package.sh benchmarks.sh; do
  : >"$CACHE"
  run "$before" out
  run benchmarks.sh out --quick
  expect "$before and benchmarks.sh" GLISSADE_TESTS=ON
  expect "$before and benchmarks.sh" GLISSADE_BENCHMARKS=ON
  for use in build run test bench; do installs benchmarks.sh "$use"; done
  run run.sh
  expect "$before and run.sh" GLISSADE_TESTS=OFF
  expect "$before and run.sh" GLISSADE_BENCHMARKS=OFF
  run build.sh release
  expect "$before and build.sh" GLISSADE_TESTS=ON
done
exit "$failed"
