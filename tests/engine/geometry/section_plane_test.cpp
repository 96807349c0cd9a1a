#include "engine/geometry/section_plane.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glissade {
namespace {

const Box3 kSectionBox(Vector3(-1.0, -2.0, -3.0), Vector3(1.0, 2.0, 3.0));

TEST(SectionPlane, TheOtherSideIsTheSamePlane) {
  SectionPlane section{Vector3::UnitY(), 0.5, false, true};
  const Plane one = planeOf(section);
  section.otherSide = true;
  const Plane other = planeOf(section);
  EXPECT_EQ(one.normal, -other.normal);
  EXPECT_EQ(one.offset, 0.5);
  EXPECT_EQ(other.offset, -0.5);
}

TEST(SectionPlane, PlacesGoThroughTheWholeBox) {
  const PlaceRange range = rangeAlong(Vector3(1.0, -1.0, 0.0).normalized(), kSectionBox);
  EXPECT_NEAR(range.least, -3.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(range.greatest, 3.0 / std::sqrt(2.0), 1e-12);
}

TEST(SectionPlane, TheOutlineIsAConvexPolygonInPlaneAndBox) {
  for (const Vector3& direction : {Vector3(1.0, 0.0, 0.0), Vector3(1.0, 1.0, 1.0), Vector3(0.2, -1.0, 0.4)}) {
    const Plane plane{direction.normalized(), 0.1};
    const std::vector<Vector3> outline = outlineInBox(plane, kSectionBox);
    ASSERT_GE(outline.size(), 3U);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector3& p = outline[i];
      EXPECT_NEAR(plane.normal.dot(p), plane.offset, 1e-12);
      EXPECT_LT(kSectionBox.exteriorDistance(p), 1e-12);
      const Vector3& next = outline[(i + 1) % outline.size()];
      const Vector3& after = outline[(i + 2) % outline.size()];
      EXPECT_GT((next - p).cross(after - next).dot(plane.normal), -1e-12);
    }
  }
  EXPECT_TRUE(outlineInBox({Vector3::UnitX(), 1.5}, kSectionBox).empty());
}

}  // namespace
}  // namespace glissade
