#include "app/window/hand_hint.h"

#include "widgets/devices/frame_name.h"

namespace glissade {

HandHint::HandHint(const Workbench& bench) : bench_(bench), hint_(new SceneHint(bench.scene.widget())) {
  bench.actions["layer.keys"]->setChecked(true);
  connect(&bench.run, &ShownRun::changed, this, &HandHint::write);
  connect(bench.actions["layer.keys"], &QAction::toggled, this, &HandHint::write);
  connect(bench.actions["operator.camera"], &QAction::toggled, this, &HandHint::write);
  connect(bench.actions["operator.frame"], &QAction::changed, this, &HandHint::write);
}

void HandHint::ask(const QString& text) {
  asked_ = text;
  write();
}

/// Most snapshots leave it as it is.
void HandHint::write() {
  QStringList lines;
  if (!asked_.isEmpty()) lines << asked_;
  if (const QString line = keys(); !line.isEmpty()) lines << line;
  const QString text = lines.join(QLatin1Char('\n'));
  if (text == shown_) return;
  shown_ = text;
  hint_->write(text);
}

QString HandHint::keys() const {
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  const std::string& device = bench_.session.deviceId();
  const bool byKeys = device == "hand" || device == "keyboard";
  if (!snapshot || !bench_.run.isLive() || !isRunning(*snapshot) || !byKeys) return {};
  if (!bench_.actions["layer.keys"]->isChecked()) return {};
  const auto key = [this](const char* id) {
    return bench_.actions[QLatin1String(id)]->shortcut().toString(QKeySequence::NativeText);
  };
  const MotionFrame frame = bench_.session.hand()->keyboard.shaping.get().frame;
  const QString keys = tr("A D W S Q E: move · J L I K U O: turn · Shift: slow · F: %1 · %2: camera · %3: help");
  return keys.arg(frameName(frame), key("operator.camera"), key("assist.go"));
}

}  // namespace glissade
