#!/usr/bin/env bash
# Installs the library into a folder, builds a program outside of the tree with it, and runs the program: by CMake, by
# pkg-config, and for the processor of this machine. Meanwhile the checkout and its build folder cannot be seen.
# usage: library_test.sh SOURCE_FOLDER BUILD_FOLDER
set -euo pipefail
source=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

for component in libglissade0 libglissade-dev python3-glissade; do
  cmake --install "$build" --prefix "$prefix" --component "$component" >"$work/install.log" ||
    { cat "$work/install.log"; exit 1; }
done
cp -r "$source/tests/installed/program" "$source/samples/environment-1" "$source/samples/bolted-brackets" "$work"
cp "$source/samples/python/take_apart.py" "$source/samples/python/own_sampler.py" "$work/program"
libraries=$(dirname "$(find "$prefix" -name libglissade.so)")
cd "$work"

# without_checkout COMMAND...: an empty folder is mounted over the checkout, in a namespace of the command's own.
without_checkout() {
  # shellcheck disable=SC2016
  unshare -rm bash -c 'mount -t tmpfs none "$0" || exit 1; mount -t tmpfs none "$1" 2>/dev/null; shift; exec "$@"' \
    "$source" "$build" "$@"
}
if ! without_checkout true 2>/dev/null; then
  echo "namespaces are not allowed here: the checkout can be seen"
  without_checkout() { "$@"; }
elif without_checkout test -e "$source/CMakeLists.txt" -o -e "$build/CMakeCache.txt"; then
  echo "the checkout can be seen"
  exit 1
fi

# The library shows the public names only.
others=$(nm -DC --defined-only "$libraries/libglissade.so" | cut -d' ' -f3- |
         grep -vE '^((typeinfo|typeinfo name|vtable) for )?glissade::api::|^GLISSADE_0$' || true)
[ -z "$others" ] || { echo "names that are not public:"; echo "$others"; exit 1; }

# runs PROGRAM: it must plan, check, take a product apart and use a planner of its own.
runs() {
  local expected="path valid 1
removed 9 of 9
own planner certified 1"
  local said
  said=$(LD_LIBRARY_PATH=$libraries without_checkout "$1" "$work/environment-1/scenario.json" \
    "$work/bolted-brackets/scenario.json")
  [ "$(head -n 3 <<<"$said")" = "$expected" ] || { echo "$1 said:"; echo "$said"; exit 1; }
}

# runs_with_programs_in FOLDER PROGRAM: the importers are those of the folder.
runs_with_programs_in() {
  GLISSADE_PROGRAMS=$1 LD_LIBRARY_PATH=$libraries without_checkout "$2" "$work/environment-1/scenario.json" \
    "$work/bolted-brackets/scenario.json" >/dev/null 2>&1
}

without_checkout cmake -S "$work/program" -B "$work/by-cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$work/cmake.log" ||
  { cat "$work/cmake.log"; exit 1; }
without_checkout cmake --build "$work/by-cmake" >"$work/build.log" 2>&1 || { cat "$work/build.log"; exit 1; }
runs "$work/by-cmake/program"
LD_LIBRARY_PATH=$libraries without_checkout "$work/by-cmake/with_ompl" | grep -q '^path of OMPL valid 1' ||
  { echo "OMPL found no path that the judge calls valid"; exit 1; }
runs_with_programs_in "$prefix/libexec/glissade" "$work/by-cmake/program" || { echo "importers are not taken from a named folder"; exit 1; }
! runs_with_programs_in "$work" "$work/by-cmake/program" || { echo "the named folder of importers does not count"; exit 1; }

flags=$(PKG_CONFIG_PATH=$libraries/pkgconfig pkg-config --cflags --libs glissade)
# shellcheck disable=SC2086
without_checkout "${CXX:-g++}" -std=c++20 -O1 -march=native "$work/program/main.cpp" -o "$work/by-pkg-config" $flags
runs "$work/by-pkg-config"

# The Python package finds the library and its importers from where they were installed.
if [ -d "$prefix/lib/python3" ]; then
  by_python() {
    LD_LIBRARY_PATH=$libraries PYTHONPATH=$prefix/lib/python3/dist-packages without_checkout /usr/bin/python3 "$@"
  }
  by_python program/take_apart.py | tail -n 2 | grep -q '^valid: 5 of 5 steps' ||
    { echo "the Python package took nothing apart"; exit 1; }
  by_python program/own_sampler.py | grep -q '^judge: valid' || { echo "a sampler in Python found no path"; exit 1; }
fi
