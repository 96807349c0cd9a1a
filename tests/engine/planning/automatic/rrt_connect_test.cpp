#include "engine/planning/automatic/rrt_connect.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// Lengths of the edges of trees in their order, in multiples of the range, after `draws` draws of which the first
/// `longDraws` are long.
std::vector<double> edgeLengths(const Problem& problem, std::uint64_t draws, std::uint64_t longDraws) {
  RrtConnect::Options options;
  options.range = searchRange(problem, 0.02);
  options.longDraws = longDraws;
  RrtConnect planner(problem, 1, options, std::make_unique<UniformSampler>(problem, 1));
  TestHost host(problem, draws);
  EXPECT_FALSE(planner.solve(host));
  std::vector<double> lengths;
  for (const RoadmapEdge& edge : planner.edges()) {
    const double length = problem.metric().distance(planner.nodes()[edge.from].q, planner.nodes()[edge.to].q);
    lengths.push_back(length / options.range);
  }
  return lengths;
}

double longest(const std::vector<double>& lengths) { return *std::max_element(lengths.begin(), lengths.end()); }

TEST(RrtConnect, BeginsWithLongExtensionsWhereItIsAskedTo) {
  const Problem problem = closedProblem();
  EXPECT_LE(longest(edgeLengths(problem, 300, 0)), 1.0 + 1e-9);
  const double first = longest(edgeLengths(problem, 10, 10));
  EXPECT_GT(first, 5.0);
  EXPECT_LE(first, 10.0 + 1e-9);
  EXPECT_EQ(first, longest(edgeLengths(problem, 300, 10))) << "later ones are short again";
}

/// The wall of closedProblem() among posts with gaps that are little wider than the object.
Problem amongPosts() {
  Problem problem = closedProblem();
  std::vector<RigidBody> bodies{boxBody("wall", {0.2, 5.0, 5.0}, Pose::identity())};
  for (int column = -3; column <= 3; ++column) {
    for (int row = -3; row <= 3; ++row) {
      const std::string name = "post" + std::to_string(bodies.size());
      bodies.push_back(boxBody(name, {0.05, 0.05, 5.0}, Pose::translation({0.6 * column, 0.6 * row, 0.0})));
    }
  }
  problem.world = CollisionWorld::build(bodies, std::make_shared<const TriangleMesh>(makeBox({0.4, 0.4, 0.4})));
  problem.start = Pose::translation({-1.5, 0.3, 0.0});
  problem.goal = Pose::translation({1.5, 0.3, 0.5});
  return problem;
}

TEST(RrtConnect, LongExtensionsEndWhereFewAreFree) {
  const auto last = [](std::vector<double> lengths) {
    EXPECT_GT(lengths.size(), 40U);
    lengths.erase(lengths.begin(), lengths.end() - 20);
    return longest(lengths);
  };
  EXPECT_LE(last(edgeLengths(amongPosts(), 1000, 1000)), 1.0 + 1e-9);
  EXPECT_GT(last(edgeLengths(closedProblem(), 1000, 1000)), 5.0);
}

}  // namespace
}  // namespace glissade
