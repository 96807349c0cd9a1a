#include "engine/fits/alternatives.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"
#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

/// Boxes that share a slab: the share of the larger one's volume is known.
TEST(Alternatives, AreBodiesThatFillAtLeastHalfOfThePlaceTogether) {
  RandomStream random(1, "alternatives");
  for (const double shift : {0.002, 0.01, 0.018, 0.022, 0.03}) {
    const Pose place = randomPose(random, 0.2);
    const std::vector<RigidBody> bodies{
        test::partAt("a", makeBox({0.04, 0.03, 0.02}), place),
        test::partAt("b", makeBox({0.04, 0.03, 0.02}), place * Pose::translation({shift, 0.0, 0.0}))};
    const auto found = findAlternatives(bodies);
    const double share = 1.0 - shift / 0.04;
    ASSERT_EQ(found.size(), share >= 0.5 ? 1U : 0U) << share;
    if (share < 0.5) continue;
    EXPECT_NEAR(found.front().share, share, 0.02);
    EXPECT_NE(toString(warningsOf(found, bodies).front().advice).find("--without a"), std::string::npos);
  }
}

/// Contacts of bodies whose surfaces coincide have no overlap.
TEST(Alternatives, TheSameBodyTwiceIsOne) {
  const TriangleMesh box = makeBox({0.04, 0.03, 0.02});
  const auto found =
      findAlternatives({test::partAt("a", box, Pose::identity()), test::partAt("b", box, Pose::identity())});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found.front().share, 1.0, 1e-9);
}

TEST(Alternatives, ThatHaveABodyInCommonAreVariantsOfOnePart) {
  using Groups = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(variantsOf({{0, 4}, {1, 2}, {2, 3}, {3, 5}}), (Groups{{0, 4}, {1, 2, 3, 5}}));
  EXPECT_EQ(variantsOf({{0, 1}, {2, 3}, {1, 2}}), (Groups{{0, 1, 2, 3}}));
  EXPECT_TRUE(variantsOf({}).empty());
}

TEST(Alternatives, AScrewInABlockWithoutAHoleIsNone) {
  EXPECT_TRUE(findAlternatives({test::partAt("block", makeBox({0.05, 0.05, 0.03}), Pose::identity()),
                                test::partAt("screw", test::makeRing(0.0, 0.003, 0.04, 24), Pose::identity())})
                  .empty());
}

TEST(Alternatives, OpenBodiesAndThoseThatOnlyTouchAreNone) {
  const TriangleMesh box = makeBox({0.04, 0.03, 0.02});
  TriangleMesh open = box;
  open.triangles.pop_back();
  EXPECT_TRUE(
      findAlternatives({test::partAt("a", box, Pose::identity()), test::partAt("b", open, Pose::identity())}).empty());
  EXPECT_TRUE(findAlternatives({test::partAt("a", box, Pose::identity()),
                                test::partAt("b", box, Pose::translation({0.04, 0.0, 0.0}))})
                  .empty());
}

}  // namespace
}  // namespace glissade
