// Moving a body gives the same octree as building it afresh.
#include <gtest/gtest.h>

#include "engine/environment/octree.h"
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
