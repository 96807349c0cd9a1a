#include "engine/sequence/stated_units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/fits/ring.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A ring of 20 mm, a shaft in it with this excess of its radius, and a box far from both.
AssembledProduct ringAndShaft(double excess) {
  RigidBody ring = boxBody("ring", {0.01, 0.01, 0.01}, Pose::identity());
  ring.mesh = std::make_shared<const TriangleMesh>(test::makeRing(0.005, 0.01, 0.01, 48));
  RigidBody shaft = boxBody("shaft", {0.01, 0.01, 0.01}, Pose::identity());
  shaft.mesh = std::make_shared<const TriangleMesh>(test::makeRing(0.0, 0.005 + excess, 0.03, 48));
  return test::productOf({ring, shaft, boxBody("box", {0.01, 0.01, 0.01}, Pose::translation({0.1, 0.0, 0.0}))});
}

AssemblyPlan planWithUnit() {
  AssemblyPlan plan;
  plan.bodies = {"ring", "shaft", "box"};
  plan.staying = {"box"};
  AssemblyStep step{{StepMotion()}};
  step.only().body = "ring";
  step.only().with = {"shaft"};
  step.only().unit = true;
  plan.steps.push_back(step);
  return plan;
}

TEST(StatedUnits, AUnitThatNothingElseShowsIsStated) {
  const AssemblyPlan plan = planWithUnit();
  EXPECT_THAT(statedUnitsOf(plan, ringAndShaft(2e-5), {}, {}).leaving, IsEmpty()) << "pressed in";
  const AssembledProduct loose = ringAndShaft(-1e-4);
  EXPECT_THAT(statedUnitsOf(plan, loose, {}, {}).leaving, ElementsAre(ElementsAre("ring", "shaft")));
  const JointEdit word{{JointKind::Unit, "ring", {"shaft"}}, JointEdit::Word::Confirmed};
  EXPECT_THAT(statedUnitsOf(plan, loose, {word}, {}).leaving, IsEmpty()) << "a person says so";
}

TEST(StatedUnits, ABaseOfSeveralBodiesIsStated) {
  AssemblyPlan plan = planWithUnit();
  plan.steps.clear();
  plan.staying = {"ring", "shaft"};
  const AssembledProduct loose = ringAndShaft(-1e-4);
  EXPECT_THAT(statedUnitsOf(plan, loose, {}, {}).base, ElementsAre("ring", "shaft"));
  EXPECT_THAT(statedUnitsOf(plan, loose, {}, {"shaft", "ring"}).base, IsEmpty()) << "a person says so";
  EXPECT_THAT(statedUnitsOf(plan, ringAndShaft(2e-5), {}, {}).base, IsEmpty()) << "pressed in";
}

}  // namespace
}  // namespace glissade
