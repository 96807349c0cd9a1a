#include "engine/evidence/cut_shape.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

PlacedBody meshAt(TriangleMesh mesh, const Pose& X_WB = Pose::identity()) {
  return PlacedBody(test::checkBody("body", std::move(mesh)), X_WB);
}

PlacedBody box(const Vector3& low, const Vector3& high) {
  return meshAt(makeBox(high - low), Pose::translation(0.5 * (low + high)));
}

Cut cutOf(const PlacedBody& one, const PlacedBody& other) { return check::cutOf(cutShapeOf(one, other), false, false); }

const PlacedBody kPlate = box({-0.03, -0.03, 0.0}, {0.03, 0.03, 0.005});
const PlacedBody kRod = meshAt(test::prism(32, 0.005, 0.4), Pose::translation({0.002, 0.001, -0.2}));

TEST(CutShape, APlateHasTheHoleOfALongRod) {
  const CutShape shape = cutShapeOf(kPlate, kRod);
  EXPECT_TRUE(shape.oneStaysWhole);
  EXPECT_FALSE(shape.otherStaysWhole) << "the rod falls into two pieces";
  EXPECT_EQ(cutOf(kPlate, kRod), Cut::One);
  EXPECT_EQ(cutOf(kRod, kPlate), Cut::Other);
  EXPECT_EQ(check::cutOf(cutShapeOf(kPlate, kRod), false, true), Cut::NotWhole) << "whoever names the rod";
}

TEST(CutShape, NoBodyIsCutThrough) {
  const PlacedBody across = meshAt(test::prism(32, 0.005, 0.4),
                                   {Vector3(-0.2, 0.001, 0.0), fromRollPitchYaw(0.0, 0.5 * std::numbers::pi, 0.0)});
  EXPECT_EQ(cutOf(kRod, across), Cut::NotWhole) << "rods of one radius";
  const PlacedBody ring = meshAt(test::holedPlate(24, 0.02, 0.024, -0.002, 0.002));
  const PlacedBody bar = box({0.015, -0.004, -0.05}, {0.03, 0.004, 0.05});
  EXPECT_EQ(cutOf(ring, bar), Cut::Other) << "the bar is around the limb of the ring";
  const PlacedBody disc = meshAt(test::prism(32, 0.005, 0.004), Pose::translation({0.002, 0.001, 0.0}));
  EXPECT_EQ(cutOf(kRod, disc), Cut::NotWhole) << "the disc has the outline of the rod";
  const PlacedBody turned = meshAt(test::prism(37, 0.005, 0.004, 0.03), Pose::translation({0.002, 0.001, 0.0}));
  const CutShape shape = cutShapeOf(kRod, turned);
  EXPECT_FALSE(shape.otherStaysWhole && shape.oneStaysWhole);
}

TEST(CutShape, WhatIsAroundTheOtherOneHasTheHole) {
  const PlacedBody block = box({-0.03, -0.03, -0.05}, {0.03, 0.03, 0.0});
  const PlacedBody end = meshAt(test::prism(24, 0.006, 0.1), Pose::translation({0.0, 0.0, -0.02}));
  EXPECT_EQ(cutOf(block, end), Cut::One);
  EXPECT_EQ(cutOf(end, block), Cut::Other);
  const PlacedBody inside = box({-0.01, -0.01, -0.02}, {0.01, 0.01, -0.01});
  EXPECT_EQ(cutOf(block, inside), Cut::One) << "nothing would be left of the other one";
  const PlacedBody flange = meshAt(test::holedPlate(48, 0.01, 0.025, -0.0021, 0.006));
  EXPECT_EQ(cutOf(block, flange), Cut::One) << "a flange that is drawn too low";
}

TEST(CutShape, HolesAreManyAndFacesMayTouch) {
  TriangleMesh comb = makeBox({0.05, 0.02, 0.01});
  for (Vector3& v : comb.vertices) v.z() += 0.01;
  for (const double x : {-0.015, 0.015}) {
    append(comb, transformed(test::prism(16, 0.003, 0.02), Pose::translation({x, 0.0, -0.01})));
  }
  // The pins and the base are one closed surface each, and overlap: every point is inside of one of them.
  const PlacedBody pins = meshAt(comb);
  EXPECT_EQ(cutOf(kPlate, pins), Cut::One) << "two holes, and the base touches the plate";
}

TEST(CutShape, WhereItIsNotClearAPersonNamesTheBody) {
  const PlacedBody along = box({-0.05, -0.005, 0.0}, {0.05, 0.005, 0.01});
  const PlacedBody across = box({-0.005, -0.05, 0.005}, {0.005, 0.05, 0.015});
  EXPECT_EQ(cutOf(along, across), Cut::NotClear) << "a halved joint";
  EXPECT_EQ(check::cutOf(cutShapeOf(along, across), true, false), Cut::One);
  EXPECT_EQ(check::cutOf(cutShapeOf(along, across), false, true), Cut::Other);
  EXPECT_EQ(check::cutOf(cutShapeOf(along, across), true, true), Cut::NotClear);
  const PlacedBody longer = box({0.049, -0.005, 0.0}, {0.15, 0.005, 0.01});
  EXPECT_EQ(cutOf(along, longer), Cut::One) << "bars that are drawn too long: either";
  EXPECT_EQ(cutOf(longer, along), Cut::One);
}

TEST(CutShape, BodiesThatTouchOrAreOpenAreNotCut) {
  const PlacedBody below = box({-0.03, -0.03, -0.01}, {0.03, 0.03, 0.0});
  EXPECT_EQ(cutOf(kPlate, below), Cut::NotWhole);
  TriangleMesh open = makeBox({0.01, 0.01, 0.1});
  open.triangles.pop_back();
  EXPECT_EQ(cutOf(kPlate, meshAt(open)), Cut::NotWhole);
}

}  // namespace
}  // namespace glissade::check
