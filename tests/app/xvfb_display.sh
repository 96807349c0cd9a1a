# Sourced by the tests of the real window: a virtual display and folders of its own. Sets work, window (the process to
# end), and defines fail. TOOLS are needed beside Xvfb and xdotool.
for tool in Xvfb xdotool $TOOLS; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
work=$(mktemp -d)
mkdir "$work/frame"
display=:$((90 + RANDOM % 900))
# Without -noreset it starts anew when a client was the last to leave, and refuses others for that moment.
Xvfb "$display" -screen 0 "${SCREEN:-1280x800}x24" -nolisten tcp -noreset -fbdir "$work/frame" >"$work/xvfb.log" 2>&1 &
server=$!
trap 'kill -9 $window 2>/dev/null; kill $server 2>/dev/null; rm -rf "$work"' EXIT
window=
# What the user has left, as a recording to be saved, stays out of it.
export XDG_CONFIG_HOME=$work/config XDG_DATA_HOME=$work/data XDG_RUNTIME_DIR=$work
export DISPLAY=$display QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 QT_FONT_DPI=96

fail() {
  echo "failed: $1"
  cat "$work/glissade.log"
  exit 1
}
