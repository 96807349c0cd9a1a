// The checker of orders refuses the plans that an assembler would refuse.
#include "tests/oracle/order_oracle.h"

#include <gtest/gtest.h>

namespace glissade::oracle {
namespace {

using Texts = std::vector<std::string>;

/// Steps of single bodies that are removed in this order from "base".
StatedLine removedInOrder(const Texts& order) {
  StatedLine plan{0, {"base"}, {"base"}, {}, {}, {}};
  for (const std::string& id : order) {
    plan.bodies.push_back(id);
    plan.steps.push_back({{id}, {}});
  }
  return plan;
}

/// The motions at these indices are of the step of the motion before them.
StatedLine joinedAt(const std::vector<std::size_t>& motions, StatedLine plan) {
  for (const std::size_t motion : motions) plan.steps[motion].continues = true;
  return plan;
}

StatedJoint nutOn(const std::string& nut, const std::string& bolt, const Texts& clamped) {
  return {"nut", nut, {bolt}, clamped};
}

TEST(OrderOracle, RefusesABodyThatIsPutIntoTheAir) {
  const StatedContacts contacts{{"base", "post"}, {"post", "cap"}};
  EXPECT_EQ(orderViolationsOf(removedInOrder({"cap", "post"}), {}, contacts), Texts());
  EXPECT_EQ(orderViolationsOf(removedInOrder({"post", "cap"}), {}, contacts), Texts{"step 2 puts 'cap' into the air"});
  EXPECT_EQ(orderViolationsOf(removedInOrder({"post", "cap", "loose"}), {}, {{"base", "post"}, {"base", "cap"}}),
            Texts())
      << "a body that touches nothing in the product is no violation";
  StatedLine group = removedInOrder({});
  group.bodies = {"base", "cap", "post"};
  group.steps = {{{"cap", "post"}, {}}};
  EXPECT_EQ(orderViolationsOf(group, {}, contacts), Texts()) << "the group touches the base";
}

TEST(OrderOracle, RefusesAStackWithOtherWorkInIt) {
  const std::vector<StatedJoint> joints{nutOn("nut", "bolt", {"plate"}), nutOn("other nut", "other bolt", {"plate"})};
  const StatedContacts contacts{{"base", "plate"}, {"base", "bolt"}, {"base", "other bolt"}};
  const Texts stackByStack{"nut", "bolt", "other nut", "other bolt", "plate"};
  EXPECT_EQ(orderViolationsOf(joinedAt({1, 3}, removedInOrder(stackByStack)), joints, contacts), Texts());
  EXPECT_EQ(orderViolationsOf(joinedAt({1}, removedInOrder(stackByStack)), joints, contacts),
            Texts{"step 3 is not one with the step of 'other nut'"});
  const Texts plateOnBolt{"nut", "plate", "bolt", "other nut", "other bolt"};
  EXPECT_EQ(orderViolationsOf(joinedAt({4}, removedInOrder(plateOnBolt)), joints, contacts), Texts())
      << "the plate is on the bolt";
  const Texts split =
      orderViolationsOf(removedInOrder({"nut", "other nut", "bolt", "other bolt", "plate"}), joints, contacts);
  ASSERT_EQ(split.size(), 2U);
  EXPECT_EQ(split[0], "step 2 puts 'other nut' between 'nut' and 'bolt'");
}

TEST(OrderOracle, JudgesTheLinesOfGroups) {
  StatedLine plan = removedInOrder({});
  plan.bodies = {"base", "post", "cap"};
  plan.steps = {{{"post", "cap"}, {}}};
  StatedLine line{1, {"post", "cap", "lid"}, {"lid"}, {{{"post"}, {}}, {{"cap"}, {}}}, {}, {}};
  plan.lines = {line};
  EXPECT_EQ(orderViolationsOf(plan, {}, {{"post", "cap"}, {"lid", "post"}, {"base", "post"}}),
            Texts{"in the line of step 1: step 2 puts 'cap' into the air"});
}

}  // namespace
}  // namespace glissade::oracle
