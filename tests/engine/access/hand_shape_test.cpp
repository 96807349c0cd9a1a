#include "engine/access/hand_shape.h"

#include <gtest/gtest.h>

#include <array>

#include "engine/access/hand_hold.h"
#include "engine/access/loft.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/sequence/solid_mass.h"

namespace glissade {
namespace {

constexpr double kMillimetre = 1e-3;

std::array<HandMeasures, 3> bySize() {
  return {measuresOf(HandSize::SmallWoman), measuresOf(HandSize::Average), measuresOf(HandSize::LargeMan)};
}

TEST(HandMeasures, GrowWithTheSize) {
  const auto sizes = bySize();
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i) {
    EXPECT_LT(sizes[i].handLength, sizes[i + 1].handLength);
    EXPECT_LT(sizes[i].palmLength, sizes[i + 1].palmLength);
    EXPECT_LT(sizes[i].handBreadth, sizes[i + 1].handBreadth);
    EXPECT_LT(sizes[i].handThickness(), sizes[i + 1].handThickness());
    EXPECT_LT(sizes[i].forearmLength(), sizes[i + 1].forearmLength());
    EXPECT_LT(HandShapes(kHandSizes[i]).largestOpening(), HandShapes(kHandSizes[i + 1]).largestOpening());
  }
  for (const HandSize size : kHandSizes) EXPECT_EQ(kHandSizeNames.find(kHandSizeNames.of(size)), size);
  EXPECT_FALSE(kHandSizeNames.find("p99"));
}

TEST(HandShape, ForearmAndPalmAreAsLargeAsTheMeasures) {
  for (const HandMeasures& hand : bySize()) {
    const Box3 forearm = boundingBox(forearmShape(hand));
    EXPECT_NEAR(-forearm.min().z(), hand.forearmLength(), kMillimetre);
    EXPECT_LT(forearm.sizes().y(), hand.forearmCircumference / 2.8) << "about a third of the circumference";
    const Box3 fist = boundingBox(handShape(hand, fistPosture(hand, 0.02)));
    EXPECT_NEAR(-fist.min().y(), 0.5 * hand.handBreadth, 0.1 * hand.handBreadth) << "without the thumb";
  }
}

TEST(HandShape, ConsistsOfClosedSolidsTurnedOutwards) {
  const HandMeasures& hand = measuresOf(HandSize::Average);
  EXPECT_TRUE(audit(forearmShape(hand)).closed());
  EXPECT_GT(solidMass(forearmShape(hand)).volume, 0.0);
  const TriangleMesh limb = taperedLimb(Vector3::Zero(), 0.01, {0.0, 0.03, 0.04}, 0.006);
  EXPECT_TRUE(audit(limb).closed());
  EXPECT_GT(solidMass(limb).volume, 0.0);
  const TriangleMesh pinch = handShape(hand, *pinchPosture(hand, {0.03, 4, kPinchTilts[0]}));
  EXPECT_TRUE(audit(pinch).closed());
  EXPECT_GT(solidMass(pinch).volume, 0.0);
}

/// The ball at the end of a digit, in the grip's frame.
Digit::Joint tipOf(const HandPosture& posture, std::size_t digit) {
  const Digit::Joint& tip = posture.digits[digit].joints.back();
  return {inverse(posture.X_HG) * tip.p_H, tip.radius};
}

TEST(HandPosture, PadsAreAsFarApartAsTheOpening) {
  for (const HandMeasures& hand : bySize()) {
    for (const double tilt : kPinchTilts) {
      for (const double opening : {0.004, 0.02, 0.04}) {
        const auto posture = pinchPosture(hand, {opening, 2, tilt});
        ASSERT_TRUE(posture);
        const Digit::Joint thumb = tipOf(*posture, 0);
        const Digit::Joint index = tipOf(*posture, 1);
        EXPECT_NEAR(thumb.p_H.x() - thumb.radius, 0.5 * opening, 1e-6) << "x is to the thumb";
        EXPECT_NEAR(index.p_H.x() + index.radius, -0.5 * opening, 1e-6);
        EXPECT_NEAR(thumb.p_H.z(), 0.0, 1e-6) << "pads are opposite to each other";
        EXPECT_GT(posture->room, 0.0);
      }
    }
  }
}

TEST(HandPosture, NoPhalanxIsStretched) {
  for (const HandMeasures& hand : bySize()) {
    for (const double opening : {0.004, 0.03, 0.05}) {
      const auto posture = pinchPosture(hand, {opening, 4, kPinchTilts[0]});
      ASSERT_TRUE(posture);
      for (std::size_t digit = 1; digit < 5; ++digit) {
        double length = posture->digits[digit].joints.back().radius;
        for (std::size_t i = 1; i < 4; ++i) {
          const auto& joints = posture->digits[digit].joints;
          length += (joints[i].p_H - joints[i - 1].p_H).norm();
        }
        EXPECT_LT(length, 1.1 * (hand.handLength - 0.8 * hand.palmLength)) << digit;
      }
    }
  }
}

TEST(HandPosture, AHandDoesNotOpenForever) {
  const HandMeasures& hand = measuresOf(HandSize::LargeMan);
  EXPECT_FALSE(pinchPosture(hand, {0.5, 2, kPinchTilts[0]}));
  EXPECT_FALSE(pinchPosture(hand, {0.5, 2, kPinchTilts[1]}));
}

}  // namespace
}  // namespace glissade
