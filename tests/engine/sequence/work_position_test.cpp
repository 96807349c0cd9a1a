#include "engine/sequence/work_position.h"

#include <gtest/gtest.h>

#include <utility>

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

/// The position of a product in which all bodies are there.
WorkPosition positionOf(const AssembledProduct& product, const std::vector<Contact>& contacts,
                        std::optional<Vector3> up = {}, const Joints& joints = {},
                        const std::vector<FastenerKind>& fasteners = {}) {
  const LiaisonGraph graph(product.bodies.size(), contacts, {});
  return workPosition({product, graph, joints, fasteners, BodySet(product.bodies.size(), true), {}, std::move(up)});
}

/// The product, turned about the origin.
AssembledProduct turned(AssembledProduct product, const Quaternion& turn) {
  for (RigidBody& body : product.bodies) body.X_WB = Pose{Vector3::Zero(), turn} * body.X_WB;
  return product;
}

TEST(WorkPosition, APlateThatMuchIsFixedToIsTheBaseAndNotALongRodOrALargeCover) {
  const AssembledProduct product = plateWithPosts();
  const std::vector<Contact> contacts = contactsOf(1, {0, 3, 4, 5});
  EXPECT_EQ(positionOf(product, contacts).base, 1U);
  EXPECT_TRUE(positionOf(product, contacts).up.isApprox(Vector3::UnitZ()));
  const LiaisonGraph graph(6, contacts, {});
  EXPECT_EQ(workPosition({product, graph, {}, {}, {true, false, true, true, false, false}}).base, 2U)
      << "where nothing touches, the largest one";
  Joint insert;
  insert.kind = JointKind::Insert;
  insert.body = 1;
  insert.others = {2};
  EXPECT_NE(positionOf(product, contacts, {}, {insert}).base, 1U) << "a guest is no base";
  std::vector<FastenerKind> kinds(6, FastenerKind::None);
  kinds[1] = FastenerKind::Washer;
  EXPECT_NE(positionOf(product, contacts, {}, {}, kinds).base, 1U) << "nor is a fastener";
}

TEST(WorkPosition, OfTwoAlikeTheOneThatStandsOnTheGroundIsTheBase) {
  const AssembledProduct product = test::productOf({boxBody("upper", {0.5, 0.5, 0.1}, Pose::translation({0, 0, 0.4})),
                                                    boxBody("lower", {0.5, 0.5, 0.1}, Pose::translation({0, 0, 0.0})),
                                                    boxBody("post", {0.1, 0.1, 0.3}, Pose::translation({0, 0, 0.2}))});
  const std::vector<Contact> contacts = contactsOf(2, {0, 1});
  EXPECT_EQ(positionOf(product, contacts).base, 1U);
  EXPECT_EQ(positionOf(product, contacts, Vector3::UnitZ()).base, 1U);
  EXPECT_EQ(positionOf(product, contacts, -Vector3::UnitZ()).base, 0U) << "a person turns it over";
}

TEST(WorkPosition, APlateLiesFlatWithTheOthersAboveItHoweverItIsInTheFile) {
  const AssembledProduct product = plateWithPosts();
  const std::vector<Contact> contacts = contactsOf(1, {0, 3, 4, 5});
  std::srand(7);
  for (int i = 0; i < 20; ++i) {
    const Quaternion turn =
        i == 0 ? Quaternion(Eigen::AngleAxisd(0.5 * std::acos(-1.0), Vector3::UnitX())) : Quaternion::UnitRandom();
    const WorkPosition position = positionOf(turned(product, turn), contacts);
    EXPECT_EQ(position.base, 1U) << i;
    EXPECT_NEAR(position.up.dot(turn * Vector3::UnitZ()), 1.0, 1e-9) << i;
  }
}

TEST(WorkPosition, AProductThatStandsWellIsNotTurned) {
  const AssembledProduct cubes = test::productOf({boxBody("below", {0.2, 0.2, 0.2}, Pose::translation({0, 0, 0.1})),
                                                  boxBody("above", {0.2, 0.2, 0.2}, Pose::translation({0, 0, 0.3}))});
  const WorkPosition position = positionOf(cubes, contactsOf(0, {1}));
  EXPECT_EQ(position.base, 0U);
  EXPECT_TRUE(position.up.isApprox(Vector3::UnitZ()));
}

TEST(WorkPosition, ABodyThatWouldTipOverDoesNotStand) {
  // A mast with a foot on one side of it. The centre of the mast is beyond the foot, so that it does not stand on it.
  RigidBody mast = boxBody("mast", {0.4, 0.1, 0.9}, Pose::translation({0.0, 0.0, 0.55}));
  TriangleMesh mesh = *mast.mesh;
  append(mesh, transformed(*boxBody("foot", {0.02, 0.1, 0.1}, {}).mesh, Pose::translation({-0.19, 0.0, -0.5})));
  mast.mesh = std::make_shared<const TriangleMesh>(mesh);
  const AssembledProduct product =
      test::productOf({mast, boxBody("lamp", {0.05, 0.05, 0.05}, Pose::translation({0.0, 0.075, 0.55}))});
  const WorkPosition position = positionOf(product, contactsOf(0, {1}));
  EXPECT_NEAR(position.up.y(), 1.0, 1e-9) << position.up.transpose() << ": it lies, with the lamp above it";
}

}  // namespace
}  // namespace glissade
