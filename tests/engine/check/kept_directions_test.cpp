// Directions that a person forbids to a part: compares planner and judge, which share no code for them, with a formula
// for boxes. The campaign (GLISSADE_FORBIDDEN=all, packaging/reliability.sh) draws more cases.
#include "engine/check/kept_directions.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "engine/base/random_stream.h"
#include "engine/base/tolerances.h"
#include "engine/check/hull_clearance.h"
#include "engine/geometry/convex_distance.h"
#include "engine/sequence/direction_rule.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/support/random_pose.h"

namespace glissade::check {
namespace {

int drawn(int usual) {
  const char* text = std::getenv("GLISSADE_FORBIDDEN");
  return text != nullptr && std::strcmp(text, "all") == 0 ? 100 * usual : usual;
}

struct PlacedBox {
  Vector3 size;
  Pose X_WB;
};

/// The largest gap between the boxes along their faces' normals and the products of their edges: positive if they are
/// apart (Gottschalk 1996), and at most their distance.
double gapOf(const PlacedBox& a, const PlacedBox& b) {
  const Eigen::Matrix3d ofA = a.X_WB.orientation.toRotationMatrix();
  const Eigen::Matrix3d ofB = b.X_WB.orientation.toRotationMatrix();
  double most = -1e9;
  const auto take = [&](Vector3 axis) {
    if (axis.norm() < 1e-6) return;
    axis.normalize();
    const double reach =
        0.5 * ((ofA.transpose() * axis).cwiseAbs().dot(a.size) + (ofB.transpose() * axis).cwiseAbs().dot(b.size));
    most = std::max(most, std::abs(axis.dot(a.X_WB.position - b.X_WB.position)) - reach);
  };
  for (int i = 0; i < 3; ++i) {
    take(ofA.col(i));
    take(ofB.col(i));
    for (int j = 0; j < 3; ++j) take(ofA.col(i).cross(ofB.col(j)));
  }
  return most;
}

/// A box with vertices inside.
TriangleMesh boxWithInside(const Vector3& size) {
  TriangleMesh mesh = makeBox(size);
  append(mesh, makeBox(0.5 * size));
  return mesh;
}

TEST(HullClearance, BothAlgorithmsAgreeWithBoxes) {
  RandomStream stream(1, "boxes");
  int clear = 0;
  int near = 0;
  for (int i = 0; i < drawn(1000); ++i) {
    const auto size = [&] {
      return Vector3(stream.uniform(0.1, 1.0), stream.uniform(0.1, 1.0), stream.uniform(0.1, 1.0));
    };
    const PlacedBox a{size(), randomPose(stream, 0.8)};
    const PlacedBox b{size(), randomPose(stream, 0.8)};
    const double distance = stream.uniform() < 0.5 ? 0.001 : 0.05;
    const TriangleMesh meshA = boxWithInside(a.size);
    const TriangleMesh meshB = boxWithInside(b.size);
    const double gap = gapOf(a, b);
    for (const bool apart :
         {hullsApart(meshA, a.X_WB, meshB, b.X_WB, distance), hullsAreClear(meshA, a.X_WB, meshB, b.X_WB, distance)}) {
      if (gap > distance + 1e-6) {
        EXPECT_TRUE(apart) << i;
        ++clear;
      } else if (gap < -1e-6) {
        EXPECT_FALSE(apart) << i;
        ++near;
      }
    }
  }
  EXPECT_GT(clear, 100);
  EXPECT_GT(near, 100);
}

/// The boxes are parallel to the axes of the world, so that their distance is exact.
TEST(HullClearance, ADistanceIsKeptExactly) {
  RandomStream stream(2, "distances");
  for (int i = 0; i < drawn(400); ++i) {
    const auto point = [&] { return Vector3(stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)); };
    const Vector3 at = point();
    const TriangleMesh mesh = boxWithInside(Vector3::Constant(0.3));
    const double between = (at.cwiseAbs() - Vector3::Constant(0.3)).cwiseMax(0.0).norm();
    for (const double distance : {0.9 * between, 1.1 * between + 1e-9}) {
      const bool expected = distance < between;
      EXPECT_EQ(hullsApart(mesh, Pose::translation(at), mesh, Pose::identity(), distance), expected);
      EXPECT_EQ(hullsAreClear(mesh, Pose::translation(at), mesh, Pose::identity(), distance), expected);
    }
  }
}

/// A part of 0.2 m on a base that is a cube of 1 m, with its top at z = 0.
constexpr double kBlock = 0.2;
constexpr double kBlockRadius = 0.1 * 1.7320508075688772;

Product blockOnABase() {
  Product product;
  product.bodies = {glissade::test::checkBody("base", makeBox({1.0, 1.0, 1.0}), {0.0, 0.0, -0.5}),
                    glissade::test::checkBody("block", makeBox({kBlock, kBlock, kBlock}), {0.0, 0.0, 0.5 * kBlock}),
                    glissade::test::checkBody("far", makeBox({0.1, 0.1, 0.1}), {3.0, 0.0, 0.0})};
  return product;
}

bool isInCone(const Vector3& way, const Vector3& direction) {
  return way.norm() > 1e-5 && way.dot(direction) > tolerance::kForbiddenCone * way.norm();
}

/// The rule for boxes: the block is clear if it is farther from the base than the touching distance.
bool isAllowed(const std::vector<Vector3>& places, const Vector3& direction) {
  const auto isClear = [](const Vector3& middle) {
    const Vector3 apart = (middle - Vector3(0.0, 0.0, -0.5)).cwiseAbs() - Vector3::Constant(0.5 + 0.5 * kBlock);
    return apart.cwiseMax(0.0).norm() > tolerance::kTouching * kBlockRadius;
  };
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (isClear(places[i - 1])) return true;
    if (isInCone(places[i] - places[i - 1], direction) || isInCone(places[i] - places[0], direction)) return false;
  }
  return true;
}

bool judgeAllows(const Product& product, const std::vector<Pose>& path, const Vector3& direction) {
  ForbiddenMotion forbidden{product.bodies[1], direction, {}};
  for (const std::size_t other : touching(product, 1)) forbidden.beside.push_back(&product.bodies[other]);
  return keepsOut(forbidden, path);
}

bool plannerAllows(const Product& product, const std::vector<Pose>& path, const Vector3& direction) {
  const Body& block = product.bodies[1];
  const Body& base = product.bodies[0];
  const DirectionRule rule(block.X_WB, {{block.mesh,
                                         Pose::identity(),
                                         {direction},
                                         {{base.id, base.name, Mobility::Mobile, base.mesh, base.X_WB}},
                                         1.02 * tolerance::kTouching * radiusAboutOrigin(*block.mesh)}});
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!rule.mayMove(path[i - 1], path[i])) return false;
  }
  return true;
}

TEST(KeptDirections, ABlockTouchesItsBaseAlone) {
  const Product product = blockOnABase();
  EXPECT_EQ(touching(product, 1), std::vector<std::size_t>{0});
  EXPECT_EQ(touching(product, 2), (std::vector<std::size_t>{0, 1})) << "what touches nothing touches all";
}

TEST(KeptDirections, UpwardsThenAsideIsForbiddenAndAsideThenUpwardsIsNot) {
  const Product product = blockOnABase();
  const auto path = [](const std::vector<Vector3>& ways) {
    std::vector<Pose> poses{Pose::translation({0.0, 0.0, 0.5 * kBlock})};
    for (const Vector3& way : ways) poses.push_back(Pose::translation(poses.back().position + way));
    return poses;
  };
  const Vector3 up = Vector3::UnitZ();
  const auto expect = [&](bool allowed, const std::vector<Pose>& legs) {
    EXPECT_EQ(judgeAllows(product, legs, up), allowed);
    EXPECT_EQ(plannerAllows(product, legs, up), allowed);
  };
  expect(false, path({{0, 0, 1}, {5, 0, 0}}));
  expect(false, path({{0.1, 0, 0}, {0, 0, 1}}));
  expect(false, path({{8e-5, 0, 1e-4}, {-8e-5, 0, 1e-4}, {5, 0, 0}}));
  expect(false, path({{0.3, 0, 0.6}, {5, 0, 0}}));
  expect(true, path({{0.8, 0, 0}, {0, 0, 1}}));
  expect(true, path({{0.3, 0, 0.4}, {5, 0, 0}}));
  expect(true, path({{0.3, 0, 0.4}, {-0.3, 0, 0.4}, {5, 0, 0}}));
  expect(true, path({{5, 0, 0}}));
}

/// The frame of the path may be anywhere: only the motion of the body counts.
TEST(KeptDirections, ATurnAboutAFarPointIsAMotion) {
  const Product product = blockOnABase();
  const Pose start = product.bodies[1].X_WB;
  const Vector3 pivot(-1.0, 0.0, start.position.z());
  std::vector<Pose> turned;
  for (const double angle : {0.0, 0.3}) {
    const Quaternion turn(Eigen::AngleAxisd(-angle, Vector3::UnitY()));
    turned.push_back({pivot + turn * (start.position - pivot), turn});
  }
  EXPECT_FALSE(judgeAllows(product, turned, Vector3::UnitZ()));
  EXPECT_FALSE(plannerAllows(product, turned, Vector3::UnitZ()));
  EXPECT_TRUE(judgeAllows(product, turned, Vector3::UnitX()));
  EXPECT_TRUE(plannerAllows(product, turned, Vector3::UnitX()));
}

/// The planner may be stricter, because it does not store where a part was clear.
TEST(KeptDirections, RandomPathsAreJudgedAsBoxesAllow) {
  const Product product = blockOnABase();
  RandomStream stream(3, "paths");
  int allowed = 0;
  const int count = drawn(2000);
  for (int i = 0; i < count; ++i) {
    std::vector<Vector3> places{product.bodies[1].X_WB.position};
    std::vector<Pose> path{product.bodies[1].X_WB};
    const int legs = 1 + static_cast<int>(stream.uniform(0.0, 4.0));
    for (int leg = 0; leg < legs; ++leg) {
      Vector3 way(stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-0.2, 1));
      if (stream.uniform() < 0.5) way = way.cwiseProduct(Vector3(stream.uniform() < 0.3, stream.uniform() < 0.3, 1.0));
      places.push_back(places.back() + way);
      path.push_back(Pose::translation(places.back()));
    }
    const Vector3 direction = stream.uniform() < 0.5 ? Vector3::UnitZ() : Vector3(0.3, 0.0, 1.0).normalized();
    const bool expected = isAllowed(places, direction);
    allowed += expected ? 1 : 0;
    EXPECT_EQ(judgeAllows(product, path, direction), expected) << i;
    if (!expected) {
      EXPECT_FALSE(plannerAllows(product, path, direction)) << i;
    }
  }
  EXPECT_GT(allowed, count / 10);
  EXPECT_LT(allowed, 9 * count / 10);
}

}  // namespace
}  // namespace glissade::check
