#include "engine/evidence/units.h"

#include <gtest/gtest.h>

#include <deque>

#include "tests/engine/fits/turned_parts.h"

namespace glissade::evidence {
namespace {

using test::circle;
using test::tubeMesh;

/// Bodies about z.
class Bodies {
 public:
  Bodies& add(const std::string& name, TriangleMesh mesh, const Vector3& at = Vector3::Zero()) {
    all_.push_back({BodyId(name), name, std::make_shared<const TriangleMesh>(std::move(mesh)), Pose::translation(at)});
    return *this;
  }
  bool areUnit(const std::vector<std::vector<BodyId>>& said = {}) const {
    std::vector<const Body*> bodies;
    for (const Body& body : all_) bodies.push_back(&body);
    PlacedBodies placed;
    return areOneUnit(bodies, said, placed);
  }

 private:
  std::deque<Body> all_;
};

/// A host of 40 mm with a hole of 10 mm, and a ring in it.
bool isInsert(const std::string& name, double radius, double hole = 0.005) {
  return Bodies()
      .add("host", tubeMesh(circle(hole), circle(0.02), 0.0, 0.01))
      .add(name, tubeMesh(circle(0.6 * hole), circle(radius), 0.0, 0.01))
      .areUnit();
}

TEST(Units, WhatIsPressedInOrMeltedInIsAUnit) {
  EXPECT_TRUE(isInsert("ring", 0.00502)) << "pressed in";
  EXPECT_TRUE(isInsert("ring", 0.0054)) << "a small ring in plastic";
  EXPECT_FALSE(isInsert("ring", 0.0108, 0.01)) << "a large ring may be screwed in";
  EXPECT_FALSE(isInsert("ring", 0.005)) << "as wide as its hole";
  EXPECT_TRUE(isInsert("bearing 608", 0.005)) << "as wide as its hole, and a bearing by name";
  EXPECT_TRUE(isInsert("heat-set insert M3", 0.005));
  EXPECT_FALSE(isInsert("bearing 608", 0.0049)) << "loose";
}

Bodies bearingOf(int balls) {
  Bodies bearing;
  bearing.add("inner", tubeMesh(circle(0.004), circle(0.006), -0.0035, 0.0035))
      .add("outer", tubeMesh(circle(0.009), circle(0.011), -0.0035, 0.0035))
      .add("shield", tubeMesh(circle(0.0062), circle(0.0088), 0.0028, 0.003));
  for (int i = 0; i < balls; ++i) {
    const double angle = 2.0 * test::kHalfTurn * i / balls;
    bearing.add("ball" + std::to_string(i), test::ballMesh(0.0015),
                {0.0075 * std::cos(angle), 0.0075 * std::sin(angle), 0.0});
  }
  return bearing;
}

TEST(Units, ARollingBearingIsAUnit) {
  EXPECT_TRUE(bearingOf(7).areUnit());
  EXPECT_FALSE(bearingOf(2).areUnit()) << "two balls are no bearing";
  EXPECT_FALSE(bearingOf(7).add("plate", tubeMesh(circle(0.0112), circle(0.03), -0.01, 0.0)).areUnit());
}

TEST(Units, APersonMakesOne) {
  const Bodies bodies = Bodies()
                            .add("a", test::rodMesh(0.005, 0.0, 0.01))
                            .add("b", test::rodMesh(0.005, 0.02, 0.03))
                            .add("c", test::rodMesh(0.005, 0.04, 0.05));
  EXPECT_FALSE(bodies.areUnit());
  EXPECT_FALSE(bodies.areUnit({{"a", "b"}}));
  EXPECT_TRUE(bodies.areUnit({{"a", "b"}, {"c", "b"}}));
}

}  // namespace
}  // namespace glissade::evidence
