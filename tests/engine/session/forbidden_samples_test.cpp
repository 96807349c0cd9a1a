// Tests samples with forbidden places by an independent clipping of the delivered paths. The campaign
// (GLISSADE_FORBIDDEN=all, packaging/reliability.sh) has the pump, every strategy for places and more shape games.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "engine/base/random_stream.h"
#include "tests/engine/support/forbidden_boxes.h"
#include "tests/engine/support/session_support.h"
#include "tests/engine/support/shape_game.h"

namespace glissade {
namespace {

bool isCampaign() {
  const char* text = std::getenv("GLISSADE_FORBIDDEN");
  return text != nullptr && std::strcmp(text, "all") == 0;
}

std::vector<std::string> strategies() {
  if (!isCampaign()) return {"gts", "auto"};
  return {"gts", "gt", "gts1", "gts2", "auto", "contact-birrt", "birrt", "ompl-rrtconnect"};
}

struct KnownScenario {
  LoadedScenario loaded;
  SceneKnowledgePtr knowledge;

  const TopologicalMap& map() const { return knowledge->environment->map; }
  /// True if neither the start nor the goal is in the place.
  bool isMiddle(std::size_t place) const {
    const auto number = static_cast<int>(place);
    const Pose* goal = std::get_if<Pose>(&loaded.problem.goal);
    return map().placeAt(loaded.problem.start.position) != number &&
           (goal == nullptr || map().placeAt(goal->position) != number);
  }
};

KnownScenario known(const std::string& file) {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/" + file);
  if (!loaded) throw std::runtime_error(toString(loaded.error()));
  auto knowledge = buildSceneKnowledge(loaded->problem, loaded->parameters[ParameterId::RequiredClearance]);
  if (!knowledge) throw std::runtime_error(toString(knowledge.error()));
  return {std::move(*loaded), *knowledge};
}

SemanticEditsPtr forbidding(const KnownScenario& scenario, const std::vector<std::size_t>& places) {
  SemanticEdits edits = *scenario.loaded.problem.scene.edits;
  for (const std::size_t place : places) {
    edits.places.push_back({scenario.map().places[place].anchor, "", {{"forbidden", true}}});
  }
  return std::make_shared<const SemanticEdits>(edits);
}

/// Plans and checks that a path avoids the places, and that without a path the reason names them.
SnapshotPtr planned(const KnownScenario& scenario, const std::vector<std::size_t>& places, const std::string& strategy,
                    std::uint64_t steps) {
  SessionConfig config{scenario.loaded.problem, scenario.loaded.parameters, strategy, 1, nullptr};
  config.problem.scene.knowledge = scenario.knowledge;
  config.problem.scene.edits = forbidding(scenario, places);
  EXPECT_TRUE(config.parameters.set(ParameterId::MaxSteps, static_cast<double>(steps)));
  EXPECT_TRUE(config.parameters.set(ParameterId::StepSamples, 2000.0));
  EXPECT_TRUE(config.parameters.set(ParameterId::Smoothing, 20.0));
  const auto stated = forbiddenPlacesOf(scenario.map(), *config.problem.scene.edits);
  EXPECT_TRUE(stated.ok());
  const auto session = makeLockstepSession(std::move(config));
  session->post(command::Start{});
  session->advance(0);
  while (isRunning(*session->snapshot())) session->advance(1000);
  const SnapshotPtr end = session->snapshot();
  if (end->path) {
    EXPECT_EQ(
        test::metBy(end->path->configurations(), *stated, test::forbiddenMarginOf(*scenario.loaded.problem.world)), "")
        << strategy;
  } else {
    EXPECT_NE(toString(end->problem->reason).find("forbidden"), std::string::npos)
        << strategy << ": " << toString(*end->problem);
  }
  return end;
}

void forbidEachAndAll(const KnownScenario& scenario, std::uint64_t steps) {
  std::vector<std::size_t> middle;
  for (std::size_t place = 0; place < scenario.map().places.size(); ++place) {
    if (scenario.isMiddle(place)) middle.push_back(place);
  }
  ASSERT_FALSE(middle.empty());
  for (const std::string& strategy : strategies()) {
    for (const std::size_t place : middle) {
      SCOPED_TRACE(scenario.map().places[place].name);
      planned(scenario, {place}, strategy, steps);
    }
    planned(scenario, middle, strategy, steps);
  }
}

TEST(ForbiddenSamples, TheTeachingScenarioWithEachPlaceForbidden) {
  forbidEachAndAll(known("teaching/scenario.json"), isCampaign() ? 50'000 : 3'000);
}

TEST(ForbiddenSamples, ThePumpWithEachPlaceForbidden) {
  if (!isCampaign()) GTEST_SKIP() << "in the campaign only";
  forbidEachAndAll(known("pump/unmount.json"), 50'000);
  forbidEachAndAll(known("pump/mount.json"), 50'000);
}

/// The game has a hole for each shape. With one hole forbidden, the other holes are alternatives for a small object.
TEST(ForbiddenSamples, ShapeGamesWithRandomPlacesForbidden) {
  RandomStream stream(1, "shape games");
  const int games = isCampaign() ? 20 : 4;
  for (int game = 0; game < games; ++game) {
    const char* shape = test::shapes()[static_cast<std::size_t>(game) % test::shapes().size()];
    const KnownScenario scenario = known(std::string("shape-game/tight-") + shape + ".json");
    std::vector<std::size_t> places;
    for (std::size_t place = 0; place < scenario.map().places.size(); ++place) {
      if (scenario.isMiddle(place) && stream.uniform() < 0.3) places.push_back(place);
    }
    if (places.empty()) continue;
    SCOPED_TRACE(std::string(shape) + ", game " + std::to_string(game));
    for (const std::string& strategy : strategies()) planned(scenario, places, strategy, isCampaign() ? 20'000 : 2'000);
  }
}

}  // namespace
}  // namespace glissade
