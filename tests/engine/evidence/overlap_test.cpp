#include "engine/evidence/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/fits/ring.h"

namespace glissade::check {
namespace {

PlacedBody placed(TriangleMesh mesh, const Pose& X_WB) {
  const Body body{"body", "body", std::make_shared<const TriangleMesh>(std::move(mesh)), X_WB};
  return PlacedBody(body, X_WB);
}

/// A large plate whose lower face is tilted about the middle of a ring's upper face. Most triangles of a fine ring are
/// farther from the plate than its depth: a search that takes the nearest of the others for the nearest of all would
/// not end.
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
    // The deepest point is equally far from the upper face and the side.
    const double atRim = kOuter * std::sin(tilt) / (1.0 + std::sin(tilt));
    EXPECT_NEAR(overlap.deepest, atRim, 0.01 * atRim) << tilt;
  }
}

/// A disc about z with an upper rim that is rounded in `steps` steps.
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

/// At the rim the plate leaves the body along a curve over many small facets. Cells that have to become as small as the
/// depth there would take minutes.
TEST(Overlap, OfALargePlateOnARoundedRimIsThatBelowThePlate) {
  constexpr double kHeight = 0.02;
  constexpr double kDeep = 1.2e-4;
  const PlacedBody disc = placed(roundedDisc(0.02, 0.002, kHeight, 160, 8), Pose::identity());
  const PlacedBody plate = placed(makeBox({0.8, 0.8, 0.036}), Pose::translation({0.1, 0.05, kHeight - kDeep + 0.018}));
  const Overlap overlap = overlapIn(disc, plate, {});
  EXPECT_NEAR(overlap.deepest, kDeep, 0.01 * kDeep);
  for (const double depth : overlap.depths) EXPECT_LE(depth, kDeep * (1.0 + 1e-9));
}

/// A rod of radius 4 that is tilted in a hole of radius 4.1 and length 8, in millimetres.
TriangleMesh tiltedRod() {
  TriangleMesh rod = test::prism(72, 0.004, 0.06);
  for (Vector3& v : rod.vertices) v.z() -= 0.03;
  return rod;
}

constexpr double kTilt = 0.14;  // radians

Pose tilted() {
  Pose X_WR;
  X_WR.orientation = Quaternion(Eigen::AngleAxisd(kTilt, Vector3::UnitX()));
  return X_WR;
}

double deepestIn(const PlacedBody& plate, const Overlap& overlap) {
  double deepest = 0.0;
  for (std::uint32_t t = 0; t < plate.mesh.triangles.size(); ++t) {
    const Vector3& n = plate.normals[t];
    if (std::abs(n.z()) < 0.5) deepest = std::max(deepest, overlap.depths[plate.regions.of[t]]);
  }
  return deepest;
}

TEST(Overlap, OfATiltedShaftWithItsHoleIsThatAtTheRims) {
  const PlacedBody plate = placed(test::holedPlate(72, 0.0041, 0.02, -0.004, 0.004), Pose::identity());
  const PlacedBody rod = placed(tiltedRod(), tilted());
  const double atRim = 0.004 / std::cos(kTilt) + 0.004 * std::tan(kTilt) - 0.0041;
  const Overlap overlap = overlapIn(plate, rod, {});
  EXPECT_NEAR(deepestIn(plate, overlap), atRim, 0.01 * atRim);
  EXPECT_LT(overlap.deepest, 0.95 * atRim) << "the depth that people accept is the distance from the surface";
}

/// A shaft that is as deep as a clash is no reason to thin the wall by a millimetre.
TEST(Overlap, OfATiltedShaftInAFarNarrowerHoleIsWhatIsMeasured) {
  const PlacedBody plate = placed(test::holedPlate(72, 0.0041, 0.02, -0.004, 0.004), Pose::identity());
  TriangleMesh rod = test::prism(72, 0.0046, 0.06);
  for (Vector3& v : rod.vertices) v.z() -= 0.03;
  const Overlap overlap = overlapIn(plate, placed(rod, tilted()), {});
  EXPECT_LE(deepestIn(plate, overlap), overlap.deepest);
}

/// Each plane is a part of a cylinder that is wide enough.
TEST(RoundFaces, APlaneHasNone) {
  const TriangleMesh holed = test::holedPlate(72, 0.0041, 0.02, -0.004, 0.004);
  RandomStream random(51, "planes");
  for (int round = 0; round < 40; ++round) {
    const Vector3 axis(random.normal(), random.normal(), random.normal());
    const Quaternion turn(Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis.normalized()));
    const PlacedBody plate = placed(holed, {Vector3(0.1, 0.2, 0.3), turn});
    EXPECT_EQ(plate.rounds.size(), 2U);
    for (const RoundFace& face : plate.rounds) EXPECT_LT(face.radius, 0.021);
  }
}

/// A wider hole would let the knob pass.
TEST(Overlap, OfATiltedShaftWithAKnobIsNotThatAtTheRims) {
  const PlacedBody plate = placed(test::holedPlate(72, 0.0041, 0.02, -0.004, 0.004), Pose::identity());
  TriangleMesh knob = test::prism(72, 0.0044, 0.003);
  for (Vector3& v : knob.vertices) v.z() += 0.01;
  TriangleMesh knobbed = tiltedRod();
  append(knobbed, knob);
  const Overlap overlap = overlapIn(plate, placed(knobbed, tilted()), {});
  EXPECT_NEAR(deepestIn(plate, overlap), overlap.deepest, 1e-6);
  EXPECT_GT(overlap.deepest, 4e-4);
}

}  // namespace
}  // namespace glissade::check
