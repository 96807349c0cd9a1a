#!/usr/bin/env bash
# Installs the build into an empty folder, does the main job and takes a picture there, and compares what was installed
# with the list that CMake keeps: nothing else may be left when those files are removed.
# usage: install_test.sh BUILD_FOLDER CMAKE
set -euo pipefail
build=$1
cmake=$2
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT

"$cmake" --install "$build" --prefix "$root/usr" >/dev/null
bin=$root/usr/bin
samples=$root/usr/share/glissade/samples
cd "$root"
"$bin/glissade-cli" --version
"$bin/glissade-cli" plan "$samples/sliding-plane/scenario.json" --operator expert --seed 1 --out "$root/path.csv"
"$bin/glissade-cli" check "$samples/sliding-plane/scenario.json" "$root/path.csv"
# The importer of meshes is found from the link.
"$bin/glissade-cli" info "$samples/pump/unmount.json" >/dev/null
if [ -e "$bin/glissade" ]; then
  QT_QPA_PLATFORM=offscreen "$bin/glissade" --offscreen "$samples/sliding-plane/scenario.json" --screenshot "$root/window.png"
  test -s "$root/window.png"
  for page in en/index fr/index en/parameters fr/panels; do
    test -s "$root/usr/share/doc/glissade/manual/$page.html"
  done
  test -s "$root/usr/share/doc/glissade/manual/pictures/environment-1-solved.png"
  # The samples of the welcome page are found.
  echo "open-sample teaching/scenario.json" >"$root/sample.script"
  QT_QPA_PLATFORM=offscreen "$bin/glissade" --offscreen --script "$root/sample.script"
  rm "$root/sample.script"
  for file in applications/glissade.desktop mime/packages/glissade.xml icons/hicolor/scalable/apps/glissade.svg; do
    test -s "$root/usr/share/$file"
  done
fi
rm "$root/path.csv" "$root/window.png" 2>/dev/null || true
while read -r file || [ -n "$file" ]; do rm "$file"; done <"$build/install_manifest.txt"
left=$(find "$root" -type f -o -type l)
test -z "$left" || { echo "left behind: $left"; exit 1; }
