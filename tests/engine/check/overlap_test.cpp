#include "engine/check/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/geometry/primitives.h"
#include "tests/engine/product/ring.h"

namespace glissade::check {
namespace {

PlacedBody placed(TriangleMesh mesh, const Pose& X_WB) {
  const Body body{"body", "body", std::make_shared<const TriangleMesh>(std::move(mesh)), X_WB};
  return PlacedBody(body, X_WB);
}

/// A large plate whose lower face is tilted about the middle of a ring's upper face. Most triangles of a fine ring are
/// farther from the plate than the plate is deep: a search that takes the nearest of the others for the nearest of all
/// does not end.
TEST(Overlap, OfATiltedPlateInAFineRingIsThatAtItsRim) {
  constexpr double kOuter = 0.007;
  constexpr double kLength = 0.005;
  constexpr double kThickness = 0.002;
  const PlacedBody ring = placed(test::makeRing(0.004, kOuter, kLength, 400), Pose::identity());
  for (const double tilt : {0.003, 0.01, 0.03}) {
    Pose X_WP;
    X_WP.orientation = Quaternion(Eigen::AngleAxisd(tilt, Vector3::UnitY()));
    X_WP.position = Vector3(0.0, 0.0, 0.5 * kLength) + X_WP.orientation * Vector3(0.0, 0.0, 0.5 * kThickness);
    const PlacedBody plate = placed(makeBox({0.6, 0.4, kThickness}), X_WP);
    const Overlap overlap = overlapIn(ring, plate, {});
    // As far from the face above as from the side.
    const double atRim = kOuter * std::sin(tilt) / (1.0 + std::sin(tilt));
    EXPECT_NEAR(overlap.deepest, atRim, 0.01 * atRim) << tilt;
  }
}

/// A disc about z whose upper rim is rounded in so many steps.
TriangleMesh roundedDisc(double radius, double rounding, double height, int around, int steps) {
  TriangleMesh mesh;
  std::vector<std::pair<double, double>> profile{{radius, 0.0}};
  for (int i = 0; i <= steps; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / steps;
    profile.emplace_back(radius - rounding * (1.0 - std::cos(angle)), height - rounding * (1.0 - std::sin(angle)));
  }
  for (const auto& [r, z] : profile) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  }
  const auto n = static_cast<std::uint32_t>(around);
  const auto rings = static_cast<std::uint32_t>(profile.size());
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, height);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n;
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({ring * n + i, ring * n + k, (ring + 1) * n + k});
      mesh.triangles.push_back({ring * n + i, (ring + 1) * n + k, (ring + 1) * n + i});
    }
    mesh.triangles.push_back({rings * n, k, i});
    mesh.triangles.push_back({rings * n + 1, (rings - 1) * n + i, (rings - 1) * n + k});
  }
  return mesh;
}

/// At the rim the plate leaves the body along a curve over many small facets: cells that have to become as small as the
/// depth there take minutes.
TEST(Overlap, OfALargePlateOnARoundedRimIsThatBelowThePlate) {
  constexpr double kHeight = 0.02;
  constexpr double kDeep = 1.2e-4;
  const PlacedBody disc = placed(roundedDisc(0.02, 0.002, kHeight, 160, 8), Pose::identity());
  const PlacedBody plate = placed(makeBox({0.8, 0.8, 0.036}), Pose::translation({0.1, 0.05, kHeight - kDeep + 0.018}));
  const Overlap overlap = overlapIn(disc, plate, {});
  EXPECT_NEAR(overlap.deepest, kDeep, 0.01 * kDeep);
  for (const double depth : overlap.depths) EXPECT_LE(depth, kDeep * (1.0 + 1e-9));
}

}  // namespace
}  // namespace glissade::check
