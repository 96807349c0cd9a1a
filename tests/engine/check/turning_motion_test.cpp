// Turning motions, proved by pieces of the surfaces and tested by dense samples with exact tests of triangles.
#include <gtest/gtest.h>

#include <limits>

#include "engine/check/motion_check.h"
#include "engine/geometry/triangle_tree.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/support/random_pose.h"

namespace glissade::check {
namespace {

constexpr double kRadius = 0.005;
constexpr double kHeight = 0.02;
constexpr double kTurnPitch = 0.0015;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

TriangleMesh boxAt(const Vector3& size, const Vector3& at) { return transformed(makeBox(size), Pose::translation(at)); }

/// A screw motion about z from an orientation, for a frame beside the axis.
std::vector<Pose> screwed(const Vector3& beside, double turns, int edges, double rise) {
  std::vector<Pose> path;
  for (int i = 0; i <= edges; ++i) {
    const double share = static_cast<double>(i) / edges;
    const Quaternion turn(Eigen::AngleAxisd(share * turns * kFullTurn, Vector3::UnitZ()));
    path.push_back({turn * beside + Vector3(0.0, 0.0, share * rise), turn});
  }
  return path;
}

struct TurningPair {
  TriangleMesh object;  ///< in the frame of the path
  TriangleMesh fixed;   ///< in the world frame

  MotionVerdict judge(const std::vector<Pose>& path, double required) const {
    const auto moving = std::make_shared<const TriangleMesh>(object);
    const double factor = MotionCheck::scaleFor({moving.get(), &fixed}, {});
    const MotionCheck check({{MotionCheck::prepare(fixed, Pose::identity(), factor), moving}}, object, factor);
    return check.check(path, std::vector<Demand>(std::max<std::size_t>(1, path.size() - 1), {required, false}));
  }

  /// Distance of the surfaces; exact where they meet, else up to `limit`.
  double distanceAt(const TriangleTree& around, const Pose& q, double limit) const {
    const TriangleTree placed(transformed(object, q));
    double least = limit;
    placed.visitPairs(around, limit, [&](std::uint32_t i, std::uint32_t k) {
      const Triangle& a = placed.triangles()[i];
      const Triangle& b = around.triangles()[k];
      least = trianglesMeet(a, b) ? 0.0 : std::min(least, std::sqrt(triangleDistance(a, b).squared));
      return least > 0.0;
    });
    return least;
  }
};

/// Transforms all of it to another frame of the world.
void place(const Pose& X, TurningPair& pair, std::vector<Pose>& path) {
  pair.fixed = transformed(pair.fixed, X);
  for (Pose& q : path) q = X * q;
}

Pose anywhere(RandomStream& random) {
  Pose X = randomPose(random, 0.05);
  X.orientation.normalize();
  return X;
}

/// A bolt in a hole with a clearance of two micrometres, its frame beside the axis: the chords of the path deviate from
/// the screw motion by as much. Distances alone would need some hundred queries for each edge.
TEST(TurningMotion, ATurnOnATiltedAxisNeedsFewDistances) {
  RandomStream random(5, "axes");
  const Vector3 beside(1.5e-3, -0.5e-3, 0.0);
  for (int round = 0; round < 2; ++round) {
    TurningPair pair{test::prism(32, kRadius, kHeight),
                     test::holedPlate(32, kRadius / std::cos(std::numbers::pi / 32) + 2e-6, 0.012, 0.004, 0.012)};
    pair.object = transformed(pair.object, Pose::translation(-beside));
    std::vector<Pose> path = screwed(beside, 1.5, 96, 1.5 * kTurnPitch);
    place(anywhere(random), pair, path);
    const MotionVerdict verdict = pair.judge(path, 1e-7);
    EXPECT_EQ(verdict.status, Status::Certified);
    EXPECT_LT(verdict.distances, 8 * path.size());
  }
}

/// A configuration that is repeated is an edge without a length.
TEST(TurningMotion, RepeatedConfigurationsCostNothing) {
  TurningPair pair{test::prism(32, kRadius, kHeight),
                   test::holedPlate(32, kRadius / std::cos(std::numbers::pi / 32) + 2e-6, 0.012, 0.004, 0.012)};
  std::vector<Pose> path = screwed(Vector3::Zero(), 5.0, 20, 5.0 * kTurnPitch);
  RandomStream random(6, "axes");
  place(anywhere(random), pair, path);
  std::vector<Pose> repeated;
  for (const Pose& q : path) repeated.insert(repeated.end(), 3, q);
  for (std::size_t i = 1; i < repeated.size(); i += 3) repeated[i].orientation.coeffs() *= -1.0;
  const MotionVerdict once = pair.judge(path, 1e-7);
  const MotionVerdict thrice = pair.judge(repeated, 1e-7);
  EXPECT_EQ(once.status, Status::Certified);
  EXPECT_EQ(thrice.status, Status::Certified);
  EXPECT_EQ(thrice.edges.size(), repeated.size() - 1);
  EXPECT_LT(thrice.distances, 4 * repeated.size());
}

/// No body is thinned, and the motion is a thousand times as long as the gap.
TEST(TurningMotion, AStraightWayAlongAGapNeedsFewDistances) {
  const TurningPair pair{makeBox({0.01, 0.01, 0.01}), boxAt({2.0, 2.0, 0.1}, {0.0, 0.0, -0.0551})};
  const MotionVerdict verdict =
      pair.judge({Pose::translation({-0.5, 0.0, 0.0}), Pose::translation({0.5, 0.0, 0.0})}, 1e-7);
  EXPECT_EQ(verdict.status, Status::Certified);
  EXPECT_LT(verdict.distances, 5U);
  EXPECT_NEAR(verdict.minClearance, 1e-4, 1e-9);
}

/// Hinges, doors and levers: turns by less than a circle about an axis outside of the body; a wall blocks some of them.
TEST(TurningMotion, WhatSwingsIsJudgedAsItIsSampled) {
  RandomStream random(17, "levers");
  int certified = 0;
  int violated = 0;
  for (int round = 0; round < 40; ++round) {
    const Vector3 beside(random.uniform(0.0, 0.3), random.uniform(0.0, 0.3), 0.0);
    TurningPair pair{boxAt({0.2, 0.02, 0.02}, Vector3(0.12, 0.0, 0.0) - beside),
                     boxAt({0.05, 0.05, 0.3}, {0.0, 0.26 + random.uniform(-0.05, 0.05), 0.0})};
    append(pair.fixed, test::prism(24, 0.019, 0.1));
    std::vector<Pose> path = screwed(beside, random.uniform(-0.6, 0.6), 1 + round % 4, random.uniform(-0.01, 0.01));
    place(anywhere(random), pair, path);
    const MotionVerdict verdict = pair.judge(path, 1e-5);
    ASSERT_NE(verdict.status, Status::Undecided) << round;
    (verdict.status == Status::Certified ? certified : violated) += 1;
    const TriangleTree around(pair.fixed);
    double least = 1.0;
    for (std::size_t edge = 0; edge + 1 < path.size(); ++edge) {
      for (int i = 0; i <= 24; ++i) {
        least = std::min(least, pair.distanceAt(around, interpolate(path[edge], path[edge + 1], i / 24.0), 0.05));
      }
    }
    if (verdict.status == Status::Certified) {
      EXPECT_GE(least * (1.0 + 1e-6), std::min(0.05, verdict.provedClearance)) << round;
      EXPECT_GE(verdict.provedClearance, std::min(0.025, 0.49 * verdict.minClearance)) << round;
    } else {
      EXPECT_LT(pair.distanceAt(around, interpolate(path[verdict.edge], path[verdict.edge + 1], verdict.at), 0.05),
                1e-5)
          << round;
    }
  }
  EXPECT_GT(certified, 2);
  EXPECT_GT(violated, 5);
}

}  // namespace
}  // namespace glissade::check
