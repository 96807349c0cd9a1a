#include "engine/sequence/order_rules.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssembledProduct named(const std::vector<std::string>& ids) {
  std::vector<RigidBody> bodies;
  for (const std::string& id : ids) bodies.push_back(boxBody(id, Vector3::Constant(1.0), Pose::identity()));
  return test::productOf(bodies);
}

using Names = std::vector<std::string>;

SequenceDemands demanded(const std::vector<Names>& together,
                         const std::vector<std::pair<std::string, std::string>>& before) {
  SequenceDemands demands;
  demands.together = together;
  demands.before = before;
  return demands;
}

TEST(OrderRules, NamesStandForAllBodiesThatEndInThem) {
  const AssembledProduct product = named({"a/bolt", "b/bolt", "nut", "bolts"});
  EXPECT_EQ(bodiesNamed(product, "bolt"), (BodyGroup{0, 1}));
  EXPECT_EQ(bodiesNamed(product, "nut"), BodyGroup{2});
  EXPECT_TRUE(bodiesNamed(product, "olt").empty());
  const auto rules =
      resolved(demanded({Names{"nut", "a/bolt"}}, {{"nut", "bolt"}}), named({"a/bolt", "b/bolt", "nut"}));
  ASSERT_FALSE(rules.ok()) << "the nut and a bolt leave as one, and one before the other";
  const auto sound = resolved(demanded({Names{"nut", "bolts"}}, {{"nut", "bolt"}}), product);
  ASSERT_TRUE(sound.ok());
  EXPECT_EQ(sound->together, (std::vector<BodyGroup>{{2, 3}}));
  ASSERT_EQ(sound->before.size(), 2U);
  EXPECT_EQ(sound->before[1].first, 2U);
  EXPECT_EQ(sound->before[1].then, 1U);
}

TEST(OrderRules, RefuseWhatCannotBe) {
  const AssembledProduct product = named({"a", "b", "c", "d"});
  const auto reasonOf = [&](const SequenceDemands& demands) {
    const auto rules = resolved(demands, product);
    return rules.ok() ? std::string() : toString(rules.error().reason);
  };
  EXPECT_NE(reasonOf(demanded({Names{"a", "x"}}, {})).find("'x'"), std::string::npos);
  EXPECT_NE(reasonOf(demanded({Names{"a", "b"}, Names{"b", "c"}}, {})).find("in two groups"), std::string::npos);
  EXPECT_NE(reasonOf(demanded({}, {{"a", "b"}, {"b", "c"}, {"c", "a"}})).find("cycle"), std::string::npos);
  EXPECT_NE(reasonOf(demanded({Names{"a", "c"}}, {{"a", "b"}, {"b", "c"}})).find("cycle"), std::string::npos);
  EXPECT_EQ(reasonOf(demanded({Names{"a", "c"}}, {{"a", "b"}, {"d", "b"}})), "");
}

TEST(OrderRules, WhoStaysIsNamed) {
  const AssembledProduct product = named({"a", "stand/b", "c"});
  const auto staying = stayingBodies(product, {"b", "c"});
  ASSERT_TRUE(staying);
  EXPECT_EQ(*staying, (BodySet{false, true, true}));
  EXPECT_TRUE(bodiesIn(*stayingBodies(product, {})).empty());
  EXPECT_EQ(stayingBodies(product, {"x"}).error().kind, ErrorKind::Usage);
}

}  // namespace
}  // namespace glissade
