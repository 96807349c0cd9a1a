#!/usr/bin/env bash
# Novices who follow the hints in the real window, with keys only (novice_test.cpp says how many).
# usage: xvfb_novice.sh NOVICE_TEST
set -u
SCREEN=1280x720
TOOLS=
. "${BASH_SOURCE%/*}/xvfb_display.sh"
for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done
"$1"
