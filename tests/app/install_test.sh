#!/usr/bin/env bash
# Installs the build into an empty folder, by `cmake --install` and by the Debian package. Does the main job and takes a
# picture there. Removes what was installed: nothing else may be left.
# usage: install_test.sh BUILD_FOLDER CMAKE
set -euo pipefail
build=$1
cmake=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# main_job PREFIX: what a person does first with the programs that are installed there.
main_job() {
  local bin=$1/bin share=$1/share out=$work/out
  local samples=$share/glissade/samples
  mkdir "$out"
  "$bin/glissade-cli" --version
  "$bin/glissade-cli" plan "$samples/sliding-plane/scenario.json" --operator expert --seed 1 --out "$out/path.csv"
  "$bin/glissade-cli" check "$samples/sliding-plane/scenario.json" "$out/path.csv"
  # The importer of meshes is found from the link.
  "$bin/glissade-cli" info "$samples/pump/unmount.json" >/dev/null
  [ ! -e "$bin/glissade" ] || window_job "$1" "$out"
  rm -r "$out"
}

# window_job PREFIX OUT
window_job() {
  local bin=$1/bin share=$1/share out=$2
  export QT_QPA_PLATFORM=offscreen
  "$bin/glissade" --offscreen "$share/glissade/samples/sliding-plane/scenario.json" --screenshot "$out/window.png"
  test -s "$out/window.png"
  for page in en/index fr/index en/parameters fr/panels; do
    test -s "$share/doc/glissade/manual/$page.html"
  done
  test -s "$share/doc/glissade/manual/pictures/environment-1-solved.png"
  # The samples of the welcome page are found.
  echo "open-sample teaching/scenario.json" >"$out/sample.script"
  "$bin/glissade" --offscreen --script "$out/sample.script"
  for file in applications/glissade.desktop mime/packages/glissade.xml icons/hicolor/scalable/apps/glissade.svg \
    thumbnailers/glissade.thumbnailer bash-completion/completions/glissade; do
    test -s "$share/$file"
  done
  make_thumbnail "$1" "$out"
}

# make_thumbnail PREFIX OUT: as a file manager does it, into a file without an ending.
make_thumbnail() {
  local command
  command=$(sed -n 's/^Exec=//p' "$1/share/thumbnailers/glissade.thumbnailer")
  command=${command//%o/$2/thumbnail}
  command=${command//%s/128}
  command=${command//%i/$1/share/glissade/samples/teaching/scenario.json}
  PATH=$1/bin:$PATH sh -c "$command"
  head -c 8 "$2/thumbnail" | grep -q PNG
}

# expect_empty FOLDER
expect_empty() {
  local left
  left=$(find "$1" -type f -o -type l)
  test -z "$left" || { echo "left behind: $left"; exit 1; }
}

root=$work/installed
"$cmake" --install "$build" --prefix "$root/usr" >/dev/null
main_job "$root/usr"
while read -r file || [ -n "$file" ]; do rm "$file"; done <"$build/install_manifest.txt"
expect_empty "$root"

# The package, in a root of its own with an empty list of packages. What it depends on is that of this machine.
(cd "$work" && "${cmake%cmake}cpack" --config "$build/CPackConfig.cmake" -G DEB -D CPACK_DEBIAN_PACKAGE_SHLIBDEPS=OFF \
  -D CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS=OFF \
  -D CPACK_PACKAGE_DIRECTORY="$work/package" >"$work/cpack.log") || { cat "$work/cpack.log"; exit 1; }
root=$work/root
mkdir -p "$root/var/lib/dpkg/"{info,updates}
touch "$root/var/lib/dpkg/status"
in_root() { dpkg --root="$root" --log="$work/dpkg.log" --force-not-root --force-depends "$@" >/dev/null 2>"$work/errors"; }
in_root --install "$work/package/"*.deb || { cat "$work/errors"; exit 1; }
main_job "$root/usr"
in_root --purge glissade libglissade0 libglissade-dev python3-glissade || { cat "$work/errors"; exit 1; }
rm -r "$root/var"
expect_empty "$root"
