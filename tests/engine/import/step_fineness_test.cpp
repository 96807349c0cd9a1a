#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "engine/geometry/mesh_audit.h"
#include "engine/import/step_import.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

using test::stepFile;

/// Largest distance of the middles of edges from a cylinder along z, for its triangles, which extend from one end to
/// the other. Independent of the faces by the import.
double deviationAt(const TriangleMesh& mesh, const Vector3& axis, double radius) {
  const auto distance = [&](const Vector3& point) { return std::hypot(point.x() - axis.x(), point.y() - axis.y()); };
  double most = -1.0;
  for (const auto& triangle : mesh.triangles) {
    const auto isAtRadius = [&](std::uint32_t corner) {
      return std::abs(distance(mesh.vertices[corner]) - radius) < 1e-7;
    };
    const auto isLevelWithFirst = [&](std::uint32_t corner) {
      return std::abs(mesh.vertices[corner].z() - mesh.vertices[triangle[0]].z()) < 1e-7;
    };
    if (!std::all_of(triangle.begin(), triangle.end(), isAtRadius)) continue;
    if (std::all_of(triangle.begin(), triangle.end(), isLevelWithFirst)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 middle = 0.5 * (mesh.vertices[triangle[i]] + mesh.vertices[triangle[(i + 1) % 3]]);
      most = std::max(most, radius - distance(middle));
    }
  }
  return most;
}

std::map<std::string, Occurrence> closeFits(double deflection = 0.0) {
  auto product = importStep(stepFile("close-fits.step"), deflection);
  EXPECT_TRUE(product) << toString(product.error());
  std::map<std::string, Occurrence> parts;
  if (!product) return parts;
  for (Occurrence& part : product->parts) parts[part.path] = part;
  return parts;
}

/// Deflections in radii: the largest of fine faces and the least of other faces.
constexpr double kFine = 0.0031;
constexpr double kCoarse = 0.0035;

TEST(StepFineness, CylindersThatFitCloselyAreFine) {
  const auto parts = closeFits();
  const TriangleMesh& plate = *parts.at("plate").mesh;
  EXPECT_LE(deviationAt(plate, {-0.08, 0, 0}, 0.008), kFine * 0.008);
  EXPECT_LE(deviationAt(plate, {-0.03, 0, 0}, 0.00601), kFine * 0.006);
  EXPECT_LE(deviationAt(*parts.at("pin").mesh, Vector3::Zero(), 0.008), kFine * 0.008);
  EXPECT_LE(deviationAt(*parts.at("spline").mesh, Vector3::Zero(), 0.006), kFine * 0.006);
}

TEST(StepFineness, OthersOfTheSameSolidAreNot) {
  const auto parts = closeFits();
  const TriangleMesh& plate = *parts.at("plate").mesh;
  EXPECT_GT(deviationAt(plate, {0.02, 0, 0}, 0.012), kCoarse * 0.012);
  EXPECT_GT(deviationAt(plate, {0.08, 0, 0}, 0.020), 0.9 * kCoarse * 0.020);
}

/// The second rod begins where the first one ends.
TEST(StepFineness, CylindersEndToEndAreNoFit) {
  EXPECT_GT(deviationAt(*closeFits().at("rod").mesh, Vector3::Zero(), 0.005), kCoarse * 0.005);
}

TEST(StepFineness, SolidsWithFineFacesAreClosed) {
  for (const auto& [path, part] : closeFits()) {
    SCOPED_TRACE(path);
    const MeshAudit found = audit(*part.mesh);
    EXPECT_TRUE(found.closed());
    EXPECT_TRUE(found.consistentlyOriented);
    EXPECT_EQ(part.facesWithoutMesh, 0U);
  }
}

/// A deflection that a person states is used.
TEST(StepFineness, AStatedDeflectionHoldsForAllFaces) {
  const auto parts = closeFits(2e-4);
  EXPECT_GT(deviationAt(*parts.at("plate").mesh, {-0.08, 0, 0}, 0.008), kCoarse * 0.008);
}

}  // namespace
}  // namespace glissade
