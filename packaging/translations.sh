#!/usr/bin/env bash
# Takes the texts of the sources into resources/i18n/glissade_fr.ts, the catalogue. New texts are unfinished there.
# Texts of GLISSADE_TEXT, which the engine, the command line and the window make, have the one context "Messages", so
# that each is translated once, whatever class makes it. Texts of tr() have the contexts of Qt.
# usage: packaging/translations.sh [FILE.ts]
set -euo pipefail
cd "$(dirname "$0")/.."

ts=$(realpath "${1:-resources/i18n/glissade_fr.ts}")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
find engine app widgets -name '*.cpp' -o -name '*.h' | tar -c -T - | tar -x -C "$copy"
# lupdate takes the separators of digits for quotes.
find "$copy" -type f -exec sed -i -e 's/\bGLISSADE_TEXT(/QT_TRANSLATE_NOOP("Messages", /g' -e "s/\([0-9]\)'\([0-9]\)/\1\2/g" {} +
cd "$copy"
lupdate -silent -no-obsolete -locations none -I . app widgets engine -ts "$ts"
