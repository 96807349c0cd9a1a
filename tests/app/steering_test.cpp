#include "app/window/keyboard_steering.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace glissade {
namespace {

class Steering : public testing::Test {
 protected:
  Steering() { view.installEventFilter(&steering); }

  void send(QEvent::Type type, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, bool repeat = false) {
    QKeyEvent event(type, key, modifiers, QString(), repeat);
    QApplication::sendEvent(&view, &event);
  }
  void loseFocus() {
    QFocusEvent event(QEvent::FocusOut);
    QApplication::sendEvent(&view, &event);
  }

  QWidget view;
  DeflectionMailbox keys;
  KeyboardSteering steering{keys, nullptr};
};

TEST_F(Steering, EveryAxisHasAKeyEachWay) {
  Eigen::Matrix<double, 6, 1> seen = Eigen::Matrix<double, 6, 1>::Zero();
  for (const int key : {Qt::Key_A, Qt::Key_D, Qt::Key_S, Qt::Key_W, Qt::Key_Q, Qt::Key_E, Qt::Key_I, Qt::Key_K,
                        Qt::Key_J, Qt::Key_L, Qt::Key_U, Qt::Key_O}) {
    send(QEvent::KeyPress, key);
    const Deflection deflection = keys.get();
    seen.head<3>() += deflection.translation.cwiseAbs();
    seen.tail<3>() += deflection.rotation.cwiseAbs();
    send(QEvent::KeyRelease, key);
    EXPECT_TRUE(keys.get().atRest());
  }
  EXPECT_EQ(seen, (Eigen::Matrix<double, 6, 1>::Constant(2.0)));
}

TEST_F(Steering, KeysAddUpAndShiftIsSlow) {
  send(QEvent::KeyPress, Qt::Key_D);
  send(QEvent::KeyPress, Qt::Key_W, Qt::ShiftModifier);
  EXPECT_EQ(keys.get().translation, Vector3(0.25, 0.25, 0));
}

TEST_F(Steering, LosingTheFocusIsRest) {
  send(QEvent::KeyPress, Qt::Key_D);
  loseFocus();
  EXPECT_TRUE(keys.get().atRest());
}

TEST_F(Steering, AutoRepeatIsNoReleaseAndShortcutsPassThrough) {
  send(QEvent::KeyPress, Qt::Key_D);
  send(QEvent::KeyRelease, Qt::Key_D, Qt::NoModifier, true);
  EXPECT_FALSE(keys.get().atRest());
  send(QEvent::KeyRelease, Qt::Key_D);
  send(QEvent::KeyPress, Qt::Key_O, Qt::ControlModifier);
  EXPECT_TRUE(keys.get().atRest());
}

}  // namespace
}  // namespace glissade
