#!/usr/bin/env bash
# Installs what is missing, builds, and opens the workbench on environment 1. Without a display it
# does the main job instead: plans with the simulated operator, writes path and picture.
# usage: packaging/run.sh [SCENARIO]
set -euo pipefail
caller=$PWD
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

packaging/setup.sh build run
packaging/build.sh release -- -DGLISSADE_TESTS=OFF
bin=$root/build/release/bin
case "${1:-}" in
  "") scenario=$root/samples/environment-1/scenario.json ;;
  /*) scenario=$1 ;;
  *) scenario=$caller/$1 ;;
esac

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$bin/glissade" "$scenario"
fi

echo "no display: planning without a window"
mkdir -p out
status=0
"$bin/glissade-cli" plan "$scenario" --operator expert --seed 1 --max-steps 24000 --out out/path.csv || status=$?
if [ "$status" -eq 0 ]; then
  "$bin/glissade-cli" check "$scenario" out/path.csv
fi
cat > out/picture.script <<SCRIPT
select-operator expert
action run.start
wait ended 24000
screenshot $root/out/window.png
SCRIPT
"$bin/glissade" --offscreen "$scenario" --size 1280x720 --script out/picture.script
echo
[ "$status" -eq 0 ] && echo "certified path:          $root/out/path.csv"
echo "picture of the window:   $root/out/window.png"
exit "$status"
