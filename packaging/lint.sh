#!/usr/bin/env bash
# Checks the style of the C++ sources: clang-format for the layout, clang-tidy for suspicious code.
# usage: packaging/lint.sh --format        layout of all files: some seconds. The test Style.Format.
#        packaging/lint.sh [--since REV [--at-most N]]
#                                          layout of all files, clang-tidy of the files changed since REV
#                                          (default: HEAD, that is what is not committed); of more than N changed
#                                          files, N are chosen, others in each revision
#        packaging/lint.sh --all           layout of all files, clang-tidy of all files
# JOBS: how many files at once (default: the number of cores).
set -uo pipefail
cd "$(dirname "$0")/.."

folders=(engine widgets app tests samples)
jobs=${JOBS:-$(nproc)}
build=build/lint

require() {
  command -v "$1" >/dev/null && return
  echo "lint.sh: $1 is not installed. Run packaging/setup.sh test." >&2
  exit 1
}

check_format() {
  require clang-format
  local found
  found=$(find "${folders[@]}" -name '*.h' -o -name '*.cpp' | wc -l)
  if [ "$found" -eq 0 ]; then
    echo "lint.sh: there are no sources in ${folders[*]}" >&2
    return 1
  fi
  if ! find "${folders[@]}" \( -name '*.h' -o -name '*.cpp' \) -print0 |
       xargs -0 -P "$jobs" -n 50 clang-format --dry-run -Werror; then
    echo "lint.sh: the layout of the files named above differs from .clang-format. Run clang-format -i on them." >&2
    return 1
  fi
  echo "clang-format: $found files are clean"
}

# Writes the compile database. clang-tidy cannot read GCC's precompiled headers, so this build has none.
configure() {
  mkdir -p build
  if ! cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGLISSADE_TESTS=ON -DGLISSADE_BENCHMARKS=ON \
       -DGLISSADE_PRECOMPILE=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$build.log" 2>&1; then
    tail -n 20 "$build.log" >&2
    return 1
  fi
}

# Prints the sources that are compiled, relative to the project.
compiled_sources() {
  sed -n "s|^ *\"file\": \"$PWD/\(.*\.cpp\)\".*|\1|p" "$build/compile_commands.json" | grep -v '^build/' | sort -u
}

# Prints the compiled sources that show what has changed since the revision $1: the changed sources, and of each
# changed header its own source or, where it has none, one source that includes it.
changed_sources() {
  local file
  { git diff --name-only --diff-filter=d "$1" -- "${folders[@]}"; git ls-files --others --exclude-standard -- "${folders[@]}"; } |
  while read -r file; do
    case "$file" in
      *.cpp) echo "$file" ;;
      *.h) if [ -f "${file%.h}.cpp" ]; then echo "${file%.h}.cpp"; else
             grep -rlF --include='*.cpp' "#include \"$file\"" "${folders[@]}" | sort | head -n 1
           fi ;;
    esac
  done | sort -u | comm -12 - <(compiled_sources)
}

# Runs clang-tidy on the sources that standard input names.
check_tidy() {
  local files
  mapfile -t files
  if [ "${#files[@]}" -eq 0 ]; then
    echo "clang-tidy: no file has changed"
    return 0
  fi
  # Warnings that only GCC knows are in the compile commands.
  if ! printf '%s\0' "${files[@]}" | xargs -0 -P "$jobs" -n 1 clang-tidy --quiet -p "$build" \
       >"$build-tidy.log" 2>"$build-tidy.err"; then
    grep -E 'error:|warning:' "$build-tidy.log" | sort -u
    echo "lint.sh: clang-tidy has findings in ${#files[@]} files, listed above (details: $build-tidy.log)" >&2
    return 1
  fi
  echo "clang-tidy: ${#files[@]} files are clean"
}

# Of more than $1 lines of standard input, prints $1; which ones, depends on the revision.
choose() {
  local lines
  mapfile -t lines
  if [ "${#lines[@]}" -gt "$1" ]; then
    echo "clang-tidy: $1 of ${#lines[@]} changed files" >&2
    printf '%s\n' "${lines[@]}" | shuf --random-source=<(git rev-parse HEAD | sed 'h;G;G;G;G;G;G;G;G;G;G;G;G;G;G;G') -n "$1"
  elif [ "${#lines[@]}" -gt 0 ]; then
    printf '%s\n' "${lines[@]}"
  fi
}

usage() {
  sed -n '3,9s/^# //p' "$0" >&2
  exit 2
}

mode=${1:---since}
case "$mode" in
  --format|--all) [ $# -eq 1 ] ;;
  --since) [ $# -eq 0 ] || [ $# -eq 2 ] || { [ $# -eq 4 ] && [ "$3" = --at-most ] && [ "$4" -gt 0 ]; } ;;
  *) false ;;
esac || usage
check_format || exit 1
[ "$mode" != --format ] || exit 0
require clang-tidy
configure || exit 1
if [ "$mode" = --all ]; then
  compiled_sources | check_tidy
else
  revision=${2:-HEAD}
  git rev-parse --verify --quiet "$revision^{commit}" >/dev/null || { echo "lint.sh: there is no revision '$revision'" >&2; exit 2; }
  changed_sources "$revision" | choose "${4:-100000}" | check_tidy
fi
