#include "engine/sequence/standing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/sequence/contact_points.h"
#include "engine/sequence/solid_mass.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A table, two posts on it, a beam on both, and a weight on one end of the beam. Their surfaces touch exactly.
AssembledProduct beamOnPosts() {
  return test::productOf({boxBody("table", {4.0, 4.0, 0.5}, Pose::translation({0.0, 0.0, -0.25})),
                          boxBody("left", {0.25, 0.25, 1.0}, Pose::translation({-1.0, 0.0, 0.5})),
                          boxBody("right", {0.25, 0.25, 1.0}, Pose::translation({1.0, 0.0, 0.5})),
                          boxBody("beam", {2.5, 0.25, 0.25}, Pose::translation({0.0, 0.0, 1.125})),
                          boxBody("weight", {0.25, 0.25, 0.25}, Pose::translation({-1.0, 0.0, 1.375}))},
                         true);
}

struct BeamFixture {
  explicit BeamFixture(const Vector3& gravity = -Vector3::UnitZ())
      : product(beamOnPosts()),
        fits(test::fitsOf(product)),
        standing(product,
                 {fits.contacts(),
                  std::vector<FastenerKind>(5, FastenerKind::None),
                  {true, false, false, false, false},
                  densitiesOf({}, product),
                  gravity},
                 alone) {}
  ThreadTeam alone{0};
  AssembledProduct product;
  ProductFits fits;
  Standing standing;
};

TEST(Standing, APostMayNotLeaveBeforeTheBeam) {
  BeamFixture beam;
  const BodySet all(5, true);
  EXPECT_EQ(beam.standing.newlyFalling(all, {2}), BodyGroup{3}) << "the weight still lies on the beam";
  EXPECT_TRUE(beam.standing.newlyFalling(all, {4}).empty());
  EXPECT_TRUE(beam.standing.newlyFalling({true, true, true, true, false}, {3}).empty());
  EXPECT_TRUE(beam.standing.newlyFalling({true, true, true, false, false}, {2}).empty());
}

TEST(Standing, StepsAfterWhichBodiesFallAreAvoidedOrMarked) {
  BeamFixture beam;
  MotionTrial trial(beam.product, beam.fits, 1, 0);
  test::QuietHost host;
  SequenceQuestion question{beam.product, {true, false, false, false, false}, 1, trial, nullptr};
  const auto greedy = makeSequenceStrategyRegistry().find("greedy")->make();
  question.standing = &beam.standing;
  const AssemblyPlan plan = greedy->plan(question, host);
  ASSERT_EQ(plan.steps.size(), 4U);
  EXPECT_EQ(plan.steps[0].only().body, "weight");
  EXPECT_EQ(plan.steps[1].only().body, "beam");
  for (const AssemblyStep& step : plan.steps) EXPECT_TRUE(step.only().falling.empty()) << step.only().body;
  // A person demands that a post leaves first: the beam has to be held.
  question.rules.before = {{2, 3, true}, {2, 4, true}, {2, 1, true}};
  const AssemblyPlan forced = greedy->plan(question, host);
  ASSERT_EQ(forced.steps.size(), 4U);
  EXPECT_EQ(forced.steps[0].only().body, "right");
  EXPECT_EQ(forced.steps[0].only().falling, std::vector<BodyId>{"beam"});
}

/// The search is interrupted after each wave: waiting motions are not searched again, and the plan is the same.
TEST(Standing, WhatWaitsIsKeptInAPlanThatIsCut) {
  BeamFixture beam;
  const auto planned = [&](const AssemblyPlan* resumed, std::size_t waves) {
    MotionTrial trial(beam.product, beam.fits, 1, 0);
    test::QuietHost host(1, waves);
    SequenceQuestion question{beam.product, {true, false, false, false, false}, 1, trial, resumed};
    question.standing = &beam.standing;
    return makeSequenceStrategyRegistry().find("greedy")->make()->plan(question, host);
  };
  const AssemblyPlan whole = planned(nullptr, 1000);
  EXPECT_TRUE(whole.waiting.empty());
  bool waited = false;
  for (std::size_t waves = 1; waves < whole.steps.back().wave; ++waves) {
    const AssemblyPlan cut = planned(nullptr, waves);
    waited = waited || !cut.waiting.empty();
    const AssemblyPlan resumed = planned(&cut, 1000);
    ASSERT_EQ(test::orderOf(resumed), test::orderOf(whole));
    for (std::size_t i = 0; i < whole.steps.size(); ++i) {
      EXPECT_EQ(resumed.steps[i].only().proof.afterSteps, whole.steps[i].only().proof.afterSteps);
      EXPECT_EQ(configurationsOf(resumed.steps[i].only().path), configurationsOf(whole.steps[i].only().path));
    }
  }
  EXPECT_TRUE(waited) << "the posts wait for the beam";
}

/// A host that interrupts at the n-th trial.
class AskedOften final : public SequenceHost {
 public:
  explicit AskedOften(std::size_t most) : left_(most) {}
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>&, int) override {
    if (left_-- == 0) source_.requestStop();
  }
  void stepFound(const AssemblyPlan&) override {}

 private:
  ThreadTeam team_{0};
  std::size_t left_;
  StopSource source_;
  StopToken stop_ = source_.token();
};

TEST(Standing, APlanThatIsInterruptedWhileBodiesAreAskedIsTheBeginningOfTheWhole) {
  BeamFixture beam;
  const auto planned = [&](std::size_t asked) {
    MotionTrial trial(beam.product, beam.fits, 1, 0);
    AskedOften host(asked);
    SequenceQuestion question{beam.product, {true, false, false, false, false}, 1, trial};
    question.standing = &beam.standing;
    return makeSequenceStrategyRegistry().find("greedy")->make()->plan(question, host);
  };
  const std::vector<BodyId> whole = test::orderOf(planned(1000));
  for (std::size_t asked = 0; asked < 8; ++asked) {
    const std::vector<BodyId> begun = test::orderOf(planned(asked));
    ASSERT_LE(begun.size(), whole.size());
    EXPECT_TRUE(std::equal(begun.begin(), begun.end(), whole.begin())) << asked;
  }
}

TEST(Standing, AMassThatIsKnownTakesThePlaceOfVolumeAndDensity) {
  const AssembledProduct product = beamOnPosts();
  SequenceDemands demands;
  demands.masses = {{"weight", 12.5}};
  EXPECT_EQ(massesOf(demands, product), (std::vector<double>{0.0, 0.0, 0.0, 0.0, 12.5}));
  const ProductFits fits = test::fitsOf(product);
  ThreadTeam alone(0);
  const std::vector<FastenerKind> fasteners(5, FastenerKind::None);
  const Standing standing(product,
                          {fits.contacts(), fasteners, BodySet(5, false), densitiesOf({}, product), -Vector3::UnitZ(),
                           massesOf(demands, product)},
                          alone);
  EXPECT_EQ(standing.massOf(4), 12.5);
  EXPECT_NEAR(standing.massOf(3), 2.5 * 0.25 * 0.25 * kUsualDensity, 1e-6);
}

TEST(SolidMass, IsThatOfBoxesAndOfBodiesOfSeveral) {
  const TriangleMesh box = transformed(makeBox({1.0, 2.0, 3.0}), Pose::translation({5.0, -1.0, 2.0}));
  EXPECT_NEAR(solidMass(box).volume, 6.0, 1e-12);
  EXPECT_LT((solidMass(box).centre - Vector3(5.0, -1.0, 2.0)).norm(), 1e-12);
  TriangleMesh two = makeBox({1.0, 1.0, 1.0});
  append(two, transformed(makeBox({1.0, 1.0, 1.0}), Pose::translation({4.0, 0.0, 0.0})));
  EXPECT_NEAR(solidMass(two).volume, 2.0, 1e-12);
  EXPECT_LT((solidMass(two).centre - Vector3(2.0, 0.0, 0.0)).norm(), 1e-12);
  TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(solidMass(flat).volume, 0.0);
}

TEST(ContactPoints, AreTheCornersOfTheCommonFace) {
  const TriangleTree below(makeBox({4.0, 4.0, 1.0}));
  const TriangleTree above(transformed(makeBox({1.0, 2.0, 1.0}), Pose::translation({0.5, 0.0, 1.0})));
  const auto points = contactPoints(below, above, 1e-4);
  ASSERT_GE(points.size(), 4U);
  Box3 box;
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.point.z(), 0.5, 1e-12);
    EXPECT_GT(point.normal.z(), 0.99);
    box.extend(point.point);
  }
  EXPECT_NEAR(box.min().x(), 0.0, 0.2);
  EXPECT_NEAR(box.max().x(), 1.0, 0.2);
  EXPECT_NEAR(box.sizes().y(), 2.0, 0.4);
  EXPECT_TRUE(contactPoints(below, TriangleTree(transformed(makeBox({1, 1, 1}), Pose::translation({0, 0, 1.1}))), 1e-4)
                  .empty());
}

}  // namespace
}  // namespace glissade
