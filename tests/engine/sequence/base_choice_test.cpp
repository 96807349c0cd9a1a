#include "engine/sequence/base_choice.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A plate, a long rod across it, three posts on the plate, and a cover that is larger than the plate.
AssembledProduct plateWithPosts() {
  std::vector<RigidBody> bodies{boxBody("rod", {2.0, 0.02, 0.02}, Pose::translation({0.0, 0.0, 0.06})),
                                boxBody("plate", {0.5, 0.5, 0.05}, Pose::translation({0.0, 0.0, 0.025})),
                                boxBody("cover", {0.6, 0.6, 0.3}, Pose::translation({0.0, 0.0, 0.3}))};
  for (int i = 0; i < 3; ++i) {
    bodies.push_back(boxBody("post" + std::to_string(i), {0.02, 0.02, 0.1}, Pose::translation({0.1 * i, 0.2, 0.1})));
  }
  return test::productOf(std::move(bodies));
}

std::vector<Contact> contactsOf(std::size_t body, const std::vector<std::size_t>& others) {
  std::vector<Contact> contacts;
  for (const std::size_t other : others) {
    contacts.emplace_back();
    contacts.back().a = std::min(body, other);
    contacts.back().b = std::max(body, other);
  }
  return contacts;
}

TEST(BaseChoice, APlateThatMuchIsFixedToIsTheBaseAndNotALongRodOrALargeCover) {
  const AssembledProduct product = plateWithPosts();
  const LiaisonGraph graph(6, contactsOf(1, {0, 3, 4, 5}), {});
  const Vector3 down = -Vector3::UnitZ();
  EXPECT_EQ(baseOf(product, BodySet(6, true), graph, {}, {}, down), 1U);
  EXPECT_EQ(baseOf(product, {true, false, true, true, false, false}, graph, {}, {}, down), 2U)
      << "where nothing touches, the largest one";
  Joint insert;
  insert.kind = JointKind::Insert;
  insert.body = 1;
  insert.others = {2};
  EXPECT_NE(baseOf(product, BodySet(6, true), graph, {insert}, {}, down), 1U) << "a guest is no base";
  std::vector<FastenerKind> kinds(6, FastenerKind::None);
  kinds[1] = FastenerKind::Washer;
  EXPECT_NE(baseOf(product, BodySet(6, true), graph, {}, kinds, down), 1U) << "nor is a fastener";
}

TEST(BaseChoice, OfTwoAlikeTheOneThatStandsOnTheGroundIsTheBase) {
  const AssembledProduct product = test::productOf({boxBody("upper", {0.5, 0.5, 0.1}, Pose::translation({0, 0, 0.4})),
                                                    boxBody("lower", {0.5, 0.5, 0.1}, Pose::translation({0, 0, 0.0})),
                                                    boxBody("post", {0.1, 0.1, 0.3}, Pose::translation({0, 0, 0.2}))});
  std::vector<Contact> contacts = contactsOf(2, {0, 1});
  const LiaisonGraph graph(3, contacts, {});
  EXPECT_EQ(baseOf(product, BodySet(3, true), graph, {}, {}, -Vector3::UnitZ()), 1U);
  EXPECT_EQ(baseOf(product, BodySet(3, true), graph, {}, {}, Vector3::UnitZ()), 0U);
  EXPECT_EQ(baseOf(product, BodySet(3, true), graph, {}, {}, Vector3::Zero()), 0U) << "the first one without a ground";
}

}  // namespace
}  // namespace glissade
