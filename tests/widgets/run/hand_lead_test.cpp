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

class HandLeadInTheWindow : public test::WholeWindowTest {
 protected:
  bool shows(const char* text) const {
    const auto lines = window->findChildren<QLabel*>(QStringLiteral("scene-hint"));
    return std::any_of(lines.begin(), lines.end(), [text](const QLabel* line) {
      return line->isVisible() && line->text().contains(QString::fromUtf8(text));
    });
  }
  void open() {
    ASSERT_FALSE(window->openScenario(sample("environment-1"), true));
    window->show();
    session.setDevice("hand");
    session.post(command::SetPlanner{"by-hand"});
  }

  std::unique_ptr<MainWindow> window = makeWindow();
  SessionBridge& session = window->workbench().session;
};
INSTANTIATE_TEST_SUITE_P(Languages, HandLeadInTheWindow, testing::Values("en"));

TEST_P(HandLeadInTheWindow, NamesKeysOnceTheHandWasTakenToAPlace) {
  open();
  const Workbench& bench = window->workbench();
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

TEST_P(HandLeadInTheWindow, NamesWhatStopsTheObjectAndTheMovesThatAreFree) {
  open();
  InputMailbox& keys = session.hand()->keyboard.mailbox;
  DeviceShaping shaping = session.hand()->keyboard.shaping.get();
  shaping.frame = MotionFrame::World;
  session.hand()->keyboard.shaping.set(shaping);
  const auto hold = [&](std::size_t axis, double side, int slices) {
    RawAxes axes{};
    axes[axis] = side;
    keys.setAxes(axes);
    for (int slice = 0; slice < slices; ++slice) session.advance(10);
  };
  session.post(command::Start{});
  session.advance(1);
  hold(0, 1.0, 8);  // beside the wall
  EXPECT_FALSE(shows("Touches"));
  hold(2, -1.0, 20);  // straight into it
  EXPECT_TRUE(shows("Touches wall_L1: back off or slide along it. Free: ")) << "nothing else is as near";
  EXPECT_TRUE(shows("E: towards you"));
  EXPECT_FALSE(shows("Q: away"));
  hold(2, 1.0, 2);
  EXPECT_FALSE(shows("Touches"));
  keys.setAxes({});
}

TEST_P(HandLeadInTheWindow, APausedRunSaysHowItGoesOn) {
  open();
  session.post(command::Start{});
  session.advance(10);
  EXPECT_FALSE(shows("Paused"));
  const std::uint64_t moves = session.snapshot()->device.moves;
  window->workbench().actions["run.pause"]->trigger();
  RawAxes axes{};
  axes[0] = 1.0;
  session.hand()->keyboard.mailbox.setAxes(axes);
  session.advance(10);
  EXPECT_TRUE(shows("Paused: press F6 to go on."));
  EXPECT_EQ(session.snapshot()->device.moves, moves) << "the object rests";
  window->workbench().actions["run.pause"]->trigger();
  session.advance(10);
  EXPECT_FALSE(shows("Paused"));
  EXPECT_GT(session.snapshot()->device.moves, moves);
  session.hand()->keyboard.mailbox.setAxes({});
}

/// The row of the present settings is there before a run.
TEST_P(HandLeadInTheWindow, TheRowOfThePaperIsThereFromTheStart) {
  ASSERT_FALSE(window->openScenario(sample("environment-1"), true));
  window->show();
  const auto* row = window->findChild<QLabel*>(QStringLiteral("paper-comparison"));
  session.post(command::SetPlanner{"contact-birrt"});
  for (const double alpha : {0.2, 0.5}) {
    session.post(command::SetParameter{ParameterId::Alpha, alpha});
    session.advance(1);
    EXPECT_FALSE(row->isHidden());
    EXPECT_TRUE(row->text().contains(QStringLiteral("α = %1<").arg(alpha))) << row->text().toStdString();
    EXPECT_TRUE(row->text().contains(QStringLiteral("–"))) << "this run has no path";
  }
  session.post(command::SetParameter{ParameterId::Alpha, 0.37});
  session.advance(1);
  EXPECT_TRUE(row->isHidden()) << "the paper has no such row";
}

}  // namespace
}  // namespace glissade
