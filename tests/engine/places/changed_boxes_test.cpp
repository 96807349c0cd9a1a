#include "engine/places/changed_boxes.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

/// Two triangles in the plane z = 0.5.
TriangleMesh sheet() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::vector<Box3> changedBy(const TriangleMesh& mesh, const Vector3& way) {
  return changedBoxes(mesh, transformed(mesh, Pose::translation(way)));
}

double volume(const std::vector<Box3>& boxes) {
  double sum = 0.0;
  for (const Box3& box : boxes) sum += box.volume();
  return sum;
}

TEST(ChangedBoxes, OfABoxThatSlidesLieAtItsEnds) {
  const std::vector<Box3> boxes = changedBy(makeBox({1.0, 1.0, 1.0}), {0.25, 0, 0});
  for (const Box3& box : boxes) {
    EXPECT_EQ(box.sizes().x(), 0.25);
    EXPECT_TRUE(box.min().x() == -0.5 || box.min().x() == 0.5);
  }
  EXPECT_EQ(volume(boxes), 4 * 0.25);  // two triangles at each end
}

TEST(ChangedBoxes, OfABoxThatTurnsAboutAnAxisHoldAllButItsFacesAcross) {
  const TriangleMesh box = makeBox({1.0, 1.0, 1.0});
  const auto boxes = changedBoxes(box, transformed(box, {Vector3::Zero(), fromRollPitchYaw(0, 0, 0.3)}));
  int flat = 0;
  for (const Box3& changed : boxes) flat += changed.sizes().z() == 0.0 ? 1 : 0;
  EXPECT_EQ(flat, 8);  // the rims of top and bottom
  EXPECT_EQ(boxes.size(), 8U + 8U);
}

TEST(ChangedBoxes, OfAnOpenSheetAreWhereItsRimGoes) {
  const std::vector<Box3> boxes = changedBy(sheet(), {0.25, 0, 0});
  ASSERT_EQ(boxes.size(), 2U);  // at x = 0 and x = 1; neither the diagonal nor the edges that slide along themselves
  for (const Box3& box : boxes) EXPECT_EQ(box.sizes(), Vector3(0.25, 1, 0));
}

TEST(ChangedBoxes, AnEdgeIsNoRimWhereTrianglesLieOnBothItsSides) {
  TriangleMesh mesh = sheet();
  std::swap(mesh.triangles[1][1], mesh.triangles[1][2]);  // turned over, with the same neighbour side
  EXPECT_EQ(changedBy(mesh, {0.25, 0, 0}).size(), 2U);
  mesh.vertices[3] = {1, 0.5, 0.5};  // folded onto the other triangle, so that the diagonal is a rim
  EXPECT_EQ(changedBy(mesh, {0.25, 0, 0}).size(), 4U);
}

TEST(ChangedBoxes, NothingMovedNothingChanges) { EXPECT_EQ(volume(changedBy(makeBox({1, 1, 1}), {0, 0, 0})), 0.0); }

}  // namespace
}  // namespace glissade
