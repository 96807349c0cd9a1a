#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests; needs no display. The last line has the totals.
# usage: packaging/test.sh [--all]
# --all: checks the sources with clang-tidy, and runs what reads files and what runs in threads under sanitizers, too.
set -uo pipefail
cd "$(dirname "$0")/.."

case "$*" in
  '') all= ;;
  --all) all=yes ;;
  *) sed -n '/^# usage/,/^# --all/s/^# //p' "$0" >&2; exit 2 ;;
esac
packaging/setup.sh build run test || exit 1

# The compiler cache stays where the user has it.
export CCACHE_DIR=${CCACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/ccache}
# Nothing of a test may depend on, or write into, the home of whoever runs it.
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/runtime"
export HOME=$home XDG_RUNTIME_DIR=$home/runtime XDG_CONFIG_HOME=$home/config XDG_CACHE_HOME=$home/cache
# Pictures are drawn in software. Their shaders are compiled once for all tests, which takes half of a test's time.
export MESA_SHADER_CACHE_DIR=$home/shaders QT_FONT_DPI=96 LC_ALL=C.UTF-8
export LSAN_OPTIONS=suppressions=$PWD/packaging/leaks.txt:print_suppressions=0
unset DISPLAY WAYLAND_DISPLAY
# A language with a decimal comma, which the C library would follow.
mkdir "$home/locale"
localedef -i fr_FR -f UTF-8 "$home/locale/fr_FR.UTF-8"
export LOCPATH=$home/locale

passed=0
failed=0
skipped=0

# output_of_failed LOG: what the tests that failed printed, at most 200 lines.
output_of_failed() {
  awk '/^ *[0-9]+\/[0-9]+ Test +#/ { show = /\*\*\*/ && !/\*\*\*Skipped/ } /^ *Start +[0-9]+:/ { next } show' "$1" |
    cut -c1-300 | tail -n 200
}

# run_suite PRESET CTEST_OPTION...: runs the tests of a build and adds to the totals.
run_suite() {
  local preset=$1
  shift
  local report=$PWD/build/$preset-tests.xml
  rm -f "$report"
  # One more than there are cores, because some tests wait.
  ctest --test-dir "build/$preset" --output-on-failure --output-junit "$report" -j "$(($(nproc) + 1))" "$@" \
    >"build/$preset-tests.log" 2>&1
  grep -E '\*\*\*|^[0-9]+% tests passed' "build/$preset-tests.log"
  if [ ! -s "$report" ]; then
    echo "$preset: the tests did not run (build/$preset-tests.log)"
    failed=$((failed + 1))
    return
  fi
  local attribute total bad idle
  attribute() { sed -n "s/.*<testsuite[^>]*[[:space:]]$1=\"\([0-9]*\)\".*/\1/p;s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$report" | head -n 1; }
  total=$(attribute tests)
  bad=$(attribute failures)
  idle=$(($(attribute skipped) + $(attribute disabled)))
  # A program whose tests run in one process is one CTest.
  total=$((total + $(grep -o 'Running [0-9]* tests from' "$report" | awk '{ more += $2 - 1 } END { print more + 0 }')))
  passed=$((passed + total - bad - idle))
  failed=$((failed + bad))
  skipped=$((skipped + idle))
  [ "$bad" -eq 0 ] || output_of_failed "build/$preset-tests.log"
}

# build_and_run PRESET "TARGETS" CTEST_OPTION...
build_and_run() {
  local preset=$1 targets=$2 begun=$SECONDS built
  shift 2
  # shellcheck disable=SC2086
  if packaging/build.sh "$preset" $targets; then
    built=$SECONDS
    run_suite "$preset" "$@"
    echo "$preset: built in $((built - begun)) s, tested in $((SECONDS - built)) s"
  else
    failed=$((failed + 1))
  fi
}

build_and_run release ""
if [ -n "$all" ]; then
  # The layout of the sources is a test of the release build.
  if packaging/lint.sh --unrecorded; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
  build_and_run asan "import_test files_test mutate_readers api_test" -L 'import|scenario|fuzz|api'
  # The contact of the haptic loop is computed by one thread: the thread sanitizer has nothing to look for there.
  build_and_run tsan "session_test operator_test haptic_test slots_test" -L 'session|operator|slots' -E '^HapticContact'
fi

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
