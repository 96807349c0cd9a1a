#include "widgets/devices/keyboard_steering.h"

#include <QKeyEvent>

#include "widgets/devices/steering_keys.h"

namespace glissade {
namespace {

constexpr double kSlow = 0.25;

bool steers(int key) {
  for (const SteeringKey& entry : steeringKeys()) {
    if (entry.letter == key) return true;
  }
  return false;
}

}  // namespace

KeyboardSteering::KeyboardSteering(InputMailbox& keys, QAction* otherAxes, QObject* parent)
    : QObject(parent), keys_(keys), otherAxes_(otherAxes) {}

QString KeyboardSteering::keyTable() {
  const auto row = [](const QString& keys, const QString& meaning) {
    return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>").arg(keys, meaning);
  };
  QString table;
  const auto& keys = steeringKeys();
  for (std::size_t i = 0; i < keys.size(); i += 2) {
    const QString pair = QStringLiteral("%1  %2").arg(QLatin1Char(keys[i].letter)).arg(QLatin1Char(keys[i + 1].letter));
    table += row(pair, motionText(keys[i]) + QStringLiteral(", ") + motionText(keys[i + 1]));
  }
  return table + row(tr("Shift"), tr("a quarter of the speed")) +
         row(QStringLiteral("F"), tr("axes of the view, of the world or of the object"));
}

bool KeyboardSteering::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) {
    pressed_.clear();
    publish();
    return false;
  }
  const bool press = event->type() == QEvent::KeyPress;
  if (!press && event->type() != QEvent::KeyRelease) return QObject::eventFilter(watched, event);
  const auto* keyEvent = static_cast<QKeyEvent*>(event);
  slow_ = keyEvent->modifiers().testFlag(Qt::ShiftModifier);
  const bool command = (keyEvent->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
  if (keyEvent->key() == Qt::Key_F && !command) {
    if (press && !keyEvent->isAutoRepeat() && otherAxes_ != nullptr) otherAxes_->trigger();
    return true;
  }
  if (!steers(keyEvent->key()) || command) {
    publish();
    return false;
  }
  if (!keyEvent->isAutoRepeat()) {
    if (press) {
      pressed_.insert(keyEvent->key());
    } else {
      pressed_.remove(keyEvent->key());
    }
    publish();
  }
  return true;
}

void KeyboardSteering::publish() {
  RawAxes axes{};
  for (const SteeringKey& entry : steeringKeys()) {
    if (pressed_.contains(entry.letter)) axes[entry.axis] += entry.direction * (slow_ ? kSlow : 1.0);
  }
  keys_.setAxes(axes);
}

}  // namespace glissade
