// Tests two local trees between two configurations of a way.
#include "engine/planning/interactive/gap_search.h"

#include <gtest/gtest.h>

#include "engine/files/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/test_host.h"

namespace glissade {
namespace {

/// In a burr with a play of 0.3 mm, round a corner of its channel, trees that do not slide need several times the
/// steps.
TEST(GapSearch, SlidesRoundACornerInContact) {
  const auto loaded = loadScenario(test::sourceDirectory() + "/samples/puzzles/burr.json");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  const Problem& problem = loaded->problem;
  const auto worlds = std::make_shared<ErodedWorlds>(problem.world);
  constexpr std::uint64_t kSteps = 1'000;
  std::uint64_t steps = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TestHost host(problem, kSteps);
    GapSearch search(problem, Pose::translation({0.02, 0.02, 0.02}), Pose::translation({0.03, 0.02, 0.03}), 0.003, seed,
                     worlds);
    while (search.steps() < kSteps && !search.step(host)) {
    }
    steps += search.steps();
  }
  EXPECT_LT(steps, 2'000U);
}

}  // namespace
}  // namespace glissade
