#include "engine/planning/automatic/rrt_connect.h"

#include <gtest/gtest.h>

#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(RrtConnect, TellsItsSamplerOfEachNode) {
  class Listening final : public ConfigurationSampler {
   public:
    Listening(const Problem& problem, std::vector<Pose>& nodes) : uniform_(problem, 1), nodes_(nodes) {}
    Pose draw(const Box3& tree) override { return uniform_.draw(tree); }
    void grew(const Pose& q, CollisionQuery& query) override {
      EXPECT_FALSE(query.collides(q));
      nodes_.push_back(q);
    }

   private:
    UniformSampler uniform_;
    std::vector<Pose>& nodes_;
  };
  const Problem problem = windowProblem();
  RrtConnect::Options options;
  options.range = searchRange(problem, 0.03);
  options.slides = true;
  std::vector<Pose> told;
  RrtConnect planner(problem, 1, options, std::make_unique<Listening>(problem, told));
  TestHost host(problem, 200);
  planner.solve(host);
  ASSERT_EQ(planner.nodes().size(), told.size() + 2);  // the roots
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(planner.nodes()[i + 2].q, told[i]);
}

/// The longest edge of a tree, in multiples of the range, after `draws` draws of which the first `longDraws` are long.
double longestEdge(std::uint64_t draws, std::uint64_t longDraws) {
  Problem problem = closedProblem();
  RrtConnect::Options options;
  options.range = searchRange(problem, 0.02);
  options.longDraws = longDraws;
  RrtConnect planner(problem, 1, options, std::make_unique<UniformSampler>(problem, 1));
  TestHost host(problem, draws);
  EXPECT_FALSE(planner.solve(host));
  double longest = 0.0;
  for (const RoadmapEdge& edge : planner.edges()) {
    longest = std::max(longest, problem.metric().distance(planner.nodes()[edge.from].q, planner.nodes()[edge.to].q));
  }
  return longest / options.range;
}

TEST(RrtConnect, BeginsWithLongExtensionsWhereItIsAskedTo) {
  EXPECT_LE(longestEdge(300, 0), 1.0 + 1e-9);
  EXPECT_GT(longestEdge(300, 10), 5.0);
  EXPECT_LE(longestEdge(300, 10), 10.0 + 1e-9);
  EXPECT_EQ(longestEdge(10, 10), longestEdge(300, 10)) << "later ones are short again";
}

}  // namespace
}  // namespace glissade
