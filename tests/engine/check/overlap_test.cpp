#include "engine/check/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "engine/geometry/primitives.h"
#include "tests/engine/product/ring.h"

namespace glissade::check {
namespace {

PlacedBody placed(TriangleMesh mesh, const Pose& X_WB) {
  const Body body{"body", "body", std::make_shared<const TriangleMesh>(std::move(mesh)), X_WB};
  return PlacedBody(body, X_WB);
}

/// A large plate whose lower face is tilted about the middle of a ring's upper face. Most triangles of a fine ring are
/// farther from the plate than the plate is deep: a search that takes the nearest of the others for the nearest of all
/// does not end.
TEST(Overlap, OfATiltedPlateInAFineRingIsThatAtItsRim) {
  constexpr double kOuter = 0.007;
  constexpr double kLength = 0.005;
  constexpr double kThickness = 0.002;
  const PlacedBody ring = placed(test::makeRing(0.004, kOuter, kLength, 400), Pose::identity());
  for (const double tilt : {0.003, 0.01, 0.03}) {
    Pose X_WP;
    X_WP.orientation = Quaternion(Eigen::AngleAxisd(tilt, Vector3::UnitY()));
    X_WP.position = Vector3(0.0, 0.0, 0.5 * kLength) + X_WP.orientation * Vector3(0.0, 0.0, 0.5 * kThickness);
    const PlacedBody plate = placed(makeBox({0.6, 0.4, kThickness}), X_WP);
    const Overlap overlap = overlapIn(ring, plate, {});
    // As far from the face above as from the side.
    const double atRim = kOuter * std::sin(tilt) / (1.0 + std::sin(tilt));
    EXPECT_NEAR(overlap.deepest, atRim, 0.01 * atRim) << tilt;
  }
}

}  // namespace
}  // namespace glissade::check
