// A person works with the panel in the scene only: the real window with the runtime for tests, on a virtual display.
// See with_headset.sh.
#include <QAbstractButton>
#include <QSlider>

#include "engine/geometry/least_rotation.h"
#include "tests/app/golden_picture.h"
#include "tests/widgets/headset/runtime/headset_script.h"
#include "tests/widgets/headset/window_with_headset.h"
#include "widgets/headset/headset_panel_controller.h"
#include "widgets/openxr/panel_in_room.h"

namespace glissade {
namespace {

/// A person of the scripted controllers who carries the panel in the left hand and points at it with the right one.
class PointingHands {
 public:
  /// The left hand is there from the beginning; the right one comes with its first motion.
  explicit PointingHands(const Pose& X_RG) {
    test::ControllerMoment left;
    left.X_RG = X_RG;
    test::setController(0, left);
    BothControllers hands;
    hands[0].X_RG = X_RG;
    PanelInRoom panel;
    panel.advance(hands, {});
    X_RP_ = *panel.X_RP();
  }

  /// `at`: shares of the panel's width and height, from its upper left corner.
  PointingHands& pointAt(const Eigen::Vector2d& at) {
    const Vector3 p_P((at.x() - 0.5) * PanelInRoom::kWidth, (0.5 - at.y()) * PanelInRoom::kHeight, 0.0);
    const Vector3 target = X_RP_ * p_P;
    const Vector3 from = X_RP_ * Vector3(0.2, -0.1, 0.3);
    right_.X_RG = {from, leastRotation(-Vector3::UnitZ(), target - from)};
    return add();
  }
  PointingHands& pull() {
    right_.trigger = 1.0;
    return add();
  }
  PointingHands& release() {
    right_.trigger = 0.0;
    return add();
  }
  void play() {
    if (!isThere_) test::setController(1, moments_.front());
    isThere_ = true;
    test::playController(1, moments_);
    moments_.clear();
  }

 private:
  PointingHands& add() {
    right_.after = 0.0;
    moments_.push_back(right_);
    return *this;
  }

  Pose X_RP_;
  test::ControllerMoment right_;
  bool isThere_ = false;
  std::vector<test::ControllerMoment> moments_;
};

/// The head before the panel, as a person uses it.
const Pose kHead{Vector3(0.0, 1.6, 0.0), Quaternion(Eigen::AngleAxisd(-0.45, Vector3::UnitX()))};
const Pose kLeftHand{Vector3(-0.12, 1.12, -0.32), Quaternion(Eigen::AngleAxisd(-0.1, Vector3::UnitY()))};
/// A real headset has 20 pixels for each degree, and this one has 11.
constexpr int kEyePixels = 1024;

class HeadsetPanelTest : public test::WindowWithHeadset {
 protected:
  HeadsetPanelTest() : WindowWithHeadset("environment-1/scenario.json") {
    window_->setTheme(Theme::Light);
    window_->resize(600, 400);  // the same cores draw the window
    bench().actions["headset.on-table"]->setChecked(true);
    test::setHead(kHead);
  }

  void wear() {
    headset().trigger();
    ASSERT_TRUE(isRunning());
  }
  HeadsetPanelController& panel() { return *window_->findChild<HeadsetPanelController*>(); }
  HeadsetPage& page() { return *panel().page(); }
  const SnapshotPtr& snapshot() { return bench().session.snapshot(); }
  double alpha() { return snapshot()->parameters[ParameterId::Alpha]; }
  QWidget& buttonOf(const char* action) {
    for (QToolButton* button : page().findChildren<QToolButton*>()) {
      if (button->defaultAction() == bench().actions[action]) return *button;
    }
    ADD_FAILURE() << action << " has no button";
    return page();
  }
  QSlider& slider(const char* parameter) {
    return *page().findChild<QWidget*>(QLatin1String(parameter))->findChild<QSlider*>();
  }
  /// A place of a widget in shares of the page; `share` of the widget's width.
  Eigen::Vector2d placeOf(const QWidget& widget, double share = 0.5) {
    const QPointF at = widget.mapTo(&page(), QPoint()) + QPointF(share * widget.width(), 0.5 * widget.height());
    return {at.x() / page().width(), at.y() / page().height()};
  }
  bool hasPlayed() {
    return until([] { return test::hasPlayed(1); });
  }
  void press(const char* action) {
    hands_.pointAt(placeOf(buttonOf(action))).pull().release().play();
    ASSERT_TRUE(hasPlayed());
  }
  QImage picture() {
    const int before = test::shownPictures();
    until([before] { return test::shownPictures() > before + 1; });  // the painted page is shown
    const std::vector<test::EyePicture> shown = test::nextPictures(std::chrono::seconds(20));
    return QImage(shown.at(0).rgba.data(), shown[0].width, shown[0].height, QImage::Format_RGBX8888).copy();
  }

  PointingHands hands_{kLeftHand};
};

TEST_F(HeadsetPanelTest, ARunIsStartedAndStoppedAndAlphaIsDraggedByThePanelAlone) {
  wear();
  press("run.start");
  ASSERT_TRUE(until([this] { return glissade::isRunning(*snapshot()) || snapshot()->path; }));
  const double before = alpha();
  QSlider& authority = slider("alpha");
  const double share = static_cast<double>(authority.value()) / authority.maximum();
  // The place of the slider's handle, which does not reach the ends of the slider.
  const auto handle = [&](double value) {
    return placeOf(authority, (16.0 + value * (authority.width() - 32.0)) / authority.width());
  };
  hands_.pointAt(handle(share)).pull().pointAt(handle(0.5)).pointAt(handle(0.8)).release().play();
  ASSERT_TRUE(hasPlayed());
  EXPECT_TRUE(until([&] { return std::abs(alpha() - 0.8) < 0.02; })) << before << " became " << alpha();
  hands_.pointAt(handle(0.8)).pull().pointAt({3.0, 0.5}).release().play();
  ASSERT_TRUE(hasPlayed());
  EXPECT_TRUE(until([&] { return alpha() == 1.0; })) << "past its end";
  press("run.stop");
  EXPECT_TRUE(until([this] { return !glissade::isRunning(*snapshot()); }));
}

TEST_F(HeadsetPanelTest, TheSheetOfTheSceneChangesTheDisplayAndLeavesTheHeadset) {
  wear();
  hands_.pointAt(placeOf(*page().findChild<QWidget*>(QStringLiteral("headset-scene")))).pull().release().play();
  ASSERT_TRUE(hasPlayed());
  ASSERT_TRUE(until([this] { return buttonOf("display.wireframe").isVisibleTo(&page()); }));
  press("display.wireframe");
  EXPECT_TRUE(until([this] { return bench().actions["display.wireframe"]->isChecked(); }));
  press("headset.leave");
  EXPECT_TRUE(until([this] { return !headset().isChecked(); }));
}

TEST_F(HeadsetPanelTest, AStrategyIsChosen) {
  wear();
  QWidget& layers = *page().findChild<QAbstractButton*>(QStringLiteral("gts"));
  hands_.pointAt(placeOf(layers)).pull().release().play();
  EXPECT_TRUE(until([this] { return snapshot()->plannerId == "gts"; }));
}

TEST_F(HeadsetPanelTest, WhatWasRefusedIsSaidThere) {
  wear();
  EXPECT_TRUE(page().findChild<QLabel*>(QStringLiteral("headset-refused"))->text().isEmpty());
  const RigidBody& wall = bench().document.scenario()->obstacles.front();
  const Vector3 middle = boundingBox(*wall.mesh, wall.X_WB).center();
  const auto intoAWall = [middle](Scenario& scenario) {
    scenario.start.position = middle;
    return Outcome(Done{});
  };
  ASSERT_TRUE(bench().document.edit(QStringLiteral("wall"), intoAWall));
  press("run.start");
  EXPECT_TRUE(
      until([this] { return !page().findChild<QLabel*>(QStringLiteral("headset-refused"))->text().isEmpty(); }));
}

TEST_F(HeadsetPanelTest, ItIsPaintedAgainOnlyWhenItSaysSomethingElse) {
  wear();
  int before = -1;
  EXPECT_TRUE(until([&] {
    const bool rests = before == panel().paintings();
    before = panel().paintings();
    until([] { return false; }, 500);
    return rests && before == panel().paintings();
  }));
  page().setRefusal(QStringLiteral("refused"), {});
  EXPECT_TRUE(until([&] { return panel().paintings() > before; }));
}

TEST_F(HeadsetPanelTest, PictureOfAnEyeWithThePanel) {
  test::setEyePixels(kEyePixels);
  wear();
  page().setRefusal(QStringLiteral("Start pose collides: 'object' overlaps wall by 3 mm."),
                    QStringLiteral("'wall': overlap 3 mm"));
  hands_.pointAt(placeOf(buttonOf("run.start"))).play();
  ASSERT_TRUE(hasPlayed());
  test::expectLikeGolden(picture(), QStringLiteral("headset-panel"));
}

}  // namespace
}  // namespace glissade
