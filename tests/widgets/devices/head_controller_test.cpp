// A tracked head in the whole window, with a tracker that sends datagrams.
#include "widgets/devices/head_controller.h"

#include <QElapsedTimer>
#include <QThread>

#include <cmath>

#include "tests/app/whole_window.h"
#include "tests/widgets/devices/fake_head_tracker.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

class HeadControllerTest : public testing::Test {
 protected:
  HeadControllerTest()
      : window_([](QWidget*) { return std::make_unique<test::UnseenScene>(); }, SessionClock::RealTime) {
    window_.setBatch(true);
    EXPECT_EQ(window_.openScenario(test::WholeWindowTest::sample("teaching"), true), std::nullopt);
    window_.workbench().scene.widget()->resize(640, 480);
    HeadPreferences preferences;
    preferences.port = freePort();
    page();
    dialog().setPreferences(preferences);
    emit dialog().changed(preferences);
    dialog().hide();
  }

  static int freePort() {
    HeadReceiver receiver;
    EXPECT_TRUE(receiver.open(0, false));
    return receiver.port();
  }

  QAction& following() { return *window_.workbench().actions["operator.head"]; }
  void page() { window_.workbench().actions["operator.head-page"]->trigger(); }
  HeadDialog& dialog() { return *window_.findChild<HeadDialog*>(); }
  HeadController& head() { return *window_.findChild<HeadController*>(); }
  const CameraController& camera() { return window_.workbench().scene.view().camera(); }
  bool hasSign() { return !window_.findChild<QLabel*>(QStringLiteral("head-sign"))->isHidden(); }
  int activeTimers() {
    int active = 0;
    for (const QTimer* timer : window_.findChildren<QTimer*>()) active += timer->isActive() ? 1 : 0;
    return active;
  }

  template <class Happened>
  bool wait(Happened happened, int milliseconds = 10'000) {
    QElapsedTimer since;
    since.start();
    while (!happened() && since.elapsed() < milliseconds) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
      QThread::msleep(2);
    }
    return happened();
  }

  MainWindow window_;
};

TEST_F(HeadControllerTest, TheViewFollowsTheHeadAndGoesBackWhenDataStop) {
  const Vector3 usual = camera().eye();
  following().setChecked(true);
  ASSERT_TRUE(head().receiver().isOpen());
  const Vector3 atRest = camera().eye();
  const Vector3 right = camera().R_WV() * Vector3::UnitX();
  test::FakeHeadTracker tracker(head().receiver().port());
  const auto aside = [&] { return (camera().eye() - atRest).dot(right); };
  const double expected = 0.1 * camera().viewHeight() / window_.findChild<EyePlaceKeeper*>()->pictureSize().height();
  ASSERT_TRUE(wait([&] {
    tracker.send({10.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    return aside() > 0.95 * expected;
  })) << aside();
  EXPECT_LE(aside(), 1.001 * expected);
  EXPECT_FALSE(hasSign());
  EXPECT_TRUE(head().state().tracked);
  // The tracker is silent: the sign appears, and the view goes back in many small steps.
  ASSERT_TRUE(wait([&] { return hasSign(); }));
  double before = aside();
  double largest = 0.0;
  EXPECT_TRUE(wait([&] {
    largest = std::max(largest, before - aside());
    before = aside();
    return aside() == 0.0;
  }));
  EXPECT_LT(largest, 0.5 * expected);
  EXPECT_EQ(camera().eye(), atRest);
  following().setChecked(false);
  EXPECT_FALSE(hasSign());
  EXPECT_LT((camera().eye() - usual).norm(), 1e-9);
}

TEST_F(HeadControllerTest, WithoutNewDataNothingMoves) {
  following().setChecked(true);
  test::FakeHeadTracker tracker(head().receiver().port());
  ASSERT_TRUE(wait([&] {
    tracker.send({5.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    return head().state().tracked;
  }));
  wait([] { return false; }, 50);  // for datagrams that are still on their way
  const Vector3 before = camera().eye();
  wait([] { return false; }, 200);
  EXPECT_EQ(camera().eye(), before);
}

TEST_F(HeadControllerTest, WhileItIsOffThereIsNoSocketAndNoTimer) {
  const int before = activeTimers();
  EXPECT_FALSE(head().receiver().isOpen());
  following().setChecked(true);
  EXPECT_TRUE(head().receiver().isOpen());
  following().setChecked(false);
  EXPECT_FALSE(head().receiver().isOpen());
  EXPECT_LE(activeTimers(), before);
}

TEST_F(HeadControllerTest, APortThatIsTakenIsSaidAndNothingIsFollowed) {
  HeadReceiver other;
  HeadPreferences preferences;
  ASSERT_TRUE(other.open(0, false));
  preferences.port = other.port();
  emit dialog().changed(preferences);
  following().setChecked(true);
  EXPECT_FALSE(following().isChecked());
}

TEST_F(HeadControllerTest, RestIsWhereThePersonSits) {
  following().setChecked(true);
  test::FakeHeadTracker tracker(head().receiver().port());
  const auto sit = [&] {
    tracker.send({8.0, 4.0, 60.0, 0.0, 0.0, 0.0});
    return head().state().tracked && head().state().reading[2] > 0.5;
  };
  ASSERT_TRUE(wait(sit));
  emit dialog().restRequested();
  EXPECT_TRUE(wait([&] {
    sit();
    return head().state().motion.shift.norm() < 1e-3;
  }));
}

}  // namespace
}  // namespace glissade
