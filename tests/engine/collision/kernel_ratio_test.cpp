// Guards the ratio of FCL's time to the kernel's. Both run the same queries in turn and only CPU time counts, so that a
// busy machine does not matter much. The guards are at a third of the ratios measured on L and the pump
// (engine/README.md) or below. The whole comparison is collision_benchmark.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "tests/benchmarks/collision_models.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

TEST(KernelRatio, StaysFarAboveFcl) {
#ifndef NDEBUG
  GTEST_SKIP() << "without optimisation ratios say nothing";
#endif
  constexpr std::size_t kPoses = 100;
  constexpr int kRounds = 5;
  std::map<std::string, std::pair<double, int>> logarithms;
  for (const CollisionQuestion& question : collisionQuestions(test::sourceDirectory(), kPoses)) {
    auto& [sum, count] = logarithms[question.what];
    sum += std::log(timeRatio(question, kRounds));
    ++count;
  }
  const std::map<std::string, double> guards{{"collide", 9.0}, {"distance", 7.0}, {"edge", 3.5}, {"edge-first", 1.2}};
  ASSERT_EQ(logarithms.size(), guards.size());
  for (const auto& [what, guard] : guards) {
    const auto& [sum, count] = logarithms[what];
    const double ratio = std::exp(sum / count);
    RecordProperty(what, std::to_string(ratio));
    EXPECT_GT(ratio, guard) << what;
  }
}

}  // namespace
}  // namespace glissade
