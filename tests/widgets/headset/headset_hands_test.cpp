// A person with a headset and two controllers, and nothing else: the real window with the runtime for tests, on a
// virtual display. See with_headset.sh.
#include "tests/widgets/headset/scripted_hand.h"
#include "tests/widgets/headset/window_with_headset.h"

namespace glissade {
namespace {

constexpr std::size_t kRight = 1;
constexpr const char* kMenu = "/input/b/click";

class HeadsetHandsTest : public test::WindowWithHeadset {
 protected:
  explicit HeadsetHandsTest(const char* sample = "environment-1") : WindowWithHeadset(sample) {
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
  /// The hand is where the object has its reference point.
  test::ScriptedHand handAtTheObject() { return {kRight, room(), device().q_device}; }
  bool hasPlayed(const test::ScriptedHand& hand) {
    return until([&] { return hand.hasPlayed(); });
  }
};

/// A little less than the whole of the nearest obstacle's gap and some more.
Pose pushedToward(const NearestObstacle& nearest, const Pose& q, double beyond) {
  return {q.position - (nearest.distance + beyond) * nearest.normal_W(), q.orientation};
}

TEST_F(HeadsetHandsTest, TakenMovedWithContactLetGoAndPlannedToTheGoal) {
  test::ScriptedHand hand = handAtTheObject();
  hand.press(kMenu).play();
  ASSERT_TRUE(until([this] { return glissade::isRunning(*snapshot()); }));
  hand.squeeze(1.0).play();
  ASSERT_TRUE(until([this] { return holds(); }));
  const Pose start = device().q_device;
  std::printf("state %d nodes %llu nearest %g radius %g\n", static_cast<int>(snapshot()->state),
              static_cast<unsigned long long>(snapshot()->counts.nodes), device().nearest.distance, radius());
  hand.move(pushedToward(device().nearest, start, radius()), 1.0).wait(0.5).play();
  ASSERT_TRUE(hasPlayed(hand));
  std::printf("state %d nodes %llu nearest %g alpha %g\n", static_cast<int>(snapshot()->state),
              static_cast<unsigned long long>(snapshot()->counts.nodes), device().nearest.distance,
              snapshot()->parameters[ParameterId::Alpha]);
}

}  // namespace
}  // namespace glissade
