#include "widgets/document/session_bridge.h"
#include "tests/engine/support/directories.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QThread>

#include "engine/base/file.h"
#include "engine/files/scenario_io.h"

namespace glissade {
namespace {

ScenarioPtr sample(const std::string& name) {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/" + name + "/scenario.json");
  return std::make_shared<const LoadedScenario>(std::move(*loaded));
}

ScenarioPtr slidingPlane() { return sample("sliding-plane"); }

/// Lets time pass in either kind of session until the condition holds.
bool reach(SessionBridge& bridge, const std::function<bool(const SessionSnapshot&)>& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition(*bridge.snapshot()) && timer.elapsed() < 30000) {
    bridge.advance(20);
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  return condition(*bridge.snapshot());
}

bool reach(SessionBridge& bridge, SessionState state) {
  return reach(bridge, [state](const SessionSnapshot& now) { return now.state == state; });
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

TEST_P(Bridge, WhoAsksWhileHeIsToldTakesNoNewsFromTheOthers) {
  SessionBridge bridge(GetParam());
  bridge.open(sample("environment-2"));
  bridge.post(command::SetParameter{ParameterId::MaxSteps, 3000});
  int notified = 0;
  QObject::connect(&bridge, &SessionBridge::snapshotChanged, [&](const SnapshotPtr& snapshot) {
    QThread::msleep(notified++ < 5 ? 20 : 0);  // longer than the session takes to publish the next snapshot
    EXPECT_EQ(bridge.snapshot(), snapshot);
  });
  bridge.post(command::Start{});
  ASSERT_TRUE(reach(bridge, SessionState::Failed));
  EXPECT_GT(notified, 0);
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
  other.object.first().geometry = BoxGeometry{{1.0, 1.0, 1.0}};
  other.start.position.z() += 1.0;
  auto loaded = loadGeometry(other, ".", before->file, before->geometry);
  ASSERT_TRUE(loaded.ok());
  const double larger = loaded->problem.world->objectRadius() / before->problem.world->objectRadius();
  bridge.rearrange(std::make_shared<const LoadedScenario>(std::move(*loaded)));
  const SnapshotPtr now = bridge.snapshot();
  EXPECT_EQ(now->seed, 77U);
  EXPECT_EQ(now->plannerId, "birrt");
  EXPECT_EQ(now->parameters[ParameterId::Alpha], 0.625);
  EXPECT_EQ(now->state, SessionState::Idle);
  EXPECT_EQ(now->device.q_device, other.start);
  // Parameters that depend on the object's size are computed again.
  EXPECT_NEAR(now->parameters[ParameterId::GrowthStep], larger * before->parameters[ParameterId::GrowthStep], 1e-12);
}

TEST_P(Bridge, APathThatWasFoundGoesAlongAsFarAsItHolds) {
  const ScenarioPtr before = slidingPlane();
  const auto rearranged = [&](const Vector3& move) {
    Scenario scenario = before->scenario;
    scenario.bodies.front().pose.position += move;
    auto loaded = loadGeometry(scenario, folderOf(before->file), before->file, before->geometry);
    return std::make_shared<const LoadedScenario>(std::move(*loaded));
  };
  const auto settled = [](const SessionSnapshot& now) { return now.path || now.refused; };
  SessionBridge bridge(GetParam());
  bridge.open(before);
  bridge.setDevice("expert");
  bridge.post(command::Start{});
  ASSERT_TRUE(reach(bridge, SessionState::Solved));
  const std::vector<Pose> found = bridge.snapshot()->path->configurations();

  bridge.rearrange(rearranged({0.0, 0.0, 0.2}));  // onto the path
  ASSERT_TRUE(reach(bridge, settled));
  ASSERT_NE(bridge.snapshot()->refused, nullptr);
  EXPECT_FALSE(bridge.snapshot()->refused->blocked.empty());
  bridge.rearrange(rearranged({0.0, 0.0, -0.2}));
  bridge.rearrange(before);  // at once, while the examination of the path has hardly begun
  ASSERT_TRUE(reach(bridge, SessionState::Solved));
  EXPECT_EQ(bridge.snapshot()->path->configurations(), found);
  bridge.setDevice("novice");
  ASSERT_TRUE(reach(bridge, SessionState::Solved));
  EXPECT_EQ(bridge.snapshot()->path->configurations(), found);

  Scenario other = before->scenario;
  other.object.first().id = "another";
  auto another = loadGeometry(other, folderOf(before->file), before->file, before->geometry);
  bridge.rearrange(std::make_shared<const LoadedScenario>(std::move(*another)));
  bridge.post(command::SetSeed{5});
  ASSERT_TRUE(reach(bridge, [](const SessionSnapshot& now) { return now.seed == 5; }));
  EXPECT_FALSE(settled(*bridge.snapshot()));
  bridge.rearrange(before);  // the first object again
  ASSERT_TRUE(reach(bridge, SessionState::Solved));
  EXPECT_EQ(bridge.snapshot()->path->configurations(), found);
  bridge.open(before);
  bridge.post(command::SetSeed{6});
  ASSERT_TRUE(reach(bridge, [](const SessionSnapshot& now) { return now.seed == 6; }));
  EXPECT_FALSE(settled(*bridge.snapshot()));
}

TEST_P(Bridge, ARunOutlivesAnotherNameOfABody) {
  const ScenarioPtr before = slidingPlane();
  Scenario renamed = before->scenario;
  renamed.bodies.front().name = "renamed";
  auto loaded = loadGeometry(renamed, folderOf(before->file), before->file, before->geometry);
  const auto after = std::make_shared<const LoadedScenario>(std::move(*loaded));
  SessionBridge bridge(GetParam());
  bridge.open(before);
  bridge.setDevice("expert");
  bridge.post(command::Start{});
  ASSERT_TRUE(reach(bridge, SessionState::Solved));
  const std::shared_ptr<const Path> path = bridge.snapshot()->path;
  const std::uint64_t nodes = bridge.snapshot()->counts.nodes;
  QSignalSpy spy(&bridge, &SessionBridge::snapshotChanged);
  bridge.rearrange(after);
  EXPECT_FALSE(spy.isEmpty()) << "observers of the arrangement wait for a snapshot";
  EXPECT_EQ(bridge.snapshot()->path, path);
  EXPECT_EQ(bridge.snapshot()->counts.nodes, nodes);
  EXPECT_GT(nodes, 2U);
  bridge.forgetPath();  // a step by hand ends: its path belongs to other bodies
  bridge.rearrange(before);
  EXPECT_EQ(bridge.snapshot()->path, nullptr);
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
