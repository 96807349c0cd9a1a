// Tests the places where a person can help a search: by brute force, and by FCL on its own boxes.
#include "engine/planning/difficulty/help_places.h"

#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include <set>

#include "engine/base/random_stream.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kCube = 0.4;

struct WallBox {
  std::string name;
  Vector3 size;
  Vector3 at;
};

/// A wall across x with a square window about a point.
std::vector<WallBox> wallWithWindow(double width, const Vector3& middle) {
  const double side = 3.0;
  const double off = 0.5 * (width + side);
  const double tall = 2.0 * side + width;
  return {{"left", {0.2, side, tall}, middle + Vector3(0.0, -off, 0.0)},
          {"right", {0.2, side, tall}, middle + Vector3(0.0, off, 0.0)},
          {"below", {0.2, width, side}, middle + Vector3(0.0, 0.0, -off)},
          {"above", {0.2, width, side}, middle + Vector3(0.0, 0.0, off)}};
}

Problem problemOf(const std::vector<WallBox>& wall) {
  std::vector<RigidBody> bodies;
  for (const WallBox& box : wall) bodies.push_back(boxBody(box.name, box.size, Pose::translation(box.at)));
  Problem problem = windowProblem();
  problem.world =
      CollisionWorld::build(bodies, std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(kCube))));
  return problem;
}

/// Depth of the cube in the wall by FCL's boxes, which use no meshes, no erosion and no kernel.
double depthByFcl(const std::vector<WallBox>& wall, const Pose& q) {
  const auto place = [](const Pose& pose) {
    fcl::Transform3d transform = fcl::Transform3d::Identity();
    transform.linear() = pose.orientation.toRotationMatrix();
    transform.translation() = pose.position;
    return transform;
  };
  const fcl::CollisionObjectd cube(std::make_shared<fcl::Boxd>(kCube, kCube, kCube), place(q));
  double depth = 0.0;
  for (const WallBox& box : wall) {
    const fcl::CollisionObjectd other(std::make_shared<fcl::Boxd>(box.size), place(Pose::translation(box.at)));
    fcl::CollisionResultd result;
    fcl::collide(&cube, &other, fcl::CollisionRequestd(16, true), result);
    std::vector<fcl::Contactd> contacts;
    result.getContacts(contacts);
    for (const fcl::Contactd& contact : contacts) depth = std::max(depth, contact.penetration_depth);
  }
  return depth;
}

double depthByFcl(const std::vector<WallBox>& wall, const std::vector<Pose>& way) {
  double depth = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    for (int k = 0; k <= 50; ++k) depth = std::max(depth, depthByFcl(wall, interpolate(way[i], way[i + 1], k / 50.0)));
  }
  return depth;
}

RoadmapNode nodeAt(TreeSide side, const Pose& q) { return {q, Author::Computer, side}; }

/// Nodes on both sides of the wall, as trees that do not meet.
std::vector<RoadmapNode> scattered(RandomStream& stream, int count) {
  std::vector<RoadmapNode> nodes;
  for (int i = 0; i < count; ++i) {
    const bool start = i % 2 == 0;
    const double x = stream.uniform(0.5, 1.8) * (start ? -1.0 : 1.0);
    Pose q = Pose::translation({x, stream.uniform(-1.8, 1.8), stream.uniform(-1.8, 1.8)});
    q.orientation = Quaternion(Eigen::AngleAxisd(stream.uniform(-3.0, 3.0), Vector3::UnitX()));
    nodes.push_back(nodeAt(start ? TreeSide::Start : TreeSide::Goal, q));
  }
  return nodes;
}

constexpr PenetrationBudget kNothingSpent{0, 0, 0};
/// The larger the budget, the nearer is the upper bound to the missing clearance.
constexpr PenetrationBudget kMuchSpent{30'000, 30'000, 16};
constexpr double kAboveLeast = 1.6;

TEST(HelpPlaces, TheNearestPairIsThatOfBruteForceAndOthersBeginElsewhere) {
  const Problem problem = closedProblem();
  const Se3Metric metric = problem.metric();
  const ParameterValues parameters(metric.radius());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream stream(seed, "trees");
    const std::vector<RoadmapNode> nodes = scattered(stream, 60);
    double nearest = 1e9;
    for (const RoadmapNode& a : nodes) {
      for (const RoadmapNode& b : nodes) {
        if (a.side == TreeSide::Start && b.side == TreeSide::Goal)
          nearest = std::min(nearest, metric.distance(a.q, b.q));
      }
    }
    const auto places = helpPlaces(problem, nodes, {}, parameters, 1, {}, 4, kNothingSpent);
    ASSERT_EQ(places.size(), 4U);
    EXPECT_NEAR(places.front().distance, nearest, 1e-9);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(places[i].distance, metric.distance(places[i].fromStart, places[i].fromGoal), 1e-12);
      EXPECT_FALSE(places[i].lacking) << "a closed wall";
      EXPECT_EQ(places[i].body, 0);
      for (const RoadmapNode& node : nodes) {
        if (node.side == TreeSide::Start) continue;
        EXPECT_GE(metric.distance(places[i].fromStart, node.q), places[i].distance - 1e-12);
      }
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GE(metric.distance(places[i].fromStart, places[k].fromStart), metric.radius());
        EXPECT_GE(places[i].distance, places[k].distance);
      }
    }
  }
}

TEST(HelpPlaces, WhatThePassageLacksIsWhatFclMeasures) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RandomStream stream(seed, "windows");
    const double width = stream.uniform(0.30, 0.39);
    const Vector3 middle(0.0, stream.uniform(-0.5, 0.5), stream.uniform(-0.5, 0.5));
    const auto wall = wallWithWindow(width, middle);
    const Problem problem = problemOf(wall);
    const ParameterValues parameters(problem.world->objectRadius());
    const auto beside = [&](double x) {
      return Pose::translation(middle + Vector3(x, stream.uniform(-0.1, 0.1), stream.uniform(-0.1, 0.1)));
    };
    const std::vector<RoadmapNode> nodes{nodeAt(TreeSide::Start, problem.start), nodeAt(TreeSide::Start, beside(-0.4)),
                                         nodeAt(TreeSide::Goal, beside(0.4))};
    const auto places = helpPlaces(problem, nodes, {}, parameters, seed, {}, 1, kMuchSpent);
    ASSERT_EQ(places.size(), 1U);
    ASSERT_TRUE(places.front().lacking) << "width " << width;
    const double least = depthByFcl(wall, Pose::translation(middle));
    EXPECT_NEAR(least, 0.5 * (kCube - width), 1e-9) << "the oracle";
    EXPECT_GE(*places.front().lacking, 0.999 * least);
    EXPECT_LE(*places.front().lacking, kAboveLeast * least);
    EXPECT_GE(depthByFcl(wall, places.front().passage), 0.999 * least);
    EXPECT_LE(depthByFcl(wall, places.front().passage), std::sqrt(3.0) * kAboveLeast * *places.front().lacking);
    EXPECT_LT(std::abs(places.front().narrowest.position.x()), 0.35);
    EXPECT_GE(places.front().body, 0);
    EXPECT_EQ(places.front().passage.front(), places.front().fromStart);
    EXPECT_EQ(places.front().passage.back(), places.front().fromGoal);
  }
}

TEST(HelpPlaces, AnOpenPassageLacksNothing) {
  const auto wall = wallWithWindow(0.5, Vector3::Zero());
  const Problem problem = problemOf(wall);
  const ParameterValues parameters(problem.world->objectRadius());
  const auto placesOf = [&](const Pose& from, const Pose& to) {
    return helpPlaces(problem, {nodeAt(TreeSide::Start, from), nodeAt(TreeSide::Goal, to)}, {}, parameters, 1, {}, 1);
  };
  const auto straight = placesOf(Pose::translation({-0.4, 0.0, 0.0}), Pose::translation({0.4, 0.0, 0.0}));
  ASSERT_EQ(straight.size(), 1U);
  EXPECT_EQ(straight.front().lacking, std::optional(0.0));
  EXPECT_EQ(straight.front().body, -1);
  const auto aside = placesOf(Pose::translation({-0.4, 0.3, 0.0}), Pose::translation({0.4, 0.3, 0.0}));
  ASSERT_TRUE(aside.front().lacking);
  EXPECT_LT(*aside.front().lacking, 1e-3);
  EXPECT_LT(depthByFcl(wall, aside.front().passage), 2e-3);
}

/// There are two windows, and the trees are nearer to each other at the one where the object lacks more.
TEST(HelpPlaces, WhereTheObjectLacksLeastComesFirst) {
  std::vector<WallBox> wall = wallWithWindow(0.30, {0.0, -1.0, 0.0});
  wall[1] = {"between", {0.2, 1.66, 6.3}, {0.0, -0.02, 0.0}};    // spans -0.85 to 0.81
  wall.push_back({"right", {0.2, 3.0, 6.3}, {0.0, 2.69, 0.0}});  // spans from 1.19: a window of 0.38
  wall.push_back({"below right", {0.2, 0.38, 3.0}, {0.0, 1.0, -1.69}});
  wall.push_back({"above right", {0.2, 0.38, 3.0}, {0.0, 1.0, 1.69}});
  const Problem problem = problemOf(wall);
  const ParameterValues parameters(problem.world->objectRadius());
  const std::vector<RoadmapNode> nodes{nodeAt(TreeSide::Start, Pose::translation({-0.35, -1.0, 0.0})),
                                       nodeAt(TreeSide::Goal, Pose::translation({0.35, -1.0, 0.0})),
                                       nodeAt(TreeSide::Start, Pose::translation({-0.5, 1.0, 0.0})),
                                       nodeAt(TreeSide::Goal, Pose::translation({0.5, 1.0, 0.0}))};
  const auto places = helpPlaces(problem, nodes, {}, parameters, 1, {});
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0].fromStart.position.y(), 1.0, 1e-9);
  EXPECT_LT(*places[0].lacking, *places[1].lacking);
  EXPECT_LT(places[1].distance, places[0].distance);
}

/// The trees are nearest to each other where the wall is closed. The way of least penetration leads elsewhere.
TEST(HelpPlaces, TheDeepestPlaceOfTheWholeWayComesFirst) {
  const auto wall = wallWithWindow(0.38, {0.0, 1.0, 0.0});
  const Problem problem = problemOf(wall);
  const ParameterValues parameters(problem.world->objectRadius());
  std::vector<RoadmapNode> nodes;
  for (const double y : {-1.5, -1.0, 0.0, 0.9}) {
    const double x = y > 0.0 ? 0.6 : 0.35;
    nodes.push_back(nodeAt(TreeSide::Start, Pose::translation({-x, y, 0.0})));
    nodes.push_back(nodeAt(TreeSide::Goal, Pose::translation({x, y, 0.0})));
  }
  const auto least = leastPenetration(problem, parameters, 1);
  ASSERT_TRUE(least);
  const auto places = helpPlaces(problem, nodes, {}, parameters, 1, least, 2, kNothingSpent);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_EQ(places[0].lacking, std::optional(least->depth));
  EXPECT_EQ(places[0].fromStart.position, Vector3(-0.6, 0.9, 0.0));
  EXPECT_EQ(places[0].fromGoal.position, Vector3(0.6, 0.9, 0.0));
  EXPECT_NEAR(depthByFcl(wall, Pose::translation({0.0, 1.0, 0.0})), 0.01, 1e-9) << "the oracle";
  EXPECT_GE(depthByFcl(wall, places[0].narrowest), 0.0099);
  EXPECT_FALSE(places[1].lacking);
}

TEST(HelpPlaces, AStopEndsIt) {
  const Problem problem = closedProblem();
  StopSource source;
  source.requestStop();
  EXPECT_TRUE(
      helpPlaces(problem, {}, {}, ParameterValues(problem.world->objectRadius()), 1, {}, 3, kGapBudget, source.token())
          .empty());
}

}  // namespace
}  // namespace glissade
