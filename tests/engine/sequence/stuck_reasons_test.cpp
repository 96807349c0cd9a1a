#include "engine/sequence/stuck_reasons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/sequence/sequence_run.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A block that stays, one that overlaps it by `depth`, and one beside it.
AssembledProduct overlapping(double depth) {
  const auto block = [](const char* name, const Vector3& at) {
    return boxBody(name, {0.1, 0.1, 0.1}, Pose::translation(at));
  };
  return test::productOf(
      {block("base", Vector3::Zero()), block("sunk", {0.0, 0.0, 0.1 - depth}), block("beside", {0.3, 0.0, 0.0})}, true);
}

AssemblyPlan plainPlanOf(const AssembledProduct& product) {
  test::QuietHost host;
  const SequenceRequest request{{true, false, false}};
  auto plan = planSequence(product, test::fitsOf(product), request, host);
  EXPECT_TRUE(plan) << toString(plan.error());
  return plan ? std::move(*plan) : AssemblyPlan{};
}

TEST(StuckReasons, AClashIsNamedWithTheOtherBodyAndItsDepth) {
  const AssemblyPlan plan = plainPlanOf(overlapping(0.005));
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_EQ(plan.stuck[0].body, "sunk");
  EXPECT_THAT(toString(plan.stuck[0].reason), HasSubstr("it and 'base' clash where they are assembled (5 mm)"));
}

/// The block lies on the base and would have an allowance.
TEST(StuckReasons, APairThatTheTimeLimitLeftIsNamed) {
  const AssembledProduct product = overlapping(0.0);
  ThreadTeam team(0);
  StopSource over;
  over.requestStop();
  auto table = FitTable::find(product, team, {}, {}, FitDeadlines{over.token(), over.token()});
  ASSERT_TRUE(table.ok());
  test::QuietHost host;
  const ProductFits fits(product, std::make_shared<const FitTable>(std::move(*table)));
  const auto plan = planSequence(product, fits, SequenceRequest{{true, false, false}}, host);
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(plan->removed(), 1U) << "what touches nothing leaves";
  ASSERT_EQ(plan->stuck.size(), 1U);
  EXPECT_THAT(toString(plan->stuck[0].reason), HasSubstr("it and 'base' were not compared within the time limit"));
}

/// A rod through a plate of which nothing is left beside the rod: the rod would fall apart, and the plate, too.
TEST(StuckReasons, AClashThatCannotBeCutIsNotAdvisedToBeAccepted) {
  const AssembledProduct product = test::productOf(
      {boxBody("base", {0.1, 0.01, 0.01}, Pose::identity()), boxBody("across", {0.01, 0.1, 0.01}, Pose::identity()),
       boxBody("beside", {0.1, 0.1, 0.1}, Pose::translation({0.3, 0.0, 0.0}))},
      true);
  const AssemblyPlan plan = plainPlanOf(product);
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_THAT(toString(plan.stuck[0].reason), HasSubstr("neither can be cut and stay in one piece: mend the parts"));
  const ProductFits fits = test::fitsOf(product);
  for (const Diagnostic& warning : fits.warnings()) EXPECT_THAT(toString(warning), Not(HasSubstr("Accept it")));
}

TEST(StuckReasons, AnAcceptedClashNeedsTheNameOfTheBodyThatIsCut) {
  const auto bar = [](const char* name, const Vector3& size, double height) {
    return boxBody(name, size, Pose::translation({0.0, 0.0, height}));
  };
  AssembledProduct product =
      test::productOf({bar("along", {0.1, 0.01, 0.01}, 0.0), bar("across", {0.01, 0.1, 0.01}, 0.004),
                       boxBody("beside", {0.1, 0.1, 0.1}, Pose::translation({0.3, 0.0, 0.0}))},
                      true);
  product.fits.acceptedClash = 0.006;
  const AssemblyPlan plan = plainPlanOf(product);
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_THAT(toString(plan.stuck[0].reason), HasSubstr("(--cut \"across\" or --cut \"along\")"));
}

/// A bar in a channel encloses the end of a nib on the channel's wall: the bar gets the notch, which holds it.
TEST(StuckReasons, AnAcceptedClashNamesTheOtherBodyThatCouldBeCut) {
  const auto channel = test::bodyOf("channel", {{{0.3, 0.02, 0.05}, {0.0, -0.0155, 0.0}},
                                                {{0.006, 0.01, 0.005}, {0.0, -0.0075, 0.0}},
                                                {{0.3, 0.02, 0.05}, {0.0, 0.0155, 0.0}},
                                                {{0.3, 0.05, 0.02}, {0.0, 0.0, -0.0155}},
                                                {{0.3, 0.05, 0.02}, {0.0, 0.0, 0.0155}}});
  AssembledProduct product = test::productOf({channel, boxBody("bar", {0.2, 0.01, 0.01}, Pose::identity()),
                                              boxBody("beside", {0.1, 0.1, 0.1}, Pose::translation({0.5, 0.0, 0.0}))},
                                             true);
  product.fits.acceptedClash = 0.004;
  const AssemblyPlan plan = plainPlanOf(product);
  ASSERT_EQ(plan.stuck.size(), 1U);
  const std::string reason = toString(plan.stuck[0].reason);
  EXPECT_THAT(reason, HasSubstr("'bar' is cut, because its clash with 'channel' ("));
  EXPECT_THAT(reason, HasSubstr("if 'channel' is the one to cut, name it (--cut \"channel\")"));
  product.fits.cut = {"channel"};
  EXPECT_TRUE(plainPlanOf(product).stuck.empty());
}

/// A thin slab is sunk into the floor of a channel that is closed at its ends.
TEST(StuckReasons, AnAcceptedClashThatIsThinnedNamesBothBodiesThatCouldBeCut) {
  const auto channel = test::bodyOf("channel", {{{0.3, 0.1, 0.02}, {0.0, 0.0, -0.0155}},
                                                {{0.3, 0.1, 0.02}, {0.0, 0.0, 0.0155}},
                                                {{0.3, 0.02, 0.05}, {0.0, -0.0605, 0.0}},
                                                {{0.3, 0.02, 0.05}, {0.0, 0.0605, 0.0}},
                                                {{0.02, 0.1, 0.011}, {0.11, 0.0, 0.0}},
                                                {{0.02, 0.1, 0.011}, {-0.11, 0.0, 0.0}}});
  const RigidBody slab = boxBody("slab", {0.19, 0.09, 0.006}, Pose::translation({0.0, 0.0, -0.0037}));
  AssembledProduct product =
      test::productOf({channel, slab, boxBody("beside", {0.1, 0.1, 0.1}, Pose::translation({0.5, 0.0, 0.0}))}, true);
  product.fits.acceptedClash = 0.004;
  const AssemblyPlan plan = plainPlanOf(product);
  ASSERT_EQ(plan.stuck.size(), 1U);
  EXPECT_THAT(toString(plan.stuck[0].reason), HasSubstr("(--cut \"slab\" or --cut \"channel\")"));
}

TEST(StuckReasons, NothingLeavesWhereEveryBodyStays) {
  const AssembledProduct product = overlapping(0.0);
  test::QuietHost host;
  const auto plan = planSequence(product, test::fitsOf(product), SequenceRequest{{true, true, true}}, host);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->end, PlanEnd::Stuck) << "the judge calls no such plan complete";
}

/// A part of a CAD file with a second solid that is apart.
TEST(StuckReasons, APartOfSolidsThatDoNotTouchMayBeOpened) {
  for (const bool isOfCadFile : {true, false}) {
    AssembledProduct product = overlapping(0.005);
    TriangleMesh two = *product.bodies[1].mesh;
    append(two, transformed(two, Pose::translation({0.0, 0.0, 0.2})));
    if (isOfCadFile) {
      two.faces = {SurfaceFace{}};
      two.faceOf.assign(two.triangles.size(), 0);
    }
    product.bodies[1].mesh = std::make_shared<const TriangleMesh>(two);
    const AssemblyPlan plan = plainPlanOf(product);
    ASSERT_EQ(plan.stuck.size(), 1U);
    const auto isReported = HasSubstr(
        "; 'sunk' is one part of 2 solids that do not touch each other: split it "
        "(--open \"sunk\", ");
    const bool isNamed = testing::Value(toString(plan.stuck[0].reason), isReported);
    EXPECT_EQ(isNamed, isOfCadFile) << toString(plan.stuck[0].reason);  // a mesh cannot be opened
  }
}

/// Two frames between the flanges of a spool block each other, and the spool alone holds each of them.
TEST(StuckReasons, ABodyThatHoldsAloneIsNamedBeforeTheOnesBesideIt) {
  const auto frame = [](const char* name, double at) {
    return test::bodyOf(name, {{{0.02, 0.1, 0.03}, {0.04, 0.0, at}},
                               {{0.02, 0.1, 0.03}, {-0.04, 0.0, at}},
                               {{0.1, 0.02, 0.03}, {0.0, 0.04, at}},
                               {{0.1, 0.02, 0.03}, {0.0, -0.04, at}}});
  };
  const AssembledProduct product = test::productOf({test::bodyOf("spool", {{{0.09, 0.09, 0.02}, {0.0, 0.0, 0.05}},
                                                                           {{0.04, 0.04, 0.1}, {0.0, 0.0, 0.0}},
                                                                           {{0.09, 0.09, 0.02}, {0.0, 0.0, -0.05}}}),
                                                    frame("upper", 0.018), frame("lower", -0.018)},
                                                   true);
  const AssemblyPlan plan = plainPlanOf(product);
  ASSERT_EQ(plan.stuck.size(), 2U);
  for (const StuckBody& stuck : plan.stuck) {
    EXPECT_THAT(toString(stuck.reason), HasSubstr("'spool' alone blocks every straight motion of it"));
  }
}

/// A block in a box, below a lid that clashes with the box.
TEST(StuckReasons, ABodyWaitsForOneThatIsStuckItself) {
  const AssembledProduct product =
      test::productOf({test::bodyOf("box", {{{0.2, 0.2, 0.05}, {0.0, 0.0, -0.075}},
                                            {{0.05, 0.2, 0.2}, {-0.075, 0.0, 0.0}},
                                            {{0.05, 0.2, 0.2}, {0.075, 0.0, 0.0}},
                                            {{0.2, 0.05, 0.2}, {0.0, -0.075, 0.0}},
                                            {{0.2, 0.05, 0.2}, {0.0, 0.075, 0.0}}}),
                       boxBody("lid", {0.2, 0.2, 0.05}, Pose::translation({0.0, 0.0, 0.12})),
                       boxBody("block", {0.095, 0.095, 0.14}, Pose::translation({0.0, 0.0, 0.022}))},
                      true);
  const AssemblyPlan plan = plainPlanOf(product);
  ASSERT_EQ(plan.stuck.size(), 2U);
  EXPECT_THAT(toString(plan.stuck[0].reason), HasSubstr("it and 'box' clash"));
  EXPECT_THAT(toString(plan.stuck[1].reason), HasSubstr("'lid' is in its way, and is stuck for a reason of its own"));
}

TEST(StuckReasons, BodiesThatTouchDoNotClash) { EXPECT_TRUE(plainPlanOf(overlapping(0.0)).stuck.empty()); }

}  // namespace
}  // namespace glissade
