#!/usr/bin/env bash
# Takes the film of the front page, resources/film/roller-stand.webp: the roller stand is taken apart in the window. Build
# before. Needs img2webp of the Debian package webp.
# usage: packaging/film.sh [BUILD_FOLDER]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
bin=${1:-$root/build/release}/bin
frames=50
command -v img2webp >/dev/null || { echo "film.sh: img2webp is missing: apt-get install webp" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

{
  echo 'plan-sequence all'
  for frame in $(seq 0 "$frames"); do
    LC_ALL=C printf 'seek-sequence %.3f\nscreenshot %s/%03d.png\n' "$(awk "BEGIN { print $frame / $frames }")" "$work" "$frame"
  done
} >"$work/film.script"
"$bin/glissade-offscreen" "$root/samples/roller-stand/scenario.json" --theme light --size 1120x630 \
  --script "$work/film.script"
mkdir -p "$root/resources/film"
img2webp -loop 0 -lossy -q 55 -m 6 -d 160 "$work"/*.png -o "$root/resources/film/roller-stand.webp"
