#include "engine/sequence/static_equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

constexpr double kFriction = 0.3;

SupportedBody ground() { return {0.0, Vector3::Zero(), 1.0, true}; }

/// Four corners of a square of this half width, at a height, between body `a` below and `b` above.
void addSquare(std::vector<SupportPoint>& points, std::size_t a, std::size_t b, double low, double high, double z) {
  for (const double x : {low, high}) {
    for (const double y : {-0.5, 0.5}) points.push_back({a, b, {x, y, z}, Vector3::UnitZ(), false});
  }
}

TEST(StaticEquilibrium, ABodyStandsWhereItsCentreIsAboveWhatItStandsOn) {
  RandomStream random(1, "centres");
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    std::vector<SupportPoint> points;
    addSquare(points, 0, 1, -0.5, 0.5, 0.0);
    const auto out = outOfEquilibrium({ground(), {5.0, {x, y, 1.0}, 1.0, false}}, points, -Vector3::UnitZ(), kFriction);
    const double beyond = std::max(std::abs(x), std::abs(y)) - 0.5;
    if (std::abs(beyond) < 0.02) continue;
    EXPECT_EQ(out[1], beyond > 0.0) << x << " " << y;
    EXPECT_FALSE(out[0]);
  }
}

/// The angle is exact along the sides of the friction pyramid.
TEST(StaticEquilibrium, ABodySlidesOnASlopeAboveTheAngleOfFriction) {
  for (const double angle : {0.1, 0.25, 0.33, 0.6}) {
    const Vector3 gravity(0.0, 0.0, -1.0);
    const Vector3 normal(std::sin(angle), 0.0, std::cos(angle));
    const Vector3 along = normal.unitOrthogonal();
    std::vector<SupportPoint> points;
    for (const double u : {-0.5, 0.5}) {
      for (const double v : {-0.5, 0.5}) {
        points.push_back({0, 1, u * along + v * normal.cross(along), normal, false});
      }
    }
    const auto out = outOfEquilibrium({ground(), {2.0, 0.01 * normal, 0.5, false}}, points, gravity, kFriction);
    EXPECT_EQ(out[1], std::tan(angle) > kFriction) << angle;
  }
}

/// The top one of n bricks of length 1 can overhang by half of the sum of 1/k.
TEST(StaticEquilibrium, AHarmonicStackStandsAndOneThatReachesFartherFalls) {
  for (const double factor : {0.97, 1.05}) {
    constexpr int kBricks = 5;
    std::vector<SupportedBody> bodies{ground()};
    std::vector<SupportPoint> points;
    double x = -0.5;  // middle of the lowest brick; the edge of the table is at 0
    std::vector<double> middles;
    for (int brick = 0; brick < kBricks; ++brick) {
      x += factor * 0.5 / (kBricks - brick);
      middles.push_back(x);
      bodies.push_back({1.0, {x, 0.0, 0.1 * brick + 0.05}, 0.5, false});
    }
    addSquare(points, 0, 1, middles[0] - 0.5, 0.0, 0.0);
    for (int brick = 1; brick < kBricks; ++brick) {
      const auto below = static_cast<std::size_t>(brick);
      addSquare(points, below, below + 1, middles[below] - 0.5, middles[below - 1] + 0.5, 0.1 * brick);
    }
    const auto out = outOfEquilibrium(bodies, points, -Vector3::UnitZ(), kFriction);
    EXPECT_EQ(std::count(out.begin(), out.end(), true) > 0, factor > 1.0);
  }
}

TEST(StaticEquilibrium, BondsHoldFromAboveAndContactsDoNot) {
  for (const bool bonded : {true, false}) {
    std::vector<SupportPoint> points;
    addSquare(points, 0, 1, -0.5, 0.5, 0.0);
    for (SupportPoint& point : points) {
      point.bonded = bonded;
      point.normal = -Vector3::UnitZ();
    }
    const auto out =
        outOfEquilibrium({ground(), {1.0, {0.0, 0.0, -0.2}, 0.5, false}}, points, -Vector3::UnitZ(), kFriction);
    EXPECT_EQ(out[1], !bonded);
  }
}

TEST(StaticEquilibrium, NobodyAtAllIsInEquilibrium) {
  EXPECT_TRUE(outOfEquilibrium({}, {}, -Vector3::UnitZ(), kFriction).empty());
  EXPECT_EQ(outOfEquilibrium({ground()}, {}, -Vector3::UnitZ(), kFriction), std::vector<bool>{false});
  EXPECT_EQ(outOfEquilibrium({{1.0, Vector3::Zero(), 1.0, false}}, {}, -Vector3::UnitZ(), kFriction),
            std::vector<bool>{true});
}

}  // namespace
}  // namespace glissade
