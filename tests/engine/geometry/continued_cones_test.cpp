#include "engine/geometry/continued_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/random_stream.h"
#include "engine/evidence/thinning.h"
#include "engine/geometry/thinned_mesh.h"

namespace glissade {
namespace {

enum Face : std::uint32_t { kBottom, kCylinder, kCone, kEnd };

struct Bolt {
  double radius = 0.0025;
  double chamfer = 0.0005;
  double length = 0.02;
  Vector3 aside = Vector3::Zero();  ///< offset of the cone's axis in the file
};

/// An upright bolt whose upper end has a chamfer of two rows of triangles.
TriangleMesh meshOf(const Bolt& bolt) {
  constexpr std::uint32_t kSides = 48;
  const double half = 0.5 * bolt.chamfer;
  const std::vector<std::pair<double, double>> rows{{0.0, bolt.radius},
                                                    {bolt.length - std::abs(bolt.chamfer), bolt.radius},
                                                    {bolt.length - std::abs(half), bolt.radius - half},
                                                    {bolt.length, bolt.radius - bolt.chamfer}};
  TriangleMesh mesh;
  for (const auto& [z, r] : rows) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSides;
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, bolt.length);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
    mesh.triangles.push_back({a, b, c});
    mesh.faceOf.push_back(face);
  };
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t k = (i + 1) % kSides;
    for (std::uint32_t row = 0; row < 3; ++row) {
      const std::uint32_t low = row * kSides;
      const std::uint32_t high = low + kSides;
      add(low + i, low + k, high + k, row == 0 ? kCylinder : kCone);
      add(low + i, high + k, high + i, row == 0 ? kCylinder : kCone);
    }
    add(4 * kSides, k, i, kBottom);
    add(4 * kSides + 1, 3 * kSides + i, 3 * kSides + k, kEnd);
  }
  mesh.faces.resize(4);
  mesh.faces[kCylinder] = {SurfaceFace::Kind::Cylinder, Vector3::Zero(), Vector3::UnitZ(), bolt.radius};
  mesh.faces[kCone] = {SurfaceFace::Kind::Cone, bolt.aside, Vector3::UnitZ(), bolt.radius, std::numbers::pi / 4};
  return mesh;
}

std::vector<double> ofCylinder(const TriangleMesh& mesh, double allowance) {
  std::vector<double> allowances;
  for (const std::uint32_t face : mesh.faceOf) allowances.push_back(face == kCylinder ? allowance : 0.0);
  return allowances;
}

/// No part of the chamfer remains beyond the radius of the thinned cylinder; the part nearer to the axis stays. The
/// planners' construction and the judge's agree.
TEST(ContinuedCones, AChamferGoesWhereItsCylinderGoes) {
  RandomStream random(11, "chamfers");
  for (int trial = 0; trial < 30; ++trial) {
    Bolt bolt;
    bolt.chamfer = random.uniform(2e-4, 1e-3);
    const double taken = random.uniform(1e-4, 4.5e-4);
    const TriangleMesh mesh = meshOf(bolt);
    const auto thinnable = ThinnableMesh::of(mesh);
    ASSERT_TRUE(thinnable);
    const auto planned = thinnable->thinned(ofCylinder(mesh, taken));
    ASSERT_TRUE(planned);
    for (const TriangleMesh& thin : {*planned, evidence::thinned(mesh, ofCylinder(mesh, taken))}) {
      double widest = 0.0;
      double least = bolt.radius;
      for (const Vector3& p : thin.vertices) {
        if (p.z() < 0.5 * bolt.length) continue;
        const double radius = p.head<2>().norm();
        widest = std::max(widest, radius);
        if (radius > 0.0) least = std::min(least, radius);
      }
      EXPECT_LE(widest, bolt.radius - 0.99 * taken) << trial;
      EXPECT_GE(least, std::min(bolt.radius - bolt.chamfer, bolt.radius - taken) - 1e-9) << trial;
    }
  }
}

TEST(ContinuedCones, TheEdgeSlidesWhereTheConeHasNoVertexBetween) {
  const TriangleMesh mesh = meshOf({});
  const auto planned = ThinnableMesh::of(mesh)->thinned(ofCylinder(mesh, 2e-4));
  ASSERT_TRUE(planned);
  double highest = 0.0;
  for (const Vector3& p : planned->vertices) {
    if (std::abs(p.head<2>().norm() - 0.0023) < 1e-5) highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, 0.0195 + 2e-4, 1e-5);
}

TEST(ContinuedCones, OnlyConesAboutTheAxisThatRecedeFromTheCylinder) {
  EXPECT_EQ(coneVertices(meshOf({})).size(), 3 * 48U);
  Bolt beside;
  beside.aside = {1e-5, 0.0, 0.0};
  EXPECT_TRUE(coneVertices(meshOf(beside)).empty());
  Bolt countersunk;
  countersunk.chamfer = -0.001;
  EXPECT_TRUE(coneVertices(meshOf(countersunk)).empty()) << "it widens";
  TriangleMesh plain = meshOf({});
  plain.faces.clear();
  plain.faceOf.clear();
  EXPECT_TRUE(coneVertices(plain).empty()) << "the file states no faces";
}

}  // namespace
}  // namespace glissade
