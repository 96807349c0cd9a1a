#!/usr/bin/env bash
# Checks the style of the C++ sources: clang-format for the layout, clang-tidy for suspicious code.
# usage: packaging/lint.sh --format        layout of all files: some seconds. The test Style.Format.
#        packaging/lint.sh --since REV     layout of all files, clang-tidy of the files changed since REV
#        packaging/lint.sh --unrecorded    the same of the files whose code packaging/lint_clean.txt does not list, for at
#                                          most 15 minutes: the files that were not read then are counted
#        packaging/lint.sh --record        the same; if all are clean, writes packaging/lint_clean.txt anew
#        packaging/lint.sh --all           layout and clang-tidy of all files: more than an hour of the processor
# clang-tidy takes seconds for a file. So the digests of the code that it found clean are recorded, and files are checked
# when their code changes.
# JOBS: how many files at once (default: the number of cores).
set -uo pipefail
cd "$(dirname "$0")/.."

folders=(engine widgets app tests samples)
jobs=${JOBS:-$(nproc)}
patience=0  # seconds that clang-tidy reads; 0: until all files are read
build=build/lint
record=packaging/lint_clean.txt

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

# configure UNITY: writes the compile database. clang-tidy cannot read GCC's precompiled headers, so this build has none.
configure() {
  build=build/lint-$1
  mkdir -p build
  if ! cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGLISSADE_TESTS=ON -DGLISSADE_BENCHMARKS=ON \
       -DGLISSADE_PRECOMPILE=OFF -DGLISSADE_UNITY="$1" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$build.log" 2>&1; then
    tail -n 20 "$build.log" >&2
    return 1
  fi
}

# Prints the sources that are compiled, relative to the project.
compiled_sources() {
  sed -n "s|^ *\"file\": \"$PWD/\(.*\.cpp\)\".*|\1|p" "$build/compile_commands.json" | grep -v '^build/' | sort -u
}

# Reads names of changed files. Prints the compiled sources that show them: the changed sources, and of each changed
# header its own source or, where it has none, one source that includes it.
sources_showing() {
  local file
  while read -r file; do
    case "$file" in
      *.cpp) echo "$file" ;;
      *.h) if [ -f "${file%.h}.cpp" ]; then echo "${file%.h}.cpp"; else
             grep -rlF --include='*.cpp' "#include \"$file\"" "${folders[@]}" | sort | head -n 1
           fi ;;
    esac
  done | sort -u | comm -12 - <(compiled_sources)
}

changed_since() {
  git diff --name-only --diff-filter=d "$1" -- "${folders[@]}"
  git ls-files --others --exclude-standard -- "${folders[@]}"
}

# Prints a line for each file: the digest of its code and its name. Comments and white space do not count, except
# NOLINT. Other checks make other digests.
digests() {
  local checks code
  checks=$(sha256sum .clang-tidy | cut -c1-8)
  code=$(mktemp -d)
  find "${folders[@]}" -type d | sed "s|^|$code/|" | xargs mkdir -p
  # shellcheck disable=SC2016
  find "${folders[@]}" \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 awk -v folder="$code" '
    FNR == 1 { if (file) close(file); file = folder "/" FILENAME; printf "" >file }
    !/NOLINT/ { sub(/^[ \t]*\/\/.*$/, ""); sub(/  \/\/.*$/, "") }
    { gsub(/[ \t]/, ""); printf "%s", $0 >file }'
  (cd "$code" && find "${folders[@]}" -type f | LC_ALL=C sort | xargs sha256sum) |
    awk -v checks="$checks" '{ print checks substr($1, 1, 16), $2 }'
  rm -rf "$code"
}

unrecorded() { digests | LC_ALL=C sort | LC_ALL=C comm -23 - <(LC_ALL=C sort "$record" 2>/dev/null) | cut -d' ' -f2; }

# Runs clang-tidy on the sources that standard input names.
check_tidy() {
  local files
  mapfile -t files
  if [ "${#files[@]}" -eq 0 ]; then
    echo "clang-tidy: no compiled source shows what has changed"
    return 0
  fi
  local deadline=0
  [ "$patience" -eq 0 ] || deadline=$(($(date +%s) + patience))
  : >"$build-tidy.left"
  # Sources that are compiled together are included by one that CMake writes.
  # shellcheck disable=SC2016
  if ! printf '%s\0' "${files[@]}" | xargs -0 -P "$jobs" -n 1 bash -c '
         [ "$1" -eq 0 ] || [ "$(date +%s)" -lt "$1" ] || { echo "$4" >>"$2-tidy.left"; exit 0; }
         clang-tidy --quiet -p "$2" --checks=-bugprone-suspicious-include --header-filter="^$3/(engine|widgets|app|tests|samples)/" "$4"
       ' tidy "$deadline" "$build" "$PWD" >"$build-tidy.log" 2>"$build-tidy.err"; then
    grep -E 'error:|warning:' "$build-tidy.log" | sort -u
    echo "lint.sh: clang-tidy has the findings that are listed above, in ${#files[@]} files that it read ($build-tidy.log)" >&2
    return 1
  fi
  local left
  left=$(wc -l <"$build-tidy.left")
  if [ "$left" -gt 0 ]; then
    echo "clang-tidy: $((${#files[@]} - left)) files are clean; $left were not read, because the time was over ($build-tidy.left)"
    return 0
  fi
  echo "clang-tidy: ${#files[@]} files are clean"
}

# All sources, compiled together by folder: headers are read once for all sources of a folder.
check_all() {
  configure ON || return 1
  sed -n 's|^ *"file": "\(.*\)".*|\1|p' "$build/compile_commands.json" | grep -vE '_autogen/|\.qrc|qrc_' | sort -u | check_tidy
}

# Checks the files that standard input names; of many, all files are checked, which is quicker. Where the time is
# limited, files are read one by one.
check_changed() {
  local changed sources
  changed=$(cat)
  if [ -z "$changed" ]; then
    echo "clang-tidy: no file has changed"
    return 0
  fi
  configure OFF || return 1
  sources=$(sources_showing <<<"$changed")
  if [ "$patience" -eq 0 ] && [ "$(grep -c . <<<"$sources")" -gt 400 ]; then
    check_all
  else
    { grep . <<<"$sources" || true; } | check_tidy
  fi
}

usage() {
  sed -n '3,10s/^# //p' "$0" >&2
  exit 2
}

mode=${1:-}
case "$mode" in
  --format|--all|--unrecorded|--record) [ $# -eq 1 ] ;;
  --since) [ $# -eq 2 ] ;;
  *) false ;;
esac || usage
check_format || exit 1
[ "$mode" != --format ] || exit 0
require clang-tidy
case "$mode" in
  --all) check_all ;;
  --since)
    git rev-parse --verify --quiet "$2^{commit}" >/dev/null || { echo "lint.sh: there is no revision '$2'" >&2; exit 2; }
    changed_since "$2" | check_changed ;;
  --unrecorded)
    patience=900
    unrecorded | check_changed ;;
  # What is recorded is what was read: a file that changes meanwhile is checked the next time.
  --record) found=$(digests); unrecorded | check_changed && echo "$found" >"$record" ;;
esac
