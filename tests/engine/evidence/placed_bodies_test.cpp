#include "engine/evidence/placed_bodies.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

Body moved(Body body, const Pose& pose) {
  body.X_WB = pose * body.X_WB;
  return body;
}

PairBounds boundsOf(PlacedBodies& bodies, const Body& one, const Body& other) {
  return bodies.boundsOf({one, one.X_WB}, {other, other.X_WB}, {}, nullptr, {});
}

void expectSame(const AllowanceBound& a, const AllowanceBound& b) {
  EXPECT_EQ(a.most, b.most);
  EXPECT_EQ(a.atMost, b.atMost);
  EXPECT_EQ(a.inFit, b.inFit);
}

class PlacedBodiesTest : public testing::Test {
 protected:
  Body peg = test::checkBody("peg", test::prism(24, 0.01, 0.03));
  Body plate = test::checkBody("plate", test::holedPlate(24, 0.00995, 0.03, 0.005, 0.015));
};

TEST_F(PlacedBodiesTest, MeasureAPairAsItIsMeasuredInTheWorld) {
  const PlacedBody a(peg, peg.X_WB);
  const PlacedBody b(plate, plate.X_WB);
  const MeasuredPair pair = measurePair(a, b, {});
  const PairBounds direct = check::boundsOf({a, pair.one}, {b, pair.other}, {}, nullptr);
  PlacedBodies bodies;
  const PairBounds found = boundsOf(bodies, peg, plate);
  ASSERT_GT(direct.one.most, 4e-5);
  EXPECT_NEAR(found.one.most, direct.one.most, 1e-9);
  EXPECT_NEAR(found.other.most, direct.other.most, 1e-9);
}

/// The result does not depend on the pair's place in the world, on the first measured pair, or on the order of the two.
TEST_F(PlacedBodiesTest, CongruentPairsAreOnePair) {
  RandomStream random(7, "placed bodies");
  PlacedBodies many;
  for (int i = 0; i < 20; ++i) {
    const Pose pose{Vector3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)),
                    fromRotationVector(Vector3(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), 0.1))};
    const Body one = moved(peg, pose);
    const Body other = moved(plate, pose);
    PlacedBodies own;
    const PairBounds alone = boundsOf(own, one, other);
    const PairBounds found = boundsOf(many, one, other);
    const PairBounds exchanged = boundsOf(many, other, one);
    expectSame(found.one, alone.one);
    expectSame(found.other, alone.other);
    EXPECT_EQ(exchanged.one.largest.overlap, found.other.largest.overlap);
    EXPECT_EQ(exchanged.other.largest.overlap, found.one.largest.overlap);
  }
}

TEST_F(PlacedBodiesTest, APairThatIsElsewhereIsAnotherPair) {
  PlacedBodies bodies;
  const PairBounds inHole = boundsOf(bodies, peg, plate);
  const PairBounds shifted = boundsOf(bodies, peg, moved(plate, Pose::translation({0.0, 1e-5, 0.0})));
  const PairBounds away = boundsOf(bodies, peg, moved(plate, Pose::translation({0.0, 0.2, 0.0})));
  EXPECT_NEAR(shifted.one.most - inHole.one.most, 1e-5, 2e-6);
  EXPECT_FALSE(away.one.inFit);
  EXPECT_EQ(away.one.most, 0.0);
}

}  // namespace
}  // namespace glissade::check
