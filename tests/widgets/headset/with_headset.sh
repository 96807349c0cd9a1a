#!/usr/bin/env bash
# Runs a test program on a virtual display with the runtime for tests, optionally under a layer of OpenXR that checks
# its calls. LEAKS, if set: the leak sanitizer's library, which checks for memory that is left at the end. KEPT: a
# library that keeps others loaded. FILTER: an option of the test that selects cases.
# usage: with_headset.sh PROGRAM RUNTIME_MANIFEST [LAYER]
set -u
program=$1
manifest=$2
layer=${3:-}
if [ -n "$layer" ] && ! grep -qrs "\"$layer\"" /usr/share/openxr/1/api_layers /etc/openxr/1/api_layers; then
  echo "skipped: OpenXR's layer $layer is not installed (openxr-layer-corevalidation)"
  exit 77
fi
TOOLS=
. "${BASH_SOURCE%/*}/../../app/xvfb_display.sh"
for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done
export XR_RUNTIME_JSON=$manifest
[ -z "$layer" ] || export XR_ENABLE_API_LAYERS=$layer
leaks=${LEAKS:-}
if [ -n "$leaks" ]; then
  [ -e "$leaks" ] || { echo "skipped: there is no leak sanitizer ($leaks)"; exit 77; }
  leaks="LD_PRELOAD=$leaks $KEPT"
fi
env ${leaks:+"$leaks"} "$program" ${FILTER:+"$FILTER"} >"$work/glissade.log" 2>&1 || fail "$program"
if [ -n "$layer" ]; then
  grep -q '^Core Validation output' "$work/glissade.log" || fail "the layer has not run"
  ! grep -q 'VALID_ERROR\|VALID_WARNING' "$work/glissade.log" || fail "the layer has found errors"
fi
grep -v '^Core Validation output' "$work/glissade.log"
