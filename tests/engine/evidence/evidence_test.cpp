#include "engine/evidence/evidence.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/evidence/overlap.h"
#include "tests/engine/check/check_bodies.h"

namespace glissade::check {
namespace {

PlacedBody placed(const Body& body) { return PlacedBody(body, body.X_WB); }

PairBounds boundsOf(const PlacedBody& one, const PlacedBody& other, const FitWords& fits, const PairWord* word) {
  const MeasuredPair pair = measurePair(one, other, {});
  return check::boundsOf({one, pair.one}, {other, pair.other}, fits, word);
}

/// The largest depth of points of the other surface inside the body, by dense samples.
double sampledDepth(const PlacedBody& body, const PlacedBody& other, int steps) {
  double deepest = 0.0;
  for (const Triangle& t : other.tree.triangles()) {
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; i + k <= steps; ++k) {
        const Vector3 p = t[0] + (t[1] - t[0]) * i / steps + (t[2] - t[0]) * k / steps;
        if (body.contains(p)) deepest = std::max(deepest, body.tree.nearest(p, 1e9).distance);
      }
    }
  }
  return deepest;
}

TEST(FaceRegions, AreFlatPiecesOfAMesh) {
  const FaceRegions twelve = faceRegionsOf(test::prism(12, 0.02, 0.01));
  EXPECT_EQ(twelve.count, 14U);
  EXPECT_EQ(std::count_if(twelve.next.begin(), twelve.next.end(), [](const auto& next) { return next.size() >= 2; }),
            12)
      << "each side has two facets next to it";
  const FaceRegions eight = faceRegionsOf(test::prism(8, 0.02, 0.01));
  EXPECT_EQ(eight.count, 10U);
  EXPECT_TRUE(std::all_of(eight.next.begin(), eight.next.end(), [](const auto& next) { return next.empty(); }));
  EXPECT_EQ(faceRegionsOf(makeBox({1, 2, 3})).count, 6U);
  const FaceRegions round = faceRegionsOf(test::prism(36, 0.02, 0.01));
  EXPECT_NEAR(*std::max_element(round.sagitta.begin(), round.sagitta.end()),
              0.02 * (1.0 - std::cos(std::numbers::pi / 36)), 1e-6);
}

TEST(FaceRegions, AreTheFacesOfACadFile) {
  TriangleMesh faced = test::prism(36, 0.02, 0.01);
  faced.faces = {SurfaceFace{}, SurfaceFace{}, SurfaceFace{}};
  for (std::size_t t = 0; t < faced.triangles.size(); ++t) {
    faced.faceOf.push_back(t % 4 < 2 ? 0U : static_cast<std::uint32_t>(t % 4 - 1));
  }
  const FaceRegions regions = faceRegionsOf(faced);
  EXPECT_EQ(regions.count, 3U);
}

/// A real fit at one side of a prism would free it under a lip over the other sides.
TEST(Evidence, AnOverlapAtOneFacetIsNoneOfTheOthers) {
  constexpr double kOverlap = 2e-4;
  const double half = std::numbers::pi / 24;
  const Body prism = test::checkBody("prism", test::prism(24, 0.02, 0.02, -half));
  const double inside = 0.02 * std::cos(half) - kOverlap;
  const Body bump = test::checkBody("bump", makeBox({0.01, 0.002, 0.01}), {inside + 0.005, 0.0, 0.01});
  const AllowanceBound bound = boundsOf(placed(prism), placed(bump), {true, 0.0, {}}, nullptr).one;
  EXPECT_NEAR(bound.most, kOverlap + assembledMargin(placed(prism).radius), 3e-6);
  const std::vector<double> most = mostOfTriangles(bound, prism.mesh->triangles.size());
  EXPECT_EQ(std::count_if(most.begin(), most.end(), [](double each) { return each > 0.0; }), 2)
      << "the two triangles of the facet";
}

TEST(Overlap, IsWhatDenseSamplesShow) {
  RandomStream stream(5, "overlap");
  for (int i = 0; i < 25; ++i) {
    const double overlap = stream.uniform(1e-5, 8e-4);
    Body block = test::checkBody("block", makeBox({0.02, 0.02, 0.02}));
    Body other = i % 2 == 0 ? test::checkBody("other", makeBox({0.01, 0.015, 0.02}))
                            : test::checkBody("other", test::prism(12, 0.006, 0.02));
    other.X_WB.position = {stream.uniform(-0.008, 0.008), stream.uniform(-0.008, 0.008),
                           0.01 - overlap + (i % 2 == 0 ? 0.01 : 0.0)};
    const PlacedBody a = placed(block);
    const PlacedBody b = placed(other);
    const double expected = sampledDepth(a, b, 40);
    const Overlap found = overlapIn(a, b, {});
    EXPECT_GE(found.deepest, expected * 0.99) << i;
    EXPECT_LE(found.deepest, overlap * 1.0001) << i;
    EXPECT_GE(*std::max_element(found.depths.begin(), found.depths.end()), expected) << i;
    EXPECT_LE(*std::max_element(found.depths.begin(), found.depths.end()), 1.02 * overlap + 2e-7) << i;
    EXPECT_NEAR(found.thickness, 0.02, 1e-9);
  }
}

/// Thousands of small triangles are near a large one: a ball is pressed into a block, or milled out of it.
TEST(Overlap, OfAFineMeshIsThatOfTheSurfaceThatItStandsFor) {
  constexpr double kRadius = 0.004;
  const TriangleMesh fine = makeSphere(kRadius, 5);
  double outermost = 0.0;
  double innermost = kRadius;
  for (const auto& [a, b, c] : fine.triangles) {
    outermost = std::max(outermost, fine.vertices[a].norm());
    innermost = std::min(innermost, (fine.vertices[a] + fine.vertices[b] + fine.vertices[c]).norm() / 3.0);
  }
  RandomStream stream(8, "fine overlap");
  for (int i = 0; i < 2; ++i) {
    const double overlap = stream.uniform(5e-5, 8e-4);
    const double along = stream.uniform(-0.003, 0.003);
    const PlacedBody ball = placed(test::checkBody("ball", fine));
    const PlacedBody block =
        placed(test::checkBody("block", makeBox({0.04, 0.04, 0.02}), {along, 0.0, -0.01 - kRadius + overlap}));
    const Overlap ofBall = overlapIn(ball, block, {});
    const Overlap ofBlock = overlapIn(block, ball, {});
    for (const Overlap* found : {&ofBall, &ofBlock}) {
      EXPECT_GE(found->deepest, 0.985 * (overlap - (kRadius - innermost))) << i;
      EXPECT_LE(found->deepest, (overlap + outermost - kRadius) * (1.0 + 1e-9)) << i;
    }
    EXPECT_GE(ofBall.deepest, 0.985 * sampledDepth(ball, block, 120)) << i;
  }
}

/// Coplanar faces of different sizes, in a corner, and around a hole: nothing is inside.
TEST(Overlap, OfFacesThatCoincideIsNothing) {
  const PlacedBody plate = placed(test::checkBody("plate", test::holedPlate(24, 0.01, 0.03, -0.005, 0.0)));
  const PlacedBody block = placed(test::checkBody("block", makeBox({0.05, 0.01, 0.01}), {0.0, 0.013, 0.005}));
  for (const auto& [one, other] : {std::pair(&plate, &block), std::pair(&block, &plate)}) {
    const Overlap found = overlapIn(*one, *other, {});
    EXPECT_LE(*std::max_element(found.depths.begin(), found.depths.end()), 1.1e-7);
  }
}

/// A frustum on a plate beside a hole, or pressed in a little. The wall of the hole is near the edge of the frustum and
/// its facets are inclined, but the frustum is not below that wall.
TEST(Overlap, OfAFrustumBesideAHoleIsThatOfTheFaceThatItStandsOn) {
  RandomStream random(4, "frusta");
  for (int round = 0; round < 40; ++round) {
    const double pressed = round % 2 == 0 ? 0.0 : random.uniform(1e-6, 5e-5);
    TriangleMesh frustum = test::prism(16 + round, 0.002, 0.004);
    Box3 box = boundingBox(frustum);
    const double narrower = random.uniform(0.1, 0.8);
    for (Vector3& v : frustum.vertices) {
      if (v.z() > box.center().z()) v.head<2>() *= narrower;
    }
    const double beside = random.uniform(1e-4, 9e-4);
    const Pose place{Vector3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)),
                     fromRollPitchYaw(random.uniform(0.0, 3.0), random.uniform(0.0, 3.0), random.uniform(0.0, 3.0))};
    Body plate = test::checkBody("plate", test::holedPlate(24, 0.01, 0.03, -0.005, 0.0));
    Body insert = test::checkBody("insert", frustum);
    plate.X_WB = place;
    insert.X_WB = place * Pose::translation({0.012 + beside, 0.0, -box.min().z() - pressed});
    const PlacedBody a = placed(plate);
    const PlacedBody b = placed(insert);
    for (const Overlap& found : {overlapIn(a, b, {}), overlapIn(b, a, {})}) {
      EXPECT_LE(*std::max_element(found.depths.begin(), found.depths.end()), 1.02 * pressed + 1.1e-7) << beside;
    }
  }
}

/// A wire that is 13 mm deep in a block: the block's surface is nowhere deep in the thin wire, but the pair is a clash
/// for the block's face.
TEST(Evidence, ADeepOverlapIsNotAllowedByTheOtherBodysThinness) {
  const Body block = test::checkBody("block", makeBox({0.05, 0.05, 0.05}));
  const Body wire = test::checkBody("wire", makeBox({0.0004, 0.0004, 0.03}), {0.0, 0.0, 0.025 + 0.015 - 0.013});
  const PairBounds bounds = boundsOf(placed(block), placed(wire), {true, 0.0, {}}, nullptr);
  EXPECT_EQ(bounds.one.most, 0.0);
  EXPECT_TRUE(bounds.one.isClash);
  EXPECT_LE(bounds.other.most, 0.0003);
  EXPECT_FALSE(bounds.refused().empty());
  const PairWord accepted{"block", "wire", "", {}, true};
  EXPECT_GT(boundsOf(placed(block), placed(wire), {true, 0.0, {accepted}}, &accepted).one.most, 0.001);
}

/// A knob with twelve sides under a lip that overlaps it by 0.8 mm. All faces are planes, so there are no deflections.
TEST(Evidence, APrismIsNoCylinder) {
  const Body knob = test::checkBody("knob", test::prism(12, 0.02, 0.02));
  const Body lip = test::checkBody("lip", test::holedPlate(12, 0.0192, 0.04, 0.015, 0.03));
  const PairBounds bounds = boundsOf(placed(knob), placed(lip), {true, 0.0, {}}, nullptr);
  EXPECT_FALSE(bounds.one.isClash);
  EXPECT_NEAR(bounds.one.largest.overlap, 0.0008 * std::cos(std::numbers::pi / 12), 2e-5);
  EXPECT_EQ(bounds.one.largest.deflection, 0.0);
  EXPECT_LT(bounds.one.most, 0.00082);
  EXPECT_GT(bounds.one.most, 0.00076);
}

TEST(Evidence, PairsThatAreApartHaveNone) {
  const Body block = test::checkBody("block", makeBox({0.02, 0.02, 0.02}));
  const PlacedBody a = placed(block);
  const PlacedBody near = placed(test::checkBody("near", makeBox({0.02, 0.02, 0.02}), {0.0, 0.0, 0.020002}));
  const PlacedBody apart = placed(test::checkBody("apart", makeBox({0.02, 0.02, 0.02}), {0.0, 0.0, 0.020004}));
  const FitWords on{true, 0.0, {}};
  const PairBounds touching = boundsOf(a, near, on, nullptr);
  EXPECT_TRUE(touching.one.inFit);
  EXPECT_DOUBLE_EQ(touching.one.most, assembledMargin(a.radius)) << "no more than the gap that remains";
  EXPECT_EQ(
      std::count_if(touching.one.atMost.begin(), touching.one.atMost.end(), [](double each) { return each > 0.0; }), 2)
      << "the face that touches, no other";
  EXPECT_FALSE(boundsOf(a, apart, on, nullptr).one.inFit);
  EXPECT_EQ(boundsOf(a, apart, on, nullptr).one.most, 0.0);
}

TEST(Evidence, AClashIsNothingUnlessAPersonAcceptsIt) {
  const PlacedBody a = placed(test::checkBody("a", makeBox({0.02, 0.02, 0.02})));
  const PlacedBody b = placed(test::checkBody("b", makeBox({0.02, 0.02, 0.02}), {0.0, 0.0, 0.0188}));
  const FitWords on{true, 0.0, {}};
  const PairBounds clash = boundsOf(a, b, on, nullptr);
  EXPECT_EQ(clash.one.most, 0.0);
  EXPECT_NE(toString(clash.refused()).find("1.2 mm"), std::string::npos) << toString(clash.refused());
  PairWord word{"a", "b"};
  word.accepted = true;
  EXPECT_NEAR(boundsOf(a, b, on, &word).one.most, 0.0012, 3e-5);
  EXPECT_NEAR(boundsOf(a, b, {true, 0.0013, {}}, nullptr).one.most, 0.0012, 3e-5);
  PairWord hand{"a", "b"};
  hand.allowance = 0.003;
  EXPECT_EQ(boundsOf(a, b, on, &hand).one.most, 0.003);
}

TEST(Evidence, DeflectionIsWhatFilesStateAndNoGuess) {
  Body shaft = test::checkBody("shaft", test::prism(36, 0.01, 0.02));
  const Body hole = test::checkBody("hole", test::holedPlate(36, 0.01, 0.03, 0.0, 0.02));
  const FitWords on{true, 0.0, {}};
  EXPECT_EQ(boundsOf(placed(shaft), placed(hole), on, nullptr).one.largest.deflection, 0.0);
  shaft.deflection = 2e-5;
  EXPECT_EQ(boundsOf(placed(shaft), placed(hole), on, nullptr).one.largest.deflection, 2e-5);
  TriangleMesh faced = *shaft.mesh;
  faced.faces = {SurfaceFace{.deflection = 3e-6}, SurfaceFace{.kind = SurfaceFace::Kind::Plane}};
  for (std::size_t t = 0; t < faced.triangles.size(); ++t) faced.faceOf.push_back(t % 4 < 2 ? 0 : 1);
  shaft.mesh = std::make_shared<const TriangleMesh>(faced);
  EXPECT_EQ(boundsOf(placed(shaft), placed(hole), on, nullptr).one.largest.deflection, 3e-6) << "per face only";
  PairWord said{"shaft", "hole"};
  said.kind = "cylindrical";
  const double sagitta = 0.01 * (1.0 - std::cos(std::numbers::pi / 36));
  EXPECT_NEAR(boundsOf(placed(shaft), placed(hole), on, &said).one.largest.byPerson, sagitta, 1e-7)
      << "of the hole, whose file states no faces";
}

TEST(FitWords, AdvisedClashesAreAcceptedByTheDepthThatIsAdvisedForThem) {
  FitWords words;
  words.acceptedClash = kAdvisedClashes;
  EXPECT_TRUE(words.accepts(nullptr, 0.002));
  EXPECT_TRUE(words.accepts(nullptr, 0.002, 0.002));
  EXPECT_FALSE(words.accepts(nullptr, 0.003, 0.002)) << "the deeper side of a pair of 2 mm";
  words.acceptedClash = 0.003;
  EXPECT_TRUE(words.accepts(nullptr, 0.003, 0.002)) << "a person's own limit";
}

}  // namespace
}  // namespace glissade::check
