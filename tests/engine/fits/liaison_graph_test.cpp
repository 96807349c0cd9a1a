#include "engine/fits/liaison_graph.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

Joint joining(JointKind kind, std::size_t body, std::vector<std::size_t> others, std::vector<std::size_t> clamped) {
  Joint joint;
  joint.kind = kind;
  joint.body = body;
  joint.others = std::move(others);
  joint.clamped = std::move(clamped);
  joint.direction = Vector3::UnitX();
  return joint;
}

Contact touching(std::size_t a, std::size_t b, ContactKind kind) {
  Contact contact;
  contact.a = a;
  contact.b = b;
  contact.kind = kind;
  return contact;
}

TEST(LiaisonGraph, AnEdgeIsAContactOrAJointAndSaysHowItLetsGo) {
  Contact shaft = touching(0, 1, ContactKind::Cylindrical);
  shaft.axis = ContactAxis{};
  const LiaisonGraph graph(5, {shaft, touching(1, 2, ContactKind::Planar), touching(2, 4, ContactKind::Clearance)},
                           {joining(JointKind::Screw, 3, {0}, {1})});
  ASSERT_EQ(graph.liaisons().size(), 4U);
  const Liaison& hole = graph.liaisons()[0];
  EXPECT_EQ(hole.contact, ContactKind::Cylindrical);
  EXPECT_EQ(hole.lettingGo, (std::vector<Vector3>{Vector3::UnitZ(), -Vector3::UnitZ()}));
  const Liaison& screw = graph.liaisons()[1];
  EXPECT_EQ(std::pair(screw.a, screw.b), std::pair(std::size_t{0}, std::size_t{3}));
  EXPECT_FALSE(screw.contact);
  EXPECT_EQ(screw.joints, std::vector<JointKind>{JointKind::Screw});
  EXPECT_EQ(screw.lettingGo, std::vector<Vector3>{Vector3::UnitX()}) << "the screw leaves along its direction";
  EXPECT_EQ(graph.neighboursOf(1), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_TRUE(graph.neighboursOf(4).empty()) << "a clearance holds nothing";
}

TEST(LiaisonGraph, ClustersAreWhatJointsConnect) {
  const LiaisonGraph graph(7, {touching(0, 1, ContactKind::Planar), touching(3, 4, ContactKind::Planar)},
                           {joining(JointKind::Screw, 2, {1}, {3}), joining(JointKind::Pin, 5, {4}, {}),
                            joining(JointKind::Flexible, 6, {0, 4}, {})});
  EXPECT_EQ(graph.clusters(), (std::vector<std::vector<std::size_t>>{{1, 2, 3}, {4, 5}}))
      << "contacts and belts connect nothing";
}

}  // namespace
}  // namespace glissade
