// A person works with a headset and two controllers only: the real window with the runtime for tests, on a virtual
// display. See with_headset.sh.
#include <algorithm>
#include <numbers>

#include "engine/collision/contact_planes.h"
#include "tests/widgets/headset/runtime/headset_script.h"
#include "tests/widgets/headset/window_with_headset.h"
#include "widgets/devices/device_settings.h"
#include "widgets/openxr/room_placement.h"

namespace glissade {
namespace {

/// Collects motions of the hand; play() carries them out.
class ScriptedHand {
 public:
  ScriptedHand(std::size_t hand, const RoomPlacement& room, const Pose& X_WG) : hand_(hand), room_(room) {
    moment_.X_RG = inRoom(X_WG);
    test::setController(hand_, moment_);
  }

  const Pose& X_WG() const { return X_WG_; }
  ScriptedHand& move(const Pose& X_WG, double seconds) {
    moment_.X_RG = inRoom(X_WG);
    return add(seconds);
  }
  ScriptedHand& squeeze(double share) {
    moment_.squeeze = share;
    return add(0.0);
  }
  /// Presses and releases the component.
  ScriptedHand& press(const char* component) {
    moment_.pressed = component;
    add(0.0);
    moment_.pressed.clear();
    return add(0.0);
  }
  ScriptedHand& loseTracking(bool isLost) {
    moment_.isTracked = !isLost;
    return add(0.0);
  }
  ScriptedHand& wait(double seconds) { return add(seconds); }
  void play() {
    test::playController(hand_, moments_);
    moments_.clear();
  }
  bool hasPlayed() const { return test::hasPlayed(hand_); }

 private:
  Pose inRoom(const Pose& X_WG) {
    X_WG_ = X_WG;
    const Pose X_RG = inverse(room_.X_WR) * X_WG;
    return {room_.scale * X_RG.position, X_RG.orientation};
  }
  ScriptedHand& add(double seconds) {
    moment_.after = seconds;
    moments_.push_back(moment_);
    return *this;
  }

  std::size_t hand_;
  RoomPlacement room_;
  Pose X_WG_;  ///< pose at the end of the motions
  test::ControllerMoment moment_;
  std::vector<test::ControllerMoment> moments_;
};

constexpr std::size_t kRight = 1;
constexpr double kQuarter = 0.5 * std::numbers::pi;
constexpr const char* kLower = "/input/a/click";
constexpr const char* kMenu = "/input/b/click";

class HeadsetHandsTest : public test::WindowWithHeadset {
 protected:
  explicit HeadsetHandsTest(const char* sample = "environment-1/scenario.json") : WindowWithHeadset(sample) {
    window_->resize(600, 400);  // the same cores draw the window
    bench().actions["headset.on-table"]->setChecked(true);
    headset().trigger();
    EXPECT_TRUE(isRunning());
  }

  const SnapshotPtr& snapshot() { return bench().session.snapshot(); }
  const Problem& problem() { return bench().document.scenario()->problem; }
  const OperatorSample& device() { return snapshot()->device; }
  bool holds() { return bench().session.hand()->rightController.place.feedback().holds; }
  double radius() { return problem().world->objectRadius(); }
  RoomPlacement room() { return placeRoom(bench().scene.view().extent(), ProductSize::OnTable); }
  /// The hand at the object's reference point.
  ScriptedHand handAtTheObject() { return {kRight, room(), device().q_device}; }
  const std::vector<Pose>& wayPoints() { return bench().document.scenario()->scenario.wayPoints; }
  bool hasPlayed(const ScriptedHand& hand) {
    return until([&] { return hand.hasPlayed(); });
  }
  /// The pose of the object once the window has seen it at rest: the window's data are older than the controller's
  /// feedback.
  Pose settled() {
    QElapsedTimer atRest;
    atRest.start();
    Pose last = device().q_device;
    EXPECT_TRUE(until([&] {
      if (device().q_device != last) atRest.restart();
      last = device().q_device;
      return atRest.elapsed() > 500;
    }));
    return last;
  }
  /// Least distance to the nearest obstacle while the hand carries out its motions.
  double leastDistance(const ScriptedHand& hand) {
    double least = device().nearest.distance;
    EXPECT_TRUE(until([&] {
      least = std::min(least, device().nearest.distance);
      return hand.hasPlayed();
    }));
    return least;
  }
};

/// The pose in contact with the nearest obstacle, and moved farther by `beyond`.
Pose pushedInto(const NearestObstacle& nearest, const Pose& q, double beyond) {
  return {q.position - (nearest.distance + beyond) * nearest.normal_W(), q.orientation};
}

TEST_F(HeadsetHandsTest, TakenMovedWithContactLetGoAndPlannedToTheGoal) {
  const double set = snapshot()->parameters[ParameterId::Alpha];
  const Pose start = problem().start;
  ScriptedHand hand = handAtTheObject();
  hand.press(kMenu).play();
  ASSERT_TRUE(until([this] { return glissade::isRunning(*snapshot()); }));

  // The hand pushes the object into the nearest obstacle, along it, and back.
  hand.squeeze(1.0).play();
  ASSERT_TRUE(until([this] { return holds(); }));
  EXPECT_LT(longestWay(settled(), start, radius()), 1e-3 * radius()) << "a jump";
  const Pose into = pushedInto(device().nearest, start, radius());
  hand.move(into, 1.0).play();
  EXPECT_GT(leastDistance(hand), 0.0) << "penetration";
  EXPECT_TRUE(until([this] { return device().nearest.distance < 0.01 * radius(); })) << "contact";
  EXPECT_TRUE(until([this] { return device().hand.has_value(); })) << "the hand is ahead of the object";
  EXPECT_GT(device().nearest.distance, 0.0) << "penetration";
  EXPECT_TRUE(until([] {
    const std::vector<double> pulses = test::takePulses(kRight);
    return std::any_of(pulses.begin(), pulses.end(), [](double pulse) { return pulse > 0.9; });
  })) << "it is felt";
  EXPECT_TRUE(until([&] { return snapshot()->parameters[ParameterId::Alpha] < set; })) << "a firm grip";
  hand.move(start, 0.7).play();
  EXPECT_GT(leastDistance(hand), 0.0) << "penetration";

  // The hand loses tracking on the way, and is at another place afterwards.
  hand.loseTracking(true).play();
  ASSERT_TRUE(until([this] { return !holds(); }));
  const Pose lost = settled();
  hand.move(Pose::translation({1.0, -2.0, 0.5}) * start, 0.0).loseTracking(false).play();
  ASSERT_TRUE(until([this] { return holds(); }));
  EXPECT_LT(longestWay(settled(), lost, radius()), 1e-3 * radius()) << "a jump";
  const Pose X_OG = inverse(lost) * hand.X_WG();

  // The hand moves the object through the gap, and lets go there.
  for (const Pose& q : wayPoints()) hand.move(q * X_OG, 0.6).wait(0.2);
  hand.play();
  EXPECT_GT(leastDistance(hand), 0.0) << "penetration";
  hand.squeeze(0.0).play();
  ASSERT_TRUE(until([this] { return !holds(); }));
  const Pose left = settled();
  hand.move(start, 0.3).wait(0.1).play();
  ASSERT_TRUE(hasPlayed(hand));
  EXPECT_EQ(settled(), left);
  EXPECT_TRUE(until([&] { return snapshot()->parameters[ParameterId::Alpha] == set; }));

  ASSERT_TRUE(until([this] { return snapshot()->path != nullptr; }, 120'000));
  const Path& path = *snapshot()->path;
  EXPECT_EQ(path.certificate.status, CertificateStatus::Certified);
  EXPECT_EQ(path.points.front().q, start);
  EXPECT_EQ(path.points.back().q, std::get<Pose>(problem().goal));
  EXPECT_GT(snapshot()->nodesByAuthor[static_cast<std::size_t>(Author::Operator)], 0U) << "the hand took part";
}

class HeadsetHandsAtThePump : public HeadsetHandsTest {
 protected:
  HeadsetHandsAtThePump() : HeadsetHandsTest("pump/unmount.json") {}
};

TEST_F(HeadsetHandsAtThePump, ItIsLiftedOffItsSeatAndPlannedToTheGoal) {
  ScriptedHand hand = handAtTheObject();
  hand.press(kMenu).squeeze(1.0).play();
  ASSERT_TRUE(until([this] { return holds(); }));
  const Pose X_OG = inverse(device().q_device) * hand.X_WG();
  const auto moved = [&](double x, double y, double z) {
    return Pose::translation(problem().start.position + Vector3(x, y, z)) * X_OG;
  };
  hand.move(moved(0.0, 0.0, 0.02), 0.5).move(moved(0.3, -0.5, 0.02), 1.0).wait(0.3).play();
  EXPECT_GT(leastDistance(hand), 0.0) << "penetration";
  EXPECT_TRUE(until([this] { return longestWay(device().q_device, problem().start, radius()) > 0.05 * radius(); }));
  hand.squeeze(0.0).play();
  ASSERT_TRUE(until([this] { return !holds(); }));
  ASSERT_TRUE(until([this] { return snapshot()->path != nullptr; }, 120'000));
  EXPECT_EQ(snapshot()->path->certificate.status, CertificateStatus::Certified);
}

class HeadsetHandsAtAStep : public HeadsetHandsTest {
 protected:
  HeadsetHandsAtAStep() : HeadsetHandsTest("interlocked/turn.json") {
    carryOut("plan-sequence", {"all"});
    carryOut("show-step", {"1"});
  }
  ~HeadsetHandsAtAStep() override { DeviceSettings().reset(buttons()); }

  HandInput& buttons() { return bench().session.hand()->rightController.buttons; }
  /// Sets an action of the lower button. The controller has to be connected, because settings belong to its name.
  void giveLowerButton(const char* action) {
    EXPECT_TRUE(until([this] { return buttons().mailbox.reading().connected; }));
    DeviceSettings().setAction(buttons(), static_cast<std::size_t>(ControllerButton::Lower), QLatin1String(action));
  }

  void carryOut(const char* command, const ScriptCommands::Words& words) {
    const Outcome outcome = bench().scripts.carryOut(command, words);
    EXPECT_TRUE(outcome) << command << ": " << (outcome ? "" : toString(outcome.error().reason));
  }
};

/// A key has a bar that lies across the slot of the cover. It turns by a quarter, and leaves upwards.
TEST_F(HeadsetHandsAtAStep, ItIsMovedByHandAndItsPathBecomesTheMotionOfTheStep) {
  ScriptedHand chooser = handAtTheObject();
  giveLowerButton("sequence.by-hand");
  chooser.press(kLower).play();
  ASSERT_TRUE(until([this] { return bench().actions["sequence.leave-hand"]->isEnabled(); }));
  ScriptedHand hand = handAtTheObject();
  hand.press(kMenu).squeeze(1.0).play();
  ASSERT_TRUE(until([this] { return holds(); }));
  const Pose X_OG = inverse(device().q_device) * hand.X_WG();
  const auto moved = [&](double up, double turn) {
    return Pose{device().q_device.position + Vector3(0.0, 0.0, up),
                Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitZ()))} *
           X_OG;
  };
  hand.move(moved(0.5, 0.0), 0.5).move(moved(0.0, kQuarter), 1.0).move(moved(3.0, kQuarter), 1.0).squeeze(0.0);
  hand.play();
  EXPECT_GT(leastDistance(hand), 0.0) << "penetration";
  // The path is taken, and the sequence is shown again.
  ASSERT_TRUE(until([this] { return !bench().actions["sequence.leave-hand"]->isEnabled(); }, 120'000));
  carryOut("expect-sequence", {"end", "complete"});
  const std::vector<DemandedMotion>& motions = bench().document.demands().motions;
  ASSERT_EQ(motions.size(), 1U) << "the path of the hand is the motion of the step";
  EXPECT_EQ(motions.front().bodies, std::vector<std::string>{"turn-key"});
}

/// The part is taken at the beginning of its motion, led along it, and snaps into its place.
TEST_F(HeadsetHandsAtAStep, TheInstructionIsCarriedOutByHand) {
  bench().actions["sequence.show-product"]->trigger();
  const RoomPlacement placed = room();
  const std::vector<PathPoint> way = bench().document.plan()->steps.front().only().path;
  const Pose X_WG = way.back().q;
  ScriptedHand hand(kRight, placed, X_WG);
  ASSERT_TRUE(until([this] { return bench().session.hand()->rightController.place.reading().X_WG.has_value(); }));
  bench().actions["headset.instruction"]->trigger();
  EXPECT_TRUE(bench().scene.view().showsSequence());
  // Closing the hand takes the part. On a busy machine the part may not be there at the first attempt.
  for (int i = 0; i < 3 && !holds(); ++i) {
    hand.squeeze(0.0).wait(0.2).squeeze(1.0).play();
    until([this] { return holds(); }, 5'000);
  }
  ASSERT_TRUE(holds());
  for (std::size_t i = way.size() - 1; i-- > 0;) hand.move(way[i].q, 0.7);
  hand.wait(0.2).play();
  EXPECT_TRUE(until([this] { return !holds(); })) << "it has snapped";
  EXPECT_LT(bench().scene.view().extent().sizes().maxCoeff() * placed.scale, 0.61) << "the product is whole";
}

}  // namespace
}  // namespace glissade
