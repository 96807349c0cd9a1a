#include "widgets/bridge/session_bridge.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>

#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

ScenarioPtr slidingPlane() {
  auto loaded = loadScenario(std::string(GLISSADE_SOURCE_DIR) + "/samples/sliding-plane/scenario.json");
  return std::make_shared<const LoadedScenario>(std::move(*loaded));
}

/// Lets time pass in either kind of session until the state is reached.
bool reach(SessionBridge& bridge, SessionState state) {
  QElapsedTimer timer;
  timer.start();
  while (bridge.snapshot()->state != state && timer.elapsed() < 30000) {
    bridge.advance(20);
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  return bridge.snapshot()->state == state;
}

class Bridge : public testing::TestWithParam<SessionClock> {};

TEST_P(Bridge, SolvesWithASimulatedOperatorAndSignalsOnTheGuiThread) {
  SessionBridge bridge(GetParam());
  bridge.open(slidingPlane());
  bridge.setDevice("expert");
  QSignalSpy spy(&bridge, &SessionBridge::snapshotChanged);
  bridge.post(command::Start{});
  ASSERT_TRUE(reach(bridge, SessionState::Solved));
  EXPECT_TRUE(spy.count() > 0 || spy.wait());
}

TEST_P(Bridge, ARearrangedScenarioKeepsWhatTheUserHasSet) {
  const ScenarioPtr before = slidingPlane();
  SessionBridge bridge(GetParam());
  bridge.open(before);
  bridge.post(command::SetParameter{ParameterId::Alpha, 0.625});
  bridge.post(command::SetPlanner{"birrt"});
  bridge.post(command::SetSeed{77});
  QElapsedTimer timer;
  timer.start();
  while (bridge.snapshot()->seed != 77 && timer.elapsed() < 10000) QCoreApplication::processEvents();

  Scenario other = before->scenario;
  other.object.geometry = BoxGeometry{{1.0, 1.0, 1.0}};
  other.start.position.z() += 1.0;
  auto loaded = realiseScenario(other, ".", before->file, before->geometry);
  ASSERT_TRUE(loaded.ok());
  const double larger = loaded->problem.world->objectRadius() / before->problem.world->objectRadius();
  bridge.rearrange(std::make_shared<const LoadedScenario>(std::move(*loaded)));
  const SnapshotPtr now = bridge.snapshot();
  EXPECT_EQ(now->seed, 77U);
  EXPECT_EQ(now->plannerId, "birrt");
  EXPECT_EQ(now->parameters[ParameterId::Alpha], 0.625);
  EXPECT_EQ(now->state, SessionState::Idle);
  EXPECT_EQ(now->device.q_device, other.start);
  // What fits itself to the object's size does so again.
  EXPECT_NEAR(now->parameters[ParameterId::GrowthStep], larger * before->parameters[ParameterId::GrowthStep], 1e-12);
}

TEST_P(Bridge, AnotherDeviceKeepsWhatTheUserHasSet) {
  SessionBridge bridge(GetParam());
  bridge.open(slidingPlane());
  bridge.post(command::SetParameter{ParameterId::Alpha, 0.625});
  bridge.post(command::SetSeed{77});
  const auto edits = std::make_shared<const SemanticEdits>();
  bridge.post(command::SetSemantics{edits});
  QElapsedTimer timer;
  timer.start();
  while (bridge.snapshot()->seed != 77 && timer.elapsed() < 10000) QCoreApplication::processEvents();
  bridge.setDevice("novice");
  EXPECT_EQ(bridge.snapshot()->parameters[ParameterId::Alpha], 0.625);
  EXPECT_EQ(bridge.snapshot()->seed, 77U);
  EXPECT_EQ(bridge.deviceId(), "novice");
  bridge.post(command::Start{});
  timer.start();
  while (bridge.snapshot()->log.empty() && timer.elapsed() < 10000) QCoreApplication::processEvents();
  ASSERT_FALSE(bridge.snapshot()->log.empty());
  EXPECT_EQ(bridge.snapshot()->log.front()->start.edits, edits);
}

TEST_P(Bridge, OpensOneScenarioAfterAnotherWhileItRuns) {
  SessionBridge bridge(GetParam());
  for (int i = 0; i < 3; ++i) {
    bridge.open(slidingPlane());
    bridge.post(command::Start{});
    bridge.advance(3);
  }
  EXPECT_NE(bridge.snapshot(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Both, Bridge, testing::Values(SessionClock::Lockstep, SessionClock::RealTime),
                         [](const testing::TestParamInfo<SessionClock>& parameter) {
                           return parameter.param == SessionClock::Lockstep ? "lockstep" : "realtime";
                         });

}  // namespace
}  // namespace glissade
