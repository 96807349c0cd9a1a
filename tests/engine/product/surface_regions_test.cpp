#include "engine/product/surface_regions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/geometry/primitives.h"
#include "tests/engine/product/ring.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

constexpr double kRegionsRoom = 0.5;  ///< half width of where bodies are put, metres

TEST(SurfaceRegions, FindTheExactCylindersOfTurnedRingsHoweverCoarse) {
  RandomStream random(7, "rings");
  for (int round = 0; round < 40; ++round) {
    const double inner = 0.001 + 0.02 * random.uniform();
    const double outer = inner + 0.001 + 0.02 * random.uniform();
    const double length = 0.002 + 0.1 * random.uniform();
    const int segments = 12 + static_cast<int>(60.0 * random.uniform());
    const Pose place = randomPose(random, kRegionsRoom);
    const SurfaceRegions found = findSurfaceRegions(transformed(test::makeRing(inner, outer, length, segments), place));
    ASSERT_EQ(found.cylinders.size(), 2U) << "segments " << segments;
    EXPECT_EQ(found.planes.size(), 2U);
    for (const CylinderRegion& cylinder : found.cylinders) {
      EXPECT_NEAR(cylinder.radius, cylinder.shaft ? outer : inner, 1e-7);
      EXPECT_NEAR(cylinder.high - cylinder.low, length, 1e-6);
      EXPECT_NEAR((place.position - cylinder.point).cross(cylinder.direction).norm(), 0.0, 1e-7);
      const double sagitta = cylinder.radius * (1.0 - std::cos(3.14159265358979323846 / segments));
      EXPECT_NEAR(cylinder.sagitta, sagitta, 1e-7);
    }
    EXPECT_NE(found.cylinders[0].shaft, found.cylinders[1].shaft);
  }
}

TEST(SurfaceRegions, TakeAPrismAsPlanes) {
  for (const int sides : {4, 6, 8}) {
    const SurfaceRegions found = findSurfaceRegions(test::makeRing(0.0, 0.01, 0.02, sides));
    EXPECT_TRUE(found.cylinders.empty()) << sides;
    EXPECT_EQ(found.planes.size(), static_cast<std::size_t>(sides) + 2) << sides;
  }
}

TEST(SurfaceRegions, LeaveASphereFree) {
  const SurfaceRegions found = findSurfaceRegions(makeSphere(0.02, 3));
  EXPECT_TRUE(found.cylinders.empty());
  const auto isFree = [](const SurfaceRegions::Label& label) { return label.kind == SurfaceRegions::Kind::Free; };
  EXPECT_TRUE(std::all_of(found.labels.begin(), found.labels.end(), isFree));
}

}  // namespace
}  // namespace glissade
