#include "engine/check/thinning.h"

#include <gtest/gtest.h>

#include "engine/check/face_regions.h"
#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

/// Allowances of a prism's side, none of its ends.
std::vector<double> ofSide(const TriangleMesh& mesh, double allowance) {
  std::vector<double> allowances;
  for (const TriangleIndices& t : mesh.triangles) {
    const bool side = std::abs(faceNormal(mesh, t).z()) < 0.5;
    allowances.push_back(side ? allowance : 0.0);
  }
  return allowances;
}

TEST(Thinning, OnlyFacesInTheFitMove) {
  constexpr double kAllowance = 1e-4;
  const TriangleMesh whole = test::prism(24, 0.01, 0.03);
  const TriangleMesh thin = thinned(whole, ofSide(whole, kAllowance));
  ASSERT_EQ(thin.triangles.size(), whole.triangles.size());
  const Box3 box = boundingBox(thin);
  EXPECT_EQ(box.min().z(), 0.0);
  EXPECT_EQ(box.max().z(), 0.03);
  const double across = 0.01 * std::cos(std::numbers::pi / 24);
  for (const TriangleIndices& t : thin.triangles) {
    const Vector3 normal = faceNormal(thin, t);
    if (std::abs(normal.z()) > 0.5) continue;
    EXPECT_NEAR(normal.dot(thin.vertices[t[0]]), across - kAllowance, 1e-9) << "each side moves by all of it";
  }
}

TEST(Thinning, NothingAllowedLeavesTheMeshAsItIs) {
  const TriangleMesh whole = test::prism(24, 0.01, 0.03);
  const TriangleMesh same = thinned(whole, std::vector<double>(whole.triangles.size(), 0.0));
  EXPECT_EQ(same.vertices, whole.vertices);
}

TEST(Thinning, NoMoreThanAFifthOfTheThickness) {
  const TriangleMesh whole = makeBox({0.01, 0.01, 0.001});
  std::vector<double> allowances;
  for (const TriangleIndices& t : whole.triangles) allowances.push_back(faceNormal(whole, t).z() > 0.5 ? 1e-3 : 0.0);
  const Box3 box = boundingBox(thinned(whole, allowances));
  EXPECT_NEAR(box.max().z(), 0.0005 - 0.0002, 1e-9);
  EXPECT_NEAR(box.min().z(), -0.0005, 1e-12);
}

}  // namespace
}  // namespace glissade::check
