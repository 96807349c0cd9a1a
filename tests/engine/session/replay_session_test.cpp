#include "engine/session/replay_session.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/operator/device_registry.h"
#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/session/run_comparison.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

/// Changes all inputs at random while a run goes on. The draws depend on the seed only.
class RandomInputs {
 public:
  RandomInputs(const Problem& problem, std::uint64_t seed) : problem_(problem), random_(seed, "inputs") {}

  SessionConfig config() {
    SessionConfig config = sessionConfig(problem_);
    const auto planners = idsOf(makePlannerRegistry());
    const double draw = random_.uniform();
    config.plannerId = draw < 0.5 ? "contact-birrt" : draw < 0.75 ? "interactive" : planners[index(planners.size())];
    config.seed = 1 + index(1000);
    const std::vector<std::string> operators{"expert", "default", "novice"};
    if (random_.uniform() < 0.8) {
      const Pose* goal = std::get_if<Pose>(&problem_.goal);
      config.device = makeDeviceRegistry()
                          .find(operators[index(operators.size())])
                          ->make({{*goal}, problem_.metric(), config.seed, nullptr, problem_.world});
    }
    config.problem.scene.edits = edits();
    const bool multiLayer = makePlannerRegistry().find(config.plannerId)->multiLayer;
    if (multiLayer && random_.uniform() < 0.5) config.problem.scene.knowledge = knowledge(config.problem);
    return config;
  }

  Command command() {
    switch (index(7)) {
      case 0: return command::SetParameter{ParameterId::Alpha, random_.uniform()};
      case 1: return command::SetParameter{ParameterId::ContactSamples, 1.0 + static_cast<double>(index(20))};
      case 2:
        return command::SetParameter{ParameterId::ContactDistance, random_.uniform() * problem_.world->objectRadius()};
      case 3: return command::SetSemantics{edits()};
      case 4: return command::SetParameter{ParameterId::Tuning, static_cast<double>(index(8))};
      case 5: return command::SetSeed{index(100)};  // for the next run, without effect on this one
      default: return command::SetDevicePose{randomPose(random_, 1.0)};
    }
  }

  std::uint64_t index(std::size_t count) { return random_.bits() % count; }

 private:
  std::shared_ptr<const SemanticEdits> edits() {
    auto edits = std::make_shared<SemanticEdits>();
    PlaceEdit place;
    for (int i = 0; i < 3; ++i) place.at[i] = random_.uniform(-1.8, 1.8);
    place.attributes["preference"] = random_.uniform(1.0, 5.0);
    edits->places.push_back(place);
    if (random_.uniform() < 0.3) edits->milestones.push_back({place.at, randomPose(random_, 1.0)});
    if (random_.uniform() < 0.3) edits->bodies["left"]["mobility"] = std::string("mobile");
    return edits;
  }

  static SceneKnowledgePtr knowledge(const Problem& problem) {
    auto built = buildSceneKnowledge(problem, 1e-4);
    return built ? *built : nullptr;
  }

  const Problem& problem_;
  RandomStream random_;
};

std::optional<RunDifference> replayAndCompare(const Problem& problem, const RunLog& log, RunLog* replayed = nullptr) {
  const auto prepared = withRecordedKnowledge(problem, log);
  if (!prepared) throw std::runtime_error(toString(prepared.error()));
  const auto replay = makeReplaySession(*prepared, std::make_shared<const RunLog>(log));
  replay->post(command::Start{});
  while (replay->snapshot()->run == 0 || isRunning(*replay->snapshot())) replay->advance(77);
  const RunLog again = joined(replay->snapshot()->log);
  if (replayed != nullptr) *replayed = again;
  return firstDifference(log, again);
}

void expectSame(const std::optional<RunDifference>& difference, const RunLog& log, std::uint64_t seed) {
  EXPECT_FALSE(difference) << "seed " << seed << ", planner " << log.start.planner << ": recorded "
                           << difference->recorded.nodes << " nodes at step " << difference->recorded.step
                           << ", replayed " << difference->replayed.nodes << " at " << difference->replayed.step;
}

TEST(ReplaySession, AHundredRunsReplayBitByBit) {
  const Problem problem = windowProblem();
  int withSteps = 0;
  std::size_t changes = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomInputs inputs(problem, seed);
    const auto session = makeLockstepSession(inputs.config());
    session->post(command::Start{});
    for (int slice = 0; slice < 12; ++slice) {
      session->advance(inputs.index(25));
      if (inputs.index(3) == 0) {
        session->post(command::Pause{});
        session->advance(inputs.index(10));
        session->post(command::Resume{});
      }
      session->post(inputs.command());
    }
    session->post(command::Stop{});
    session->advance(0);
    const RunLog log = joined(session->snapshot()->log);
    withSteps += log.end.has_value() ? 1 : 0;
    changes += log.parameterChanges.size() + log.semanticChanges.size();
    expectSame(replayAndCompare(problem, log), log, seed);
  }
  EXPECT_GT(withSteps, 90);
  EXPECT_GT(changes, 200U);
}

TEST(ReplaySession, WhatSetItselfIsAsItWasAtTheEnd) {
  const Problem problem = closedProblem();
  SessionConfig config = sessionConfig(problem, std::make_unique<HomingDevice>(Vector3(-0.35, 0.5, 0.2)));
  ASSERT_TRUE(config.parameters.set(ParameterId::Tuning, kTunedAll));
  const auto session = makeLockstepSession(std::move(config));
  session->post(command::Start{});
  session->advance(300);
  session->post(command::SetParameter{ParameterId::ContactSamples, 7});  // resets the automatic setting
  session->advance(300);
  session->post(command::Stop{});
  session->advance(0);
  const RunLog log = joined(session->snapshot()->log);
  expectSame(replayAndCompare(problem, log), log, 1);
  const auto replay = makeReplaySession(problem, std::make_shared<const RunLog>(log));
  replay->post(command::Start{});
  while (replay->snapshot()->run == 0 || isRunning(*replay->snapshot())) replay->advance(77);
  const SnapshotPtr was = session->snapshot();
  const SnapshotPtr is = replay->snapshot();
  for (const ParameterId id :
       {ParameterId::Tuning, ParameterId::Alpha, ParameterId::ContactSamples, ParameterId::ContactDistance}) {
    EXPECT_EQ(valueInForce(*is, id), valueInForce(*was, id)) << specOf(id).key;
  }
  EXPECT_EQ(valueInForce(*is, ParameterId::ContactSamples), 7.0);
  EXPECT_NE(valueInForce(*is, ParameterId::Alpha), was->parameters[ParameterId::Alpha]);
}

TEST(ReplaySession, RunsInRealTimeReplayBitByBit) {
  const Problem problem = closedProblem();
  std::uint64_t steps = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomInputs inputs(problem, seed);
    const auto session = makeThreadedSession(inputs.config());
    session->post(command::Start{});
    for (int i = 0; i < 30; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(inputs.index(6)));
      session->post(inputs.command());
      if (inputs.index(4) == 0) session->post(command::Pause{});
      if (inputs.index(2) == 0) session->post(command::Resume{});
    }
    session->post(command::Stop{});
    ASSERT_TRUE(waitFor(*session, hasEnded));
    const RunLog log = joined(session->snapshot()->log);
    steps += log.end ? log.end->step : 0;
    expectSame(replayAndCompare(problem, log), log, seed);
  }
  EXPECT_GT(steps, 100U);
}

RunLog recordedRun(const Problem& problem, std::uint64_t steps) {
  const auto session =
      makeLockstepSession(sessionConfig(problem, std::make_unique<HomingDevice>(Vector3(-0.35, 0.5, 0.2))));
  session->post(command::Start{});
  session->advance(100);
  session->post(command::SetParameter{ParameterId::Alpha, 0.7});
  session->advance(steps - 100);
  session->post(command::Stop{});
  session->advance(0);
  return joined(session->snapshot()->log);
}

TEST(ReplaySession, AnAlteredLogIsFoundToDifferAtTheFirstCheckpoint) {
  const RunLog log = recordedRun(closedProblem(), 2500);
  ASSERT_EQ(log.checkpoints.size(), 2U);
  EXPECT_FALSE(replayAndCompare(closedProblem(), log));
  RunLog altered = log;
  altered.checkpoints[1].hash ^= 1U;
  const auto difference = replayAndCompare(closedProblem(), altered);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->same, 1000U);
  EXPECT_EQ(difference->recorded.step, 2000U);
  RunLog moved = log;
  moved.operatorStream[3].q_device->position.y() += 1e-12;
  const auto early = replayAndCompare(closedProblem(), moved);
  ASSERT_TRUE(early);
  EXPECT_EQ(early->same, 0U);
}

TEST(ReplaySession, AReplayLogsWhatItWasGiven) {
  const RunLog log = recordedRun(closedProblem(), 500);
  RunLog again;
  EXPECT_FALSE(replayAndCompare(closedProblem(), log, &again));
  ASSERT_EQ(again.operatorStream.size(), log.operatorStream.size());
  for (std::size_t i = 0; i < log.operatorStream.size(); ++i) {
    EXPECT_EQ(again.operatorStream[i].step, log.operatorStream[i].step);
    EXPECT_EQ(*again.operatorStream[i].q_device, *log.operatorStream[i].q_device);
  }
  ASSERT_EQ(again.parameterChanges.size(), 1U);
  EXPECT_EQ(again.parameterChanges[0].step, 100U);
  EXPECT_EQ(again.end->seconds, log.end->seconds);
}

TEST(ReplaySession, AnotherParameterMakesAnotherRunThatGoesOn) {
  RunLog log = recordedRun(closedProblem(), 300);
  overrideParameter(ParameterId::Alpha, 0.05, log);
  EXPECT_TRUE(log.parameterChanges.empty());
  const auto replay = makeReplaySession(closedProblem(), std::make_shared<const RunLog>(log), ReplayEnd::Continue);
  replay->post(command::Start{});
  replay->advance(400);
  EXPECT_EQ(replay->snapshot()->counts.steps, 400U);
  EXPECT_EQ(replay->snapshot()->parameters[ParameterId::Alpha], 0.05);
  EXPECT_TRUE(firstDifference(recordedRun(closedProblem(), 300), joined(replay->snapshot()->log)));
}

TEST(ReplayTrack, TellsTheRoadmapOfEveryStep) {
  const RunLog log = recordedRun(closedProblem(), 200);
  const auto replay = makeReplaySession(closedProblem(), std::make_shared<const RunLog>(log));
  replay->post(command::Start{});
  replay->advance(200);
  const auto track = replay->track();
  EXPECT_EQ(track->stride(), 1U);
  EXPECT_EQ(track->at(0).nodes, 0U);
  EXPECT_EQ(track->at(200).nodes, allNodes(replay->snapshot()->roadmap).size());
  for (std::uint64_t step = 1; step <= 200; ++step) {
    EXPECT_EQ(track->at(step).counts.steps, step);
    EXPECT_GE(track->at(step).nodes, track->at(step - 1).nodes);
  }
}

TEST(RunLogTimes, AreStraightBetweenCheckpoints) {
  RunLog log;
  EXPECT_DOUBLE_EQ(secondsAt(log, 40), 1.0);
  log.checkpoints = {{1000, 0, 0, 0, 10.0}, {2000, 0, 0, 0, 40.0}};
  log.end = RunCheckpoint{2100, 0, 0, 0, 42.0};
  EXPECT_DOUBLE_EQ(secondsAt(log, 500), 5.0);
  EXPECT_DOUBLE_EQ(secondsAt(log, 1500), 25.0);
  EXPECT_DOUBLE_EQ(secondsAt(log, 2050), 41.0);
  for (const std::uint64_t step : {0U, 1U, 999U, 1000U, 1001U, 2099U, 2100U}) {
    EXPECT_EQ(stepAt(log, secondsAt(log, step)), step);
  }
}

}  // namespace
}  // namespace glissade
