// Moving a body gives the same octree as building it anew.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/primitives.h"
#include "engine/places/octree.h"
#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

const Box3 kWorkspace(Vector3::Zero(), Vector3(1.0, 0.75, 0.5));
const OctreeResolution kResolution{1.0 / 32, 0};

class OctreeMoves : public testing::TestWithParam<int> {};

TEST_P(OctreeMoves, EqualAFreshOctreeAfterEveryMove) {
  RandomStream stream(static_cast<std::uint64_t>(GetParam()), "moves");
  std::vector<RigidBody> bodies = test::randomBodies(stream, 6);
  Octree octree(bodies, kWorkspace, kResolution);
  for (int move = 0; move < 25; ++move) {
    const auto body = static_cast<std::size_t>(stream.uniform(0, 6));
    Pose& X_WB = bodies[body].X_WB;
    switch (move % 4) {
      case 0: X_WB.position += 0.03 * randomPose(stream, 1.0).position; break;
      case 1: X_WB = randomPose(stream, 0.8); break;
      case 2: X_WB.position = Vector3(5, 5, 5); break;  // out of the workspace
      default: X_WB = Pose::translation(Vector3(0.5, 0.5, 0.25)); break;
    }
    octree.moveBody(body, X_WB);
    ASSERT_TRUE(octree == Octree(bodies, kWorkspace, kResolution)) << "move " << move;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OctreeMoves, testing::Range(1, 7));

/// Shapes with faces perpendicular to the axes: a box, two that overlap, an open box, a sheet that is folded over, a
/// cylinder and a wedge.
std::vector<TriangleMesh> shapesOnTheAxes() {
  TriangleMesh overlapping = test::boxBetween({0, 0, 0}, {0.25, 0.125, 0.1});
  append(overlapping, test::boxBetween({0.1, 0, 0}, {0.2, 0.3, 0.1}));
  TriangleMesh open = makeBox({0.2, 0.25, 0.3});
  open.triangles.resize(open.triangles.size() - 3);
  TriangleMesh folded;
  folded.vertices = {{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}, {0.2, 0.1, 0}};
  folded.triangles = {{0, 1, 2}, {0, 2, 3}};
  TriangleMesh wedge = makeBox({0.3, 0.2, 0.2});
  for (Vector3& vertex : wedge.vertices) {
    if (vertex.z() > 0.0) vertex.x() *= 0.5;
  }
  return {makeBox({0.25, 0.3, 0.2}), overlapping, open, folded, makeCylinder(0.1, 0.3, 12), wedge};
}

/// A pose moved along an axis by any length, by whole cells, in a plane, or turned about an axis.
Pose slid(const Pose& X_WB, RandomStream& stream) {
  Pose moved = X_WB;
  const int axis = static_cast<int>(stream.uniform(0, 3));
  switch (static_cast<int>(stream.uniform(0, 4))) {
    case 0: moved.position[axis] += stream.uniform(-0.1, 0.1); break;
    case 1: moved.position[axis] += std::round(stream.uniform(-3, 3)) * kResolution.cellSize; break;
    case 2:
      for (int i = 0; i < 3; ++i) moved.position[i] += i == axis ? 0.0 : stream.uniform(-0.1, 0.1);
      break;
    default: moved.orientation = fromRollPitchYaw(0, 0, stream.uniform(-3, 3)); break;
  }
  moved.position = moved.position.cwiseMax(0.0).cwiseMin(0.75);
  return moved;
}

class OctreeSlides : public testing::TestWithParam<int> {};

TEST_P(OctreeSlides, EqualAFreshOctreeAfterEverySlide) {
  RandomStream stream(static_cast<std::uint64_t>(GetParam()), "slides");
  for (const TriangleMesh& shape : shapesOnTheAxes()) {
    RigidBody body = boxBody("slides", {1, 1, 1}, Pose::translation(Vector3(0.375, 0.375, 0.25)));
    body.mesh = std::make_shared<const TriangleMesh>(shape);
    Octree octree({body}, kWorkspace, kResolution);
    for (int move = 0; move < 40; ++move) {
      body.X_WB = slid(body.X_WB, stream);
      octree.moveBody(0, body.X_WB);
      ASSERT_TRUE(octree == Octree({body}, kWorkspace, kResolution)) << "move " << move;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OctreeSlides, testing::Range(1, 9));

TEST(OctreeMove, ThereAndBackIsTheSameAndTellsWhatItCost) {
  RandomStream stream(8, "moves");
  const std::vector<RigidBody> bodies = test::randomBodies(stream, 4);
  const Octree before(bodies, kWorkspace, kResolution);
  Octree octree = before;
  const Octree::Change out = octree.moveBody(1, Pose::translation(Vector3(9, 9, 9)));
  EXPECT_GT(out.cellsLeft, 0U);
  EXPECT_EQ(out.cellsEntered, 0U);
  EXPECT_FALSE(octree == before);
  const Octree::Change back = octree.moveBody(1, bodies[1].X_WB);
  EXPECT_EQ(back.cellsLeft, 0U);
  EXPECT_EQ(back.cellsEntered, out.cellsLeft);
  EXPECT_TRUE(octree == before);
  const Octree::Change none = octree.moveBody(1, bodies[1].X_WB);
  EXPECT_EQ(none.cellsLeft + none.cellsEntered, 0U);
}

TEST(OctreeMove, ByOneCellLeavesAndEntersOneLayer) {
  const RigidBody box = boxBody("box", {0.25, 0.25, 0.25}, Pose::translation(Vector3(0.25, 0.25, 0.25)));
  Octree octree({box}, kWorkspace, kResolution);
  const Octree::Change change = octree.moveBody(0, Pose::translation(Vector3(0.25 + 1.0 / 32, 0.25, 0.25)));
  EXPECT_EQ(change.cellsLeft, 64U);
  EXPECT_EQ(change.cellsEntered, 64U);
}

}  // namespace
}  // namespace glissade
