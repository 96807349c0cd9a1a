#include "engine/geometry/surface_deviation.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/geometry/nearest_point.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

using Kind = SurfaceFace::Kind;
using Corners = std::array<Vector3, 3>;

/// Distance to the nearest of many points of the profile that the axis turns: an oracle without a formula of the
/// distance.
double distanceBySearch(const SurfaceFace& face, const Vector3& p) {
  const double height = (p - face.point).dot(face.axis);
  const double across = (p - face.point - height * face.axis).norm();
  const auto profile = [&](double t) -> std::pair<double, double> {
    switch (face.kind) {
      case Kind::Cylinder: return {face.radius, height + t};
      case Kind::Cone: return {face.radius + (height + t) * std::tan(face.second), height + t};
      case Kind::Sphere: return {face.radius * std::cos(t), face.radius * std::sin(t)};
      case Kind::Torus: return {face.radius + face.second * std::cos(t), face.second * std::sin(t)};
      default: return {across + t, 0.0};
    }
  };
  double middle = 0.0;
  double least = 1e300;
  for (double width = 4.0; width > 1e-12; width *= 0.1) {
    double best = middle;
    for (int i = -400; i <= 400; ++i) {
      const double t = middle + width * i / 400.0;
      const auto [r, z] = profile(t);
      const double distance = std::hypot(r - across, z - height);
      if (distance < least) best = t;
      least = std::min(least, distance);
    }
    middle = best;
  }
  return least;
}

Vector3 pointOn(const SurfaceFace& face, double turn, double t) {
  switch (face.kind) {
    case Kind::Cylinder: return {face.radius * std::cos(turn), face.radius * std::sin(turn), t};
    case Kind::Cone: {
      const double r = face.radius + t * std::tan(face.second);
      return {r * std::cos(turn), r * std::sin(turn), t};
    }
    case Kind::Sphere:
      return face.radius * Vector3(std::cos(t) * std::cos(turn), std::cos(t) * std::sin(turn), std::sin(t));
    case Kind::Torus: {
      const double r = face.radius + face.second * std::cos(t);
      return {r * std::cos(turn), r * std::sin(turn), face.second * std::sin(t)};
    }
    default: return {turn, t, 0.0};
  }
}

std::vector<SurfaceFace> kinds() {
  return {{Kind::Plane},
          {Kind::Cylinder, Vector3::Zero(), Vector3::UnitZ(), 1.0},
          {Kind::Cone, Vector3::Zero(), Vector3::UnitZ(), 1.5, 0.6},
          {Kind::Sphere, Vector3::Zero(), Vector3::UnitZ(), 1.0},
          {Kind::Torus, Vector3::Zero(), Vector3::UnitZ(), 2.0, 0.5}};
}

/// A triangle with corners on the surface or a little off it.
Corners triangleNear(const SurfaceFace& face, double size, RandomStream& random) {
  const double turn = random.uniform(-3.0, 3.0);
  const double t = random.uniform(-1.0, 1.0);
  const double off = random.bits() % 2 == 0 ? 0.0 : 0.02 * size;
  Corners corners;
  for (Vector3& corner : corners) {
    corner = pointOn(face, turn + random.uniform(-size, size), t + random.uniform(-size, size));
    for (int i = 0; i < 3; ++i) corner[i] += random.uniform(-off, off);
  }
  return corners;
}

TEST(SurfaceDeviation, IsTheLargestDistanceOfManyPoints) {
  constexpr int kParts = 60;
  RandomStream random(5, "deviation");
  for (const SurfaceFace& canonical : kinds()) {
    for (const double size : {0.02, 0.2, 0.9}) {
      for (int round = 0; round < 20; ++round) {
        Corners corners = triangleNear(canonical, size, random);
        const Pose place = randomPose(random, 3.0);
        const SurfaceFace face = transformed(canonical, place);
        for (Vector3& corner : corners) corner = place * corner;
        double largest = 0.0;
        for (int i = 0; i <= kParts; ++i) {
          for (int j = 0; i + j <= kParts; ++j) {
            const Vector3 p = (i * corners[0] + j * corners[1] + (kParts - i - j) * corners[2]) / kParts;
            largest = std::max(largest, std::abs(signedDistance(face, p)));
            if (i % 20 == 0 && j % 20 == 0) {
              ASSERT_NEAR(std::abs(signedDistance(face, p)), distanceBySearch(face, p), 1e-6);
            }
          }
        }
        const double deviation = deviationFrom(face, corners);
        SCOPED_TRACE(testing::Message() << static_cast<int>(face.kind) << " " << size << " " << round);
        EXPECT_GE(deviation, largest - 1e-12);
        // The bound of a torus is made of samples. Triangles as large as the tube raise it by up to a sixth.
        const bool isTorus = face.kind == Kind::Torus;
        const double tooMuch = size > 0.5 ? 1.17 : 1.06;
        EXPECT_LE(deviation, (isTorus ? tooMuch : 1.005) * largest + 1e-12);
      }
    }
  }
}

TEST(SurfaceDeviation, OfAChordIsItsSagitta) {
  const SurfaceFace cylinder{Kind::Cylinder, Vector3::Zero(), Vector3::UnitZ(), 2.0};
  const double half = std::numbers::pi / 10.0;
  const Vector3 right = 2.0 * Vector3(std::cos(half), std::sin(half), 0.0);
  const Vector3 left = 2.0 * Vector3(std::cos(half), -std::sin(half), 0.0);
  const double sagitta = 2.0 * (1.0 - std::cos(half));
  EXPECT_NEAR(deviationFrom(cylinder, {left, right, right + Vector3::UnitZ()}), sagitta, 1e-15);
  SurfaceFace cone = cylinder;
  cone.kind = Kind::Cone;
  cone.second = 0.5;
  const Vector3 tip(0.0, 0.0, -2.0 / std::tan(0.5));
  EXPECT_NEAR(deviationFrom(cone, {left, right, tip}), std::cos(0.5) * sagitta, 1e-15);
}

TEST(SurfaceDeviation, ATriangleAcrossTheAxisIsAsDeepAsTheRadius) {
  const double side = 2.0 * std::sqrt(3.0);
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / 3.0;
    corners[i] = 2.0 * Vector3(std::cos(turn), std::sin(turn), 0.0);
  }
  ASSERT_NEAR((corners[0] - corners[1]).norm(), side, 1e-12);
  EXPECT_NEAR(deviationFrom({Kind::Cylinder, Vector3::Zero(), Vector3::UnitZ(), 2.0}, corners), 2.0, 1e-15);
  EXPECT_NEAR(deviationFrom({Kind::Sphere, Vector3::Zero(), Vector3::UnitZ(), 2.0}, corners), 2.0, 1e-15);
  EXPECT_NEAR(deviationFrom({Kind::Cone, Vector3::Zero(), Vector3::UnitZ(), 2.0, 0.3}, corners), 2.0 * std::cos(0.3),
              1e-15);
}

TEST(SurfaceDeviation, OfAPlaneIsThatOfTheFarthestCorner) {
  const SurfaceFace plane{Kind::Plane, Vector3(0, 0, 1), Vector3::UnitZ()};
  EXPECT_EQ(deviationFrom(plane, {Vector3(0, 0, 1), Vector3(1, 0, 1), Vector3(0, 1, 1)}), 0.0);
  EXPECT_EQ(deviationFrom(plane, {Vector3(0, 0, 1), Vector3(1, 0, 1.5), Vector3(0, 1, 0.75)}), 0.5);
}

}  // namespace
}  // namespace glissade
