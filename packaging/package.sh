#!/usr/bin/env bash
# Makes the Debian packages glissade, libglissade0, libglissade-dev and python3-glissade in build/release.
# usage: packaging/package.sh
set -euo pipefail
cd "$(dirname "$0")/.."

packaging/setup.sh build run package
packaging/build.sh release -- -DGLISSADE_TESTS=OFF
cmake --build build/release --target glissade_man_pages >>build/release.log 2>&1
(cd build/release && cpack -G DEB >cpack.log 2>&1) || { tail -n 20 build/release/cpack.log >&2; exit 1; }

# CPack adds scripts that call ldconfig, which the package's trigger does.
version=$(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")/\1/p' build/release/CPackConfig.cmake)
package=$(ls build/release/libglissade0_"$version"_*.deb)
content=$(mktemp -d)
trap 'rm -rf "$content"' EXIT
dpkg-deb -R "$package" "$content"
rm -f "$content"/DEBIAN/{postinst,postrm}
dpkg-deb --root-owner-group -b "$content" "$package" >/dev/null

lintian --fail-on error,warning build/release/*_"$version"_*.deb || exit 1
ls build/release/*_"$version"_*.deb
