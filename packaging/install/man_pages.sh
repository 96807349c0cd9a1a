#!/usr/bin/env bash
# Writes a manual page for each program, and for each command of a program that has commands.
# usage: man_pages.sh FOLDER VERSION PROGRAM...
set -euo pipefail
folder=$1
version=$2
shift 2
rm -rf "$folder"
mkdir -p "$folder"

# write_page NAME PURPOSE COMMAND_LINE
write_page() {
  # A page has the name of its file, as whatis expects.
  help2man --no-info --version-string="$version" --name "$2" "$3" |
    sed -E "s/^\\.TH [^\"]+/.TH ${1^^} /; /^\\.SH NAME/{n;s/^.* \\\\-/$1 \\\\-/}" | gzip -9n >"$folder/$1.1.gz"
}

# commands_of PROGRAM: a line "NAME PURPOSE" for each.
commands_of() {
  "$1" --help | awk '/^Subcommands:/ { inside = 1; next } inside && NF { sub(/^ +/, ""); print }'
}

for program in "$@"; do
  name=$(basename "$program")
  purpose=$("$program" --help | sed -n 's/^Glissade: //p' | head -n 1)
  write_page "$name" "$purpose" "$program"
  commands_of "$program" | while read -r command purpose; do
    write_page "$name-$command" "$purpose" "$program $command"
  done
done
