#include "engine/evidence/thinning.h"

#include <gtest/gtest.h>

#include "engine/evidence/face_regions.h"
#include "engine/geometry/triangle_pair.h"
#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

/// Allowances for the side of a prism, and none for its ends.
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

/// A prism without its lower end.
TriangleMesh openPrism() {
  TriangleMesh mesh = test::prism(24, 0.01, 0.03);
  std::vector<TriangleIndices> kept;
  for (const TriangleIndices& t : mesh.triangles) {
    if (faceNormal(mesh, t).z() > -0.5) kept.push_back(t);
  }
  mesh.triangles = kept;
  return mesh;
}

TEST(Thinning, AnOpenSurfaceIsThinnedFarFromItsOpening) {
  const TriangleMesh whole = openPrism();
  std::vector<double> allowances;
  for (const TriangleIndices& t : whole.triangles) allowances.push_back(faceNormal(whole, t).z() > 0.5 ? 1e-4 : 0.0);
  const Box3 box = boundingBox(thinned(whole, allowances));
  EXPECT_NEAR(box.max().z(), 0.03 - 1e-4, 1e-9);
  EXPECT_EQ(box.min().z(), 0.0);
  EXPECT_EQ(thinned(whole, ofSide(whole, 1e-4)).vertices, whole.vertices) << "the sides end at the opening";
}

TEST(Thinning, ASheetStaysAsItIs) {
  TriangleMesh sheet;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) sheet.vertices.emplace_back(x, y, 0.0);
  }
  for (const std::uint32_t corner : {0U, 1U, 3U, 4U}) {
    sheet.triangles.push_back({corner, corner + 3, corner + 1});
    sheet.triangles.push_back({corner + 1, corner + 3, corner + 4});
  }
  for (int i = 0; i < 3; ++i) {  // eight times as fine: faces at the middle are far from its edges
    TriangleMesh finer;
    for (const auto& [a, b, c] : sheet.triangles) {
      const Vector3& p = sheet.vertices[a];
      const Vector3& q = sheet.vertices[b];
      const Vector3& r = sheet.vertices[c];
      const Vector3 pq = 0.5 * (p + q);
      const Vector3 qr = 0.5 * (q + r);
      const Vector3 rp = 0.5 * (r + p);
      for (const auto& part : {Triangle{p, pq, rp}, Triangle{pq, q, qr}, Triangle{rp, qr, r}, Triangle{pq, qr, rp}}) {
        const auto first = static_cast<std::uint32_t>(finer.vertices.size());
        finer.vertices.insert(finer.vertices.end(), part.begin(), part.end());
        finer.triangles.push_back({first, first + 1, first + 2});
      }
    }
    sheet = welded(finer);
  }
  std::vector<double> allowances;
  for (const auto& [a, b, c] : sheet.triangles) {
    const Vector3 middle = (sheet.vertices[a] + sheet.vertices[b] + sheet.vertices[c]) / 3.0;
    allowances.push_back(middle.head<2>().norm() < 0.5 ? 0.01 : 0.0);
  }
  EXPECT_EQ(thinned(sheet, allowances).vertices, sheet.vertices);
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
