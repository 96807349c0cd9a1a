#!/usr/bin/env bash
# Makes the Debian package build/release/glissade_*.deb.
# usage: packaging/package.sh
set -euo pipefail
cd "$(dirname "$0")/.."

packaging/setup.sh build run package
packaging/build.sh release -- -DGLISSADE_TESTS=OFF
cmake --build build/release --target glissade_man_pages >>build/release.log 2>&1
(cd build/release && cpack -G DEB >cpack.log 2>&1) || { tail -n 20 build/release/cpack.log >&2; exit 1; }
lintian --fail-on error build/release/glissade_*.deb || exit 1
ls build/release/glissade_*.deb
