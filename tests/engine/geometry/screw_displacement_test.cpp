#include "engine/geometry/screw_displacement.h"

#include <gtest/gtest.h>

#include "engine/geometry/screw_axis.h"

namespace glissade {
namespace {

void expectNear(const Pose& a, const Pose& b) {
  EXPECT_LT((a.position - b.position).norm(), 1e-9);
  EXPECT_LT(angleBetween(a.orientation, b.orientation), 1e-7);
}

TEST(ScrewDisplacement, ContinuesAScrewMotionAboutAnAxisBesideThePose) {
  const ScrewAxis screw{{0.3, -0.2, 0.1}, Vector3(1.0, 2.0, -1.0).normalized(), 0.05};
  const Pose from{{0.5, 0.4, -0.1}, fromRollPitchYaw(0.3, -0.4, 1.0)};
  const ScrewDisplacement motion(from, screwed(screw, from, 0.01));
  expectNear(motion.at(0.0), from);
  for (const double share : {0.5, 1.0, 2.0, 7.5}) expectNear(motion.at(share), screwed(screw, from, 0.01 * share));
}

TEST(ScrewDisplacement, WithoutATurnItIsStraight) {
  const Pose from{{0.5, 0.4, -0.1}, fromRollPitchYaw(0.3, -0.4, 1.0)};
  Pose to = from;
  to.position += Vector3(0.1, 0.0, 0.2);
  expectNear(ScrewDisplacement(from, to).at(3.0), {from.position + Vector3(0.3, 0.0, 0.6), from.orientation});
}

}  // namespace
}  // namespace glissade
