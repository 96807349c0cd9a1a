// Tests the hint that names the keys to hold.
#include "widgets/run/hand_lead.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "engine/operator/shaping_presets.h"
#include "tests/app/whole_window.h"

namespace glissade {
namespace {

constexpr double kRadius = 1.0;

Pose turned(double x, double y, double z) { return {Vector3::Zero(), fromRotationVector({x, y, z})}; }

class HandLead : public testing::Test {
 protected:
  std::string lettersFor(const Pose& to) const {
    std::string letters;
    for (const KeyToHold& key : keysToHold(from, to, shaping, {}, kRadius)) letters += key.key->letter;
    return letters;
  }

  DeviceShaping shaping = standardShaping(InputKind::Keyboard);
  Pose from;
};

TEST_F(HandLead, NamesTheKeysOfTheMotion) {
  EXPECT_EQ(lettersFor({Vector3(0.2, 0.0, -0.3), fromRotationVector({0.0, 0.0, 0.2})}), "QDU");
  EXPECT_EQ(lettersFor(Pose::translation({-0.2, -0.3, 0.0})), "SA");
  EXPECT_EQ(lettersFor(turned(0.0, 0.3, 0.0)), "L");
  EXPECT_EQ(lettersFor(from), "");
}

TEST_F(HandLead, LeavesOutWhatIsMuchShorter) {
  EXPECT_EQ(lettersFor(Pose::translation({0.3, 0.05, 0.0})), "D");
  EXPECT_EQ(lettersFor(Pose::translation({0.005, 0.0, 0.0})), "");
}

TEST_F(HandLead, FollowsTheAxesAndTheMappingOfTheKeyboard) {
  shaping.frame = MotionFrame::World;
  EXPECT_EQ(lettersFor(Pose::translation({0.2, 0.0, 0.3})), "WD");
  shaping.frame = MotionFrame::Object;
  from = turned(0.0, 0.0, 0.5 * EIGEN_PI);
  EXPECT_EQ(lettersFor({Vector3(0.0, 0.3, 0.0), from.orientation}), "D");
  from = Pose();
  EXPECT_EQ(lettersFor(turned(0.3, 0.0, 0.0)), "K");
  shaping.axes[3].inverted = true;
  EXPECT_EQ(lettersFor(turned(0.3, 0.0, 0.0)), "I");
}

TEST_F(HandLead, HasNumbersOfOneDigit) {
  const auto keys = keysToHold(from, {Vector3(0.284, 0.0, 0.0), fromRotationVector({0.0, 0.0, 0.2})}, shaping, {}, 1.0);
  EXPECT_EQ(textOf(keys, true).toStdString(), "D: right 300 mm · U: roll left 10°");
  EXPECT_EQ(textOf(keys, false).toStdString(), "right 300 mm · roll left 10°");
}

using HandLeadInTheWindow = test::WholeWindowTest;
INSTANTIATE_TEST_SUITE_P(Languages, HandLeadInTheWindow, testing::Values("en"));

TEST_P(HandLeadInTheWindow, NamesKeysOnceTheHandWasTakenToAPlace) {
  const auto window = makeWindow();
  ASSERT_FALSE(window->openScenario(sample("environment-1"), true));
  window->show();
  const Workbench& bench = window->workbench();
  const auto shows = [&window](const char* text) {
    const auto lines = window->findChildren<QLabel*>(QStringLiteral("scene-hint"));
    return std::any_of(lines.begin(), lines.end(), [text](const QLabel* line) {
      return line->isVisible() && line->text().contains(QString::fromUtf8(text));
    });
  };
  bench.session.setDevice("hand");
  bench.session.post(command::SetPlanner{"by-hand"});
  bench.session.post(command::Start{});
  bench.session.advance(200);
  EXPECT_FALSE(shows("Hold "));
  bench.actions["assist.go"]->trigger();
  bench.session.advance(2);
  EXPECT_TRUE(shows("Hold "));
  bench.session.post(command::Stop{});
  bench.session.advance(1);
  bench.session.setDevice("none");
  EXPECT_FALSE(shows("Hold "));
}

}  // namespace
}  // namespace glissade
