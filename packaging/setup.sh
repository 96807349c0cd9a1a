#!/usr/bin/env bash
# Installs what is missing of packaging/packages.txt, saying what and why.
# usage: packaging/setup.sh [build] [run] [test]
set -euo pipefail
cd "$(dirname "$0")/.."

wanted=" ${*:-build run} "
missing=()
while read -r use package why; do
  case "$use" in ''|'#'*) continue ;; esac
  case "$wanted" in *" $use "*) ;; *) continue ;; esac
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed'; then
    missing+=("$package")
    printf 'will install %-26s %s\n' "$package" "($why)"
  fi
done < packaging/packages.txt
[ "${#missing[@]}" -gt 0 ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=()
elif command -v sudo >/dev/null; then
  as_root=(sudo)
else
  echo "setup.sh: these packages need root, and there is no sudo. Install them as root and run again:" >&2
  echo "  apt-get install ${missing[*]}" >&2
  exit 1
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
echo "installing ${#missing[@]} packages (this may take some minutes)"
if ! { "${as_root[@]}" apt-get update &&
       "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
         apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
  tail -n 30 "$log" >&2
  echo "setup.sh: apt-get failed; the last lines of what it said are above" >&2
  exit 1
fi
