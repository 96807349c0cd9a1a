// Tests in every strategy that no path leads through a forbidden place.
#include <gtest/gtest.h>

#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/session/session_with_planners.h"
#include "engine/study/benchmarks/peer_planners.h"
#include "tests/engine/support/environment_worlds.h"
#include "tests/engine/support/forbidden_boxes.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

constexpr std::uint64_t kMostSteps = 60'000;

/// Two rooms with a wall between them, at x = 1, that has a window on either side.
const Vector3 kNearWindow(1.0, 0.25, 0.5);
const Vector3 kFarWindow(1.0, 0.75, 0.5);

std::vector<RigidBody> wallWithTwoWindows() {
  const auto between = [](const char* name, const Vector3& least, const Vector3& most) {
    return boxBody(name, most - least, Pose::translation((least + most) / 2.0));
  };
  return {between("below", {0.875, 0, 0}, {1.125, 1, 0.375}), between("above", {0.875, 0, 0.625}, {1.125, 1, 1}),
          between("near", {0.875, 0, 0.375}, {1.125, 0.125, 0.625}),
          between("middle", {0.875, 0.375, 0.375}, {1.125, 0.625, 0.625}),
          between("far", {0.875, 0.875, 0.375}, {1.125, 1, 0.625})};
}

Problem twoWindows() {
  Problem problem;
  problem.world =
      CollisionWorld::build(wallWithTwoWindows(), std::make_shared<const TriangleMesh>(makeBox({0.06, 0.06, 0.06})));
  problem.start = Pose::translation({0.4, 0.26, 0.49});
  problem.goal = Pose::translation({1.6, 0.27, 0.51});
  problem.bounds = test::twoRooms();
  problem.scene.environment.topologyLevel = 5;
  problem.scene.environment.cellSize = 2.0 / 64.0;
  return problem;
}

SemanticEditsPtr forbidding(const std::vector<Vector3>& points) {
  SemanticEdits edits;
  for (const Vector3& at : points) edits.places.push_back({at, "", {{"forbidden", true}}});
  return std::make_shared<const SemanticEdits>(edits);
}

ForbiddenPlaces placesOf(const Problem& problem, const SemanticEditsPtr& edits) {
  const auto environment = buildEnvironmentOf(problem);
  EXPECT_TRUE(environment.ok());
  const auto places = forbiddenPlacesOf((*environment)->map, *edits);
  EXPECT_TRUE(places.ok()) << toString(places.error());
  return *places;
}

std::unique_ptr<LockstepSession> sessionOf(const Problem& problem, const std::string& strategy,
                                           std::uint64_t seed = 1) {
  SessionConfig config = sessionConfig(problem);
  config.plannerId = strategy;
  config.seed = seed;
  EXPECT_TRUE(config.parameters.set(ParameterId::MaxSteps, kMostSteps));
  EXPECT_TRUE(config.parameters.set(ParameterId::StepSamples, 5000));
  EXPECT_TRUE(config.parameters.set(ParameterId::Smoothing, 50));
  return makeLockstepSession(std::move(config), makePlannerRegistryWithPeers());
}

SnapshotPtr ended(LockstepSession& session) {
  session.post(command::Start{});
  session.advance(0);
  while (isRunning(*session.snapshot())) session.advance(1000);
  return session.snapshot();
}

class Forbidden : public testing::TestWithParam<std::string> {
 protected:
  /// False for unmodified OMPL planners, which may give up, and for the paper's strategies without a loop, which do.
  bool isComplete() const { return makePlannerRegistryWithPeers().find(GetParam())->complete; }
};

TEST_P(Forbidden, APathLeadsAroundThePlace) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({kNearWindow});
  const ForbiddenPlaces places = placesOf(problem, problem.scene.edits);
  ASSERT_EQ(places.size(), 1U);
  const auto session = sessionOf(problem, GetParam());
  const SnapshotPtr end = ended(*session);
  if (isComplete()) {
    ASSERT_EQ(end->state, SessionState::Solved) << toString(end->problem.value_or(Diagnostic()));
  }
  if (end->path) {
    EXPECT_EQ(test::metBy(end->path->configurations(), places, test::forbiddenMarginOf(*problem.world)), "");
  } else {
    EXPECT_NE(toString(end->problem->reason).find(places.front().name), std::string::npos) << toString(*end->problem);
  }
}

TEST_P(Forbidden, WithoutAWayTheRunFailsAndNamesWhatIsForbidden) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({kNearWindow, kFarWindow});
  const ForbiddenPlaces places = placesOf(problem, problem.scene.edits);
  ASSERT_EQ(places.size(), 2U);
  const auto session = sessionOf(problem, GetParam());
  session->post(command::SetParameter{ParameterId::MaxSteps, 6000});
  session->post(command::SetParameter{ParameterId::StepSamples, 1000});
  const SnapshotPtr end = ended(*session);
  ASSERT_EQ(end->state, SessionState::Failed);
  EXPECT_EQ(end->path, nullptr);
  for (const ForbiddenPlace& place : places) {
    EXPECT_NE(toString(end->problem->reason).find(place.name), std::string::npos) << toString(*end->problem);
  }
}

TEST_P(Forbidden, APlaceThatIsForbiddenWhileARunGoesOnIsNotOnItsPath) {
  const Problem problem = twoWindows();
  const SemanticEditsPtr edits = forbidding({kNearWindow});
  const ForbiddenPlaces places = placesOf(problem, edits);
  for (const std::uint64_t steps : {3U, 40U, 150U}) {
    const auto session = sessionOf(problem, GetParam());
    session->post(command::Start{});
    session->advance(steps);
    const bool running = isRunning(*session->snapshot());
    session->post(command::SetSemantics{edits});
    session->advance(0);
    while (isRunning(*session->snapshot())) session->advance(1000);
    const SnapshotPtr end = session->snapshot();
    if (running && isComplete() && !end->path) {
      // The path was found before, and is withdrawn.
      EXPECT_NE(toString(end->problem->reason).find("forbidden"), std::string::npos) << toString(*end->problem);
    }
    if (end->path) {
      EXPECT_EQ(test::metBy(end->path->configurations(), places, test::forbiddenMarginOf(*problem.world)), "") << steps;
    }
    EXPECT_TRUE(end->path || end->refused || end->problem) << steps;
  }
}

/// A wall with one gap, from the floor of the workspace up. Start and goal are on the floor, which is a face of the
/// place in the gap.
Problem gapOnTheFloor() {
  Problem problem = twoWindows();
  const auto between = [](const char* name, const Vector3& least, const Vector3& most) {
    return boxBody(name, most - least, Pose::translation((least + most) / 2.0));
  };
  problem.world = CollisionWorld::build(
      {between("near", {0.875, 0, 0}, {1.125, 0.375, 1}), between("far", {0.875, 0.625, 0}, {1.125, 1, 1})},
      std::make_shared<const TriangleMesh>(makeBox({0.06, 0.06, 0.06})));
  problem.start = Pose::translation({0.4, 0.5, 0.0});
  problem.goal = Pose::translation({1.6, 0.5, 0.0});
  problem.scene.edits = forbidding({{1.0, 0.5, 0.5}});
  return problem;
}

/// A hand that moves straight to the goal, on the floor, does not help either.
TEST_P(Forbidden, ThePlaneOfTheFloorIsNoWay) {
  const Problem problem = gapOnTheFloor();
  const ForbiddenPlaces places = placesOf(problem, problem.scene.edits);
  ASSERT_EQ(places.size(), 1U);
  ASSERT_EQ(places[0].boxes[0].min().z(), problem.bounds.min().z());
  SessionConfig config = sessionConfig(problem, std::make_unique<HomingDevice>(std::get<Pose>(problem.goal).position));
  config.plannerId = GetParam();
  EXPECT_TRUE(config.parameters.set(ParameterId::MaxSteps, 1000));
  EXPECT_TRUE(config.parameters.set(ParameterId::StepSamples, 300));
  EXPECT_TRUE(config.parameters.set(ParameterId::Smoothing, 20));
  const auto session = makeLockstepSession(std::move(config), makePlannerRegistryWithPeers());
  const SnapshotPtr end = ended(*session);
  ASSERT_EQ(end->state, SessionState::Failed);
  EXPECT_EQ(end->path, nullptr);
  EXPECT_NE(toString(end->problem->reason).find(places.front().name), std::string::npos) << toString(*end->problem);
}

std::vector<std::string> everyStrategy() { return idsOf(makePlannerRegistryWithPeers()); }

INSTANTIATE_TEST_SUITE_P(Strategies, Forbidden, testing::ValuesIn(everyStrategy()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(ForbiddenPlace, TheStartAndTheGoalInsideOfOneAreSaid) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({problem.start.position});
  SnapshotPtr end = ended(*sessionOf(problem, "gts"));
  ASSERT_EQ(end->state, SessionState::Failed);
  EXPECT_EQ(toString(end->problem->location), "start");
  EXPECT_NE(toString(end->problem->reason).find("forbidden"), std::string::npos);
  problem.scene.edits = forbidding({std::get<Pose>(problem.goal).position});
  end = ended(*sessionOf(problem, "auto"));
  ASSERT_EQ(end->state, SessionState::Failed);
  EXPECT_EQ(toString(end->problem->location), "goal");
}

TEST(ForbiddenPlace, TheStartOnItsBoundaryIsSaid) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({kNearWindow});
  const Box3 box = placesOf(problem, problem.scene.edits).front().boxes.front();
  const double margin = test::forbiddenMarginOf(*problem.world);
  for (const double beside : {0.0, 0.9 * margin}) {
    problem.start.position = {box.min().x() - beside, box.center().y(), box.center().z()};
    const SnapshotPtr end = ended(*sessionOf(problem, "gts"));
    ASSERT_EQ(end->state, SessionState::Failed);
    EXPECT_EQ(toString(end->problem->location), "start");
    EXPECT_NE(toString(end->problem->reason).find("lies on the boundary of"), std::string::npos)
        << toString(*end->problem);
  }
}

TEST(ForbiddenPlace, AGivenPathThatTouchesItIsRefused) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({kNearWindow});
  const Box3 box = placesOf(problem, problem.scene.edits).front().boxes.front();
  const Vector3& corner = box.min();
  const auto examined = [&](const std::vector<Vector3>& positions) {
    Problem asked = problem;
    asked.start = Pose::translation(positions.front());
    asked.goal = Pose::translation(positions.back());
    std::vector<PathPoint> points;
    for (const Vector3& position : positions) points.push_back({Pose::translation(position), Author::Computer});
    const auto session = sessionOf(asked, "gts");
    session->post(command::ExaminePath{points, {}});
    session->advance(0);
    const SnapshotPtr end = session->snapshot();
    if (end->path) return true;
    EXPECT_EQ(end->refused->blocked.front().nearest.body, kForbiddenPlace);
    return false;
  };
  const double before = corner.x() - 0.1;
  const Vector3 onFace(corner.x(), box.center().y(), box.center().z());
  const Vector3 away(before, box.center().y(), box.center().z());
  EXPECT_FALSE(examined({away, onFace, away})) << "up to a face";
  EXPECT_FALSE(examined({{before, corner.y(), corner.z()}, corner, {before, corner.y(), corner.z()}})) << "a corner";
  EXPECT_TRUE(examined({away, onFace - Vector3(0.01, 0.0, 0.0), away}));
}

TEST(ForbiddenPlace, ThatIsNotThereIsSaid) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({test::kFarAway});
  const SnapshotPtr end = ended(*sessionOf(problem, "contact-birrt"));
  ASSERT_EQ(end->state, SessionState::Failed);
  EXPECT_EQ(toString(end->problem->location), "/places/0");
  EXPECT_EQ(end->problem->kind, ErrorKind::MalformedInput);
}

TEST(ForbiddenPlace, AfterTheRunItWithdrawsThePathAndAllowedAgainItIsCrossed) {
  const Problem problem = twoWindows();
  const auto session = sessionOf(problem, "gts");
  ASSERT_EQ(ended(*session)->state, SessionState::Solved);
  const SemanticEditsPtr edits = forbidding({kNearWindow});
  ASSERT_NE(test::metBy(session->snapshot()->path->configurations(), placesOf(problem, edits), 0.0), "");
  session->post(command::SetSemantics{edits});
  session->advance(0);
  EXPECT_EQ(session->snapshot()->path, nullptr);
  ASSERT_NE(session->snapshot()->refused, nullptr);
  EXPECT_FALSE(session->snapshot()->refused->blocked.empty());
  session->post(command::SetSemantics{forbidding({})});
  session->advance(0);
  EXPECT_EQ(session->snapshot()->state, SessionState::Solved) << "the path holds again";
  EXPECT_EQ(session->snapshot()->refused, nullptr);
  EXPECT_NE(session->snapshot()->path, nullptr);
  EXPECT_EQ(ended(*session)->state, SessionState::Solved);
}

TEST(ForbiddenPlace, TheReasonOfAFailureEndsWithTheEditsThatItIsAbout) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({problem.start.position});
  const auto session = sessionOf(problem, "gts");
  ASSERT_EQ(ended(*session)->state, SessionState::Failed);
  ASSERT_TRUE(session->snapshot()->problem);
  session->post(command::SetSemantics{forbidding({})});
  session->advance(0);
  EXPECT_EQ(session->snapshot()->state, SessionState::Idle);
  EXPECT_FALSE(session->snapshot()->problem);
}

TEST(ForbiddenPlace, AGivenPathThroughItIsRefused) {
  Problem problem = twoWindows();
  problem.scene.edits = forbidding({kNearWindow});
  const auto session = sessionOf(problem, "gts");
  std::vector<PathPoint> points{{problem.start, Author::Computer},
                                {Pose::translation(kNearWindow), Author::Computer},
                                {std::get<Pose>(problem.goal), Author::Computer}};
  session->post(command::ExaminePath{points, {}});
  session->advance(0);
  EXPECT_EQ(session->snapshot()->path, nullptr);
  ASSERT_NE(session->snapshot()->refused, nullptr);
  EXPECT_EQ(session->snapshot()->refused->blocked.front().nearest.body, kForbiddenPlace);
}

TEST(ForbiddenPlace, ARunWithoutProhibitionsIsTheSameBitByBit) {
  for (const std::string strategy : {"gts", "auto", "contact-birrt", "ompl-rrtconnect"}) {
    Problem free = twoWindows();
    const SnapshotPtr without = ended(*sessionOf(free, strategy));
    free.scene.edits = forbidding({});
    const SnapshotPtr with = ended(*sessionOf(free, strategy));
    ASSERT_EQ(without->state, SessionState::Solved);
    EXPECT_EQ(without->path->configurations(), with->path->configurations()) << strategy;
    EXPECT_EQ(without->counts.steps, with->counts.steps) << strategy;
  }
}

}  // namespace
}  // namespace glissade
