#!/usr/bin/env bash
# Takes the small pictures of the welcome page: each sample that widgets/files/sample_scenarios.cpp lists, on a light and on
# a dark ground. Build before, and again afterwards: the pictures are resources of the programs.
# usage: packaging/sample-pictures.sh [BUILD_FOLDER]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
bin=${1:-$root/build/release}/bin
pictures=$root/resources/welcome
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

{
  echo '<!DOCTYPE RCC>'
  echo '<RCC version="1.0">'
  echo '  <qresource prefix="/welcome">'
} >"$pictures/welcome.qrc"
for sample in $(grep -o '{"[a-z0-9-]*/[a-z0-9-]*\.json"' "$root/widgets/files/sample_scenarios.cpp" | tr -d '{"'); do
  name=${sample//\//-}
  for theme in light dark; do
    picture=${name%.json}-$theme.png
    echo "scene-screenshot $pictures/$picture" >"$work/picture.script"
    "$bin/glissade-offscreen" "$root/samples/$sample" --theme $theme --size 1440x600 --script "$work/picture.script"
    echo "    <file>$picture</file>" >>"$pictures/welcome.qrc"
  done
done
{
  echo '  </qresource>'
  echo '</RCC>'
} >>"$pictures/welcome.qrc"
