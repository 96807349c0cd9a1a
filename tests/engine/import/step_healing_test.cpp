#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/surface_deviation.h"
#include "engine/import/step_import.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

using Kind = SurfaceFace::Kind;
using test::stepFile;
using testing::HasSubstr;

constexpr double kMm3 = 1e-9;

StepProduct readSample(const std::string& name, double deflection = 0.0) {
  auto product = importStep(stepFile(name), deflection);
  EXPECT_TRUE(product) << toString(product.error());
  return product ? std::move(*product) : StepProduct();
}

double surfaceAreaOf(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return area;
}

/// Expects a closed, consistently oriented mesh within deflection times area of the true volume (cubic millimetres).
void expectSolid(const Occurrence& part, double volume) {
  const MeshAudit result = audit(*part.mesh);
  EXPECT_TRUE(result.closed());
  EXPECT_TRUE(result.consistentlyOriented);
  EXPECT_EQ(part.facesWithoutMesh, 0U);
  EXPECT_NEAR(result.volume, volume * kMm3, part.deflection * surfaceAreaOf(*part.mesh));
}

double ringVolume() {
  const double hole = (1.9 * 1.9 + 1.9 * 0.9 + 0.9 * 0.9) / 3.0;
  return std::numbers::pi * (16.0 - hole);
}

TEST(StepHealing, AConeWhoseSeamIsAtPiIsTriangulatedAndTold) {
  for (const double asked : {0.0, 1e-4, 5e-6}) {
    SCOPED_TRACE(asked);
    const StepProduct product = readSample("countersunk-ring.step", asked);
    ASSERT_EQ(product.parts.size(), 1U);
    expectSolid(product.parts.front(), ringVolume());
    ASSERT_EQ(product.warnings.size(), 1U);
    EXPECT_THAT(toString(product.warnings.front().location), HasSubstr("(cone)"));
    EXPECT_THAT(toString(product.warnings.front().location), HasSubstr("face #9"));
    EXPECT_THAT(toString(product.warnings.front().reason), HasSubstr("makes no triangles"));
    EXPECT_THAT(toString(product.warnings.front().reason), HasSubstr("mm of its surface"));
  }
}

/// The deflection of the new triangles is measured, and kept if the polygons of the neighbours permit it.
TEST(StepHealing, TheConeIsWithinItsDeflection) {
  for (const double asked : {1e-4, 5e-6}) {
    SCOPED_TRACE(asked);
    const StepProduct product = readSample("countersunk-ring.step", asked);
    const TriangleMesh& mesh = *product.parts.at(0).mesh;
    std::size_t onCone = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const SurfaceFace& face = mesh.faces[mesh.faceOf[t]];
      if (face.kind != Kind::Cone) continue;
      ++onCone;
      EXPECT_LE(face.deflection, 1.1 * asked);
      for (const std::uint32_t vertex : mesh.triangles[t]) {
        EXPECT_NEAR(signedDistance(face, mesh.vertices[vertex]), 0.0, 1e-12);
      }
    }
    EXPECT_GT(onCone, 30U);
  }
}

TEST(StepHealing, PlanesWhoseBoundariesCrossAsPolygonsAreClosed) {
  const StepProduct product = readSample("thin-rim.step");
  ASSERT_EQ(product.parts.size(), 1U);
  expectSolid(product.parts.front(), std::numbers::pi * (400.0 - 4.0) * 2.0);
  ASSERT_EQ(product.warnings.size(), 2U);
  for (const Diagnostic& warning : product.warnings) {
    EXPECT_THAT(toString(warning.location), HasSubstr("(plane) of 'disc'"));
    EXPECT_THAT(toString(warning.reason), HasSubstr("its boundaries cross"));
  }
}

/// Two faces of a cylinder that enclose a band only together. Triangles of one alone would cross the cylinder.
TEST(StepHealing, FacesThatEncloseNothingAloneAreTriangulatedTogether) {
  const StepProduct product = readSample("wound-band.step", 2e-5);
  ASSERT_EQ(product.parts.size(), 1U);
  const Occurrence& band = product.parts.front();
  EXPECT_LE(band.deflection, 2.5e-5);
  EXPECT_EQ(band.facesWithoutMesh, 0U);
  const double height = 0.25e-3;
  EXPECT_NEAR(surfaceAreaOf(*band.mesh), height * 2.0 * std::numbers::pi * 5e-3, 1e-8);
  const auto isSaid = [](const Diagnostic& warning) {
    return toString(warning.reason).find("together with its neighbour") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(product.warnings.begin(), product.warnings.end(), isSaid));
}

TEST(StepHealing, SaysTheSameTwice) {
  for (const char* name : {"countersunk-ring.step", "thin-rim.step"}) {
    const StepProduct once = readSample(name);
    const StepProduct again = readSample(name);
    ASSERT_EQ(once.parts.size(), again.parts.size());
    EXPECT_EQ(once.parts.at(0).mesh->vertices, again.parts.at(0).mesh->vertices);
    EXPECT_EQ(once.parts.at(0).mesh->triangles, again.parts.at(0).mesh->triangles);
  }
}

/// The sample contains a plate and a unit of two, with volume, area and centroid.
TEST(StepValidation, WhatTheFileStatesAgreesWithTheTriangles) {
  EXPECT_TRUE(readSample("validated.step").warnings.empty());
  EXPECT_TRUE(readSample("validated.step", 1e-4).warnings.empty()) << "coarse triangles are less exact, and say so";
}

TEST(StepValidation, AWrongVolumeAndCentroidAreNamedWithThePart) {
  const StepProduct product = readSample("validated-wrong.step");
  ASSERT_EQ(product.warnings.size(), 2U);
  EXPECT_THAT(toString(product.warnings[0].location), HasSubstr("part 'plate'"));
  EXPECT_THAT(toString(product.warnings[0].reason), HasSubstr("cubic millimetres, and the file states"));
  EXPECT_THAT(toString(product.warnings[1].reason), HasSubstr("the centroid of its triangles is 1"));
}

}  // namespace
}  // namespace glissade
