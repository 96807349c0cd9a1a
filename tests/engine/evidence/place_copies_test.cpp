#include "engine/evidence/place_copies.h"

#include <gtest/gtest.h>

#include "tests/engine/check/check_bodies.h"
#include "tests/engine/fits/turned_parts.h"

namespace glissade::evidence {
namespace {

using test::checkBody;

/// Indices of the copies of each place.
std::vector<std::vector<std::size_t>> copiesOf(const std::vector<Body>& bodies, const std::vector<BodyId>& named = {}) {
  std::vector<std::vector<std::size_t>> all;
  for (const PlaceCopies& place : placeCopiesIn(bodies, named)) {
    all.push_back({place.body});
    all.back().insert(all.back().end(), place.copies.begin(), place.copies.end());
  }
  return all;
}

Body wheel(const std::string& id, int corners, double turn) {
  Body body = checkBody(id, test::prism(corners, 0.05, 0.012, turn));
  body.deflection = 1e-4;
  return body;
}

/// A round wheel that is turned with each of its rollers, and a body of another shape in its place.
TEST(PlaceCopies, AShapeInOnePlaceIsOneBody) {
  std::vector<Body> bodies;
  for (int i = 0; i < 4; ++i) bodies.push_back(wheel("wheel" + std::to_string(i), 64, 0.7 * i));
  bodies.push_back(checkBody("box", makeBox({0.1, 0.1, 0.012}), {0.0, 0.0, 0.006}));
  bodies.push_back(checkBody("beside", test::prism(64, 0.05, 0.012), {0.0, 0.0, 0.001}));
  EXPECT_EQ(copiesOf(bodies), (std::vector<std::vector<std::size_t>>{{0, 1, 2, 3}}));
  EXPECT_EQ(copiesOf(bodies, {"wheel2"}), (std::vector<std::vector<std::size_t>>{{0, 1, 3}})) << "a plan names it";
  const Warnings warnings = warningsOf(placeCopiesIn(bodies, {}), bodies);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(toString(warnings[0]).find("'wheel0': is drawn 4 times in one place"), std::string::npos)
      << toString(warnings[0]);
  EXPECT_NE(toString(warnings[0]).find("wheel1, wheel2, wheel3"), std::string::npos);
}

TEST(PlaceCopies, TurnedPolygonsAreNotOneShape) {
  EXPECT_TRUE(copiesOf({wheel("a", 8, 0.0), wheel("b", 8, 0.3)}).empty());
}

/// Sheets that lie on each other are nearer than the deflection of their curved faces.
TEST(PlaceCopies, NestedFoilsAreTwoBodies) {
  Body inner = checkBody("inner", test::tubeMesh(test::circle(0.01), test::circle(0.01005), 0.0, 0.02));
  Body outer = checkBody("outer", test::tubeMesh(test::circle(0.01005), test::circle(0.0101), 0.0, 0.02));
  inner.deflection = outer.deflection = 1e-4;
  EXPECT_TRUE(copiesOf({inner, outer}).empty());
}

TEST(PlaceCopies, OpenSurfacesAreNoCopies) {
  TriangleMesh open = makeBox({0.1, 0.1, 0.1});
  open.triangles.pop_back();
  EXPECT_TRUE(copiesOf({checkBody("a", open), checkBody("b", open)}).empty());
}

}  // namespace
}  // namespace glissade::evidence
