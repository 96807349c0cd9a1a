#include "widgets/devices/keyboard_steering.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace glissade {
namespace {

class Steering : public testing::Test {
 protected:
  Steering() {
    keys.connect("Keyboard");
    view.installEventFilter(&steering);
  }

  void send(QEvent::Type type, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, bool repeat = false) {
    QKeyEvent event(type, key, modifiers, QString(), repeat);
    QApplication::sendEvent(&view, &event);
  }
  void loseFocus() {
    QFocusEvent event(QEvent::FocusOut);
    QApplication::sendEvent(&view, &event);
  }

  QWidget view;
  RawAxes axes() const { return keys.reading().axes; }
  bool atRest() const { return keys.reading().atRest(); }

  InputMailbox keys;
  QAction otherAxes{nullptr};
  KeyboardSteering steering{keys, &otherAxes, nullptr};
};

TEST_F(Steering, EveryAxisHasAKeyEachWay) {
  RawAxes seen{};
  for (const int key : {Qt::Key_A, Qt::Key_D, Qt::Key_S, Qt::Key_W, Qt::Key_Q, Qt::Key_E, Qt::Key_I, Qt::Key_K,
                        Qt::Key_J, Qt::Key_L, Qt::Key_U, Qt::Key_O}) {
    send(QEvent::KeyPress, key);
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] += std::abs(axes()[i]);
    send(QEvent::KeyRelease, key);
    EXPECT_TRUE(atRest());
  }
  EXPECT_EQ(seen, (RawAxes{2, 2, 2, 2, 2, 2}));
}

TEST_F(Steering, KeysAddUpAndShiftIsSlow) {
  send(QEvent::KeyPress, Qt::Key_D);
  send(QEvent::KeyPress, Qt::Key_W, Qt::ShiftModifier);
  EXPECT_EQ(axes(), (RawAxes{0.25, 0.25, 0, 0, 0, 0}));
}

TEST_F(Steering, LosingTheFocusIsRest) {
  send(QEvent::KeyPress, Qt::Key_D);
  loseFocus();
  EXPECT_TRUE(atRest());
}

TEST_F(Steering, FChoosesOtherAxesOncePerPress) {
  int asked = 0;
  QObject::connect(&otherAxes, &QAction::triggered, &view, [&asked] { ++asked; });
  send(QEvent::KeyPress, Qt::Key_F);
  send(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier, true);
  send(QEvent::KeyRelease, Qt::Key_F);
  EXPECT_EQ(asked, 1);
  send(QEvent::KeyPress, Qt::Key_F, Qt::ControlModifier);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(atRest());
}

TEST_F(Steering, AutoRepeatIsNoReleaseAndShortcutsPassThrough) {
  send(QEvent::KeyPress, Qt::Key_D);
  send(QEvent::KeyRelease, Qt::Key_D, Qt::NoModifier, true);
  EXPECT_FALSE(atRest());
  send(QEvent::KeyRelease, Qt::Key_D);
  send(QEvent::KeyPress, Qt::Key_O, Qt::ControlModifier);
  EXPECT_TRUE(atRest());
}

}  // namespace
}  // namespace glissade
