#include "widgets/devices/keyboard_steering.h"

#include <QKeyEvent>

#include <array>

namespace glissade {
namespace {

constexpr double kSlow = 0.25;

/// The axis of the view that a key deflects: 0-2 translation x y z, 3-5 rotation x y z.
struct KeyAxis {
  int key;
  std::size_t axis;
  double direction;
};

constexpr std::array<KeyAxis, 12> kKeys{{{Qt::Key_A, 0, -1},
                                         {Qt::Key_D, 0, 1},
                                         {Qt::Key_S, 1, -1},
                                         {Qt::Key_W, 1, 1},
                                         {Qt::Key_Q, 2, -1},
                                         {Qt::Key_E, 2, 1},
                                         {Qt::Key_K, 3, 1},
                                         {Qt::Key_I, 3, -1},
                                         {Qt::Key_J, 4, -1},
                                         {Qt::Key_L, 4, 1},
                                         {Qt::Key_U, 5, 1},
                                         {Qt::Key_O, 5, -1}}};

bool steers(int key) {
  for (const KeyAxis& entry : kKeys) {
    if (entry.key == key) return true;
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
  return row(QStringLiteral("A  D"), tr("left, right")) + row(QStringLiteral("W  S"), tr("up, down")) +
         row(QStringLiteral("Q  E"), tr("away from you, towards you")) +
         row(QStringLiteral("J  L"), tr("turn left, turn right")) +
         row(QStringLiteral("I  K"), tr("tip back, tip forward")) +
         row(QStringLiteral("U  O"), tr("roll left, roll right")) + row(tr("Shift"), tr("a quarter of the speed")) +
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
  for (const KeyAxis& entry : kKeys) {
    if (pressed_.contains(entry.key)) axes[entry.axis] += entry.direction * (slow_ ? kSlow : 1.0);
  }
  keys_.setAxes(axes);
}

}  // namespace glissade
