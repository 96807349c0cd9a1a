#include "engine/fits/contact_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "engine/geometry/primitives.h"
#include "engine/import/step_import.h"
#include "engine/model/body_path.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

constexpr double kRoom = 0.5;  ///< half width of the space for bodies, metres

ContactBody body(const char* id, const TriangleMesh& mesh, const Pose& X_WB) {
  return {BodyId(id), std::make_shared<const TriangleMesh>(mesh), X_WB};
}

/// A shaft in a ring's hole, both turned about their axis at random, at a random pose.
ContactReport shaftInHole(RandomStream& random, double shaft, double hole, const ContactLimits& limits = {}) {
  const Pose place = randomPose(random, kRoom);
  const auto turned = [&] {
    return place * Pose{Vector3::Zero(), Quaternion(Eigen::AngleAxisd(random.uniform(), Vector3::UnitZ()))};
  };
  const int segments = 16 + static_cast<int>(40.0 * random.uniform());
  return findContacts({body("ring", test::makeRing(hole, 3.0 * hole, 0.01, segments), turned()),
                       body("shaft", test::makeRing(0.0, shaft, 0.04, segments + 5), turned())},
                      limits);
}

TEST(ContactReport, TellsShaftsInHolesByTheirRadii) {
  RandomStream random(1, "shafts");
  for (int round = 0; round < 3; ++round) {
    const double hole = 0.002 + 0.004 * random.uniform();
    const auto kindOf = [&](double shaft) {
      const ContactReport report = shaftInHole(random, shaft, hole);
      return report.contacts.size() == 1 ? kContactKindNames.of(report.contacts.front().kind) : "none";
    };
    EXPECT_STREQ(kindOf(hole), "cylindrical");
    EXPECT_STREQ(kindOf(1.1 * hole), "thread");
    EXPECT_STREQ(kindOf(1.01 * hole), "press");
    EXPECT_STREQ(kindOf(0.98 * hole), "none");
    EXPECT_STREQ(kindOf(hole + 0.0015), "clash");
  }
}

TEST(ContactReport, MeasuresCoaxialOverlapsAndGapsExactly) {
  RandomStream random(2, "coaxial");
  for (int round = 0; round < 3; ++round) {
    const double hole = 0.003 + 0.004 * random.uniform();
    const double difference = 0.0001 + 0.0004 * random.uniform();
    const ContactReport thicker = shaftInHole(random, hole + difference, hole);
    ASSERT_EQ(thicker.contacts.size(), 1U);
    EXPECT_NEAR(thicker.contacts.front().overlap, difference, 1e-7);
    ASSERT_TRUE(thicker.contacts.front().axis);
    EXPECT_NEAR(thicker.contacts.front().axis->radiusA, hole, 1e-7);
    EXPECT_NEAR(thicker.contacts.front().axis->radiusB, hole + difference, 1e-7);
    ContactLimits band;
    band.clearanceUpTo = 2.0 * difference;
    const ContactReport thinner = shaftInHole(random, hole - difference, hole, band);
    ASSERT_EQ(thinner.contacts.size(), 1U);
    EXPECT_EQ(thinner.contacts.front().kind, ContactKind::Clearance);
    EXPECT_NEAR(thinner.contacts.front().gap, difference, 1e-7);
  }
}

TEST(ContactReport, MeasuresBlocksThatTouchOverlapAndStandApart) {
  RandomStream random(3, "blocks");
  const TriangleMesh block = makeBox({0.02, 0.03, 0.04});
  for (int round = 0; round < 3; ++round) {
    const Pose place = randomPose(random, kRoom);
    const double shift = 0.01 * random.uniform();
    const auto report = [&](double gap, double clearance) {
      ContactLimits limits;
      limits.clearanceUpTo = clearance;
      return findContacts(
          {body("a", block, place), body("b", block, place * Pose::translation({0.02 + gap, shift, shift}))}, limits);
    };
    const double way = 0.0001 + 0.0008 * random.uniform();
    ASSERT_EQ(report(0.0, 0.0).contacts.size(), 1U);
    EXPECT_EQ(report(0.0, 0.0).contacts.front().kind, ContactKind::Planar);
    EXPECT_TRUE(report(way, 0.5 * way).contacts.empty());
    const ContactReport apart = report(way, 2.0 * way);
    ASSERT_EQ(apart.contacts.size(), 1U);
    EXPECT_NEAR(apart.contacts.front().gap, way, 1e-7);
    const ContactReport deep = report(-way, 0.0);
    ASSERT_EQ(deep.contacts.size(), 1U);
    EXPECT_EQ(deep.contacts.front().kind, ContactKind::Overlap);
    EXPECT_NEAR(deep.contacts.front().overlap, way, 1e-6);
    EXPECT_EQ(report(-0.0015, 0.0).contacts.front().kind, ContactKind::Clash);
  }
}

/// A board that leans with one edge at a plate, and has a foot that is parallel to it. The gap of the foot is no reason
/// against the contact of the edge.
TEST(ContactReport, AnEdgeOnAFaceTouchesItBesideAFaceThatDoesNot) {
  constexpr double kFoot = 0.0005;
  const std::vector<std::array<double, 2>> outline{{0.0, 0.0},    {0.01, 0.005},  {0.01, 0.02},
                                                   {-0.02, 0.02}, {-0.02, kFoot}, {-0.015, kFoot}};
  TriangleMesh board;
  for (const double y : {-0.005, 0.005}) {
    for (const auto& [x, z] : outline) board.vertices.emplace_back(x, y, z);
  }
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t k = (i + 1) % count;
    board.triangles.push_back({i, count + k, k});
    board.triangles.push_back({i, count + i, count + k});
  }
  // The outline is seen as a whole from the corner on the plate.
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    board.triangles.push_back({0, i, i + 1});
    board.triangles.push_back({count, count + i + 1, count + i});
  }
  RandomStream random(6, "edges");
  for (int round = 0; round < 3; ++round) {
    const Pose place = randomPose(random, kRoom);
    const auto plate = body("plate", makeBox({0.1, 0.1, 0.01}), place * Pose::translation({0.0, 0.0, -0.005}));
    for (const double clearance : {0.0, 2.0 * kFoot}) {
      ContactLimits limits;
      limits.clearanceUpTo = clearance;
      const ContactReport report = findContacts({plate, body("board", board, place)}, limits);
      ASSERT_EQ(report.contacts.size(), 1U) << clearance;
      EXPECT_EQ(report.contacts.front().kind, ContactKind::Contact) << clearance;
    }
  }
}

TEST(ContactReport, CallsABlockInsideAnotherAClash) {
  const ContactReport report = findContacts({body("inner", makeBox({0.01, 0.01, 0.01}), Pose::identity()),
                                             body("outer", makeBox({0.1, 0.1, 0.1}), Pose::identity())});
  ASSERT_EQ(report.contacts.size(), 1U);
  EXPECT_EQ(report.contacts.front().kind, ContactKind::Clash);
}

/// The mesh with reversed triangles.
TriangleMesh insideOut(TriangleMesh mesh) {
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  return mesh;
}

TEST(ContactReport, AMeshThatIsInsideOutHasTheSameContacts) {
  const TriangleMesh ring = test::makeRing(0.005, 0.01, 0.02, 24);
  const TriangleMesh shaft = test::makeRing(0.0, 0.0055, 0.04, 31);
  for (const auto& [a, b] : {std::pair{ring, shaft}, std::pair{insideOut(ring), shaft},
                             std::pair{ring, insideOut(shaft)}, std::pair{insideOut(ring), insideOut(shaft)}}) {
    const ContactReport report = findContacts({body("a", a, Pose::identity()), body("b", b, Pose::identity())});
    ASSERT_EQ(report.contacts.size(), 1U);
    EXPECT_EQ(report.contacts.front().kind, ContactKind::Thread);
    EXPECT_NEAR(report.contacts.front().overlap, 0.0005, 1e-7);
  }
}

/// In a public file, a peg that is inside out is on a body that is not: it seemed to be a hole around the tube.
TEST(ContactReport, APegThatIsInsideOutIsNoHole) {
  TriangleMesh pegged = insideOut(test::makeRing(0.0, 0.018, 0.01, 16));
  const TriangleMesh block = makeBox({0.1, 0.1, 0.02});
  const auto base = static_cast<std::uint32_t>(pegged.vertices.size());
  for (const Vector3& p : block.vertices) pegged.vertices.emplace_back(p - Vector3(0.0, 0.0, 0.05));
  for (const auto& [a, b, c] : block.triangles) pegged.triangles.push_back({base + a, base + b, base + c});
  const ContactReport report = findContacts({body("pegged", pegged, Pose::identity()),
                                             body("tube", test::makeRing(0.0185, 0.019, 0.01, 16), Pose::identity())});
  for (const Contact& contact : report.contacts) {
    EXPECT_EQ(contact.overlap, 0.0) << kContactKindNames.of(contact.kind);
    EXPECT_NE(contact.kind, ContactKind::Clash);
  }
}

TEST(ContactReport, AsksOnlyForThePairsOfOneBody) {
  const TriangleMesh cube = makeBox({0.01, 0.01, 0.01});
  const std::vector<ContactBody> row{body("a", cube, Pose::identity()),
                                     body("b", cube, Pose::translation({0.01, 0.0, 0.0})),
                                     body("c", cube, Pose::translation({0.02, 0.0, 0.0}))};
  ContactLimits limits;
  EXPECT_EQ(findContacts(row, limits).contacts.size(), 2U);
  limits.only = 2;
  ASSERT_EQ(findContacts(row, limits).contacts.size(), 1U);
  EXPECT_EQ(findContacts(row, limits).contacts.front().a, 1U);
}

std::vector<ContactBody> stepBodies(const std::string& name) {
  const auto product = importStep(test::stepFile(name), 0.0);
  EXPECT_TRUE(product);
  std::vector<ContactBody> bodies;
  if (!product) return bodies;
  for (const Occurrence& part : product->parts)
    bodies.push_back({BodyId(part.path), part.mesh, part.X_FP, part.deflection});
  return bodies;
}

/// The only contact of the product with the body of this name.
Contact contactWith(const std::string& name, const std::vector<ContactBody>& bodies, const ContactReport& report) {
  std::vector<Contact> found;
  for (const Contact& contact : report.contacts) {
    for (const std::size_t i : {contact.a, contact.b}) {
      if (lastStepOf(bodies[i].id.text()) == name) found.push_back(contact);
    }
  }
  EXPECT_EQ(found.size(), 1U) << name;
  return found.empty() ? Contact() : found.front();
}

/// Cones, balls and grooves as stated by the file: the result is exact, although the triangles deviate by 0.1 mm.
TEST(ContactReport, ComparesStatedRoundSurfacesExactly) {
  const std::vector<ContactBody> bodies = stepBodies("round-fits.step");
  ContactLimits limits;
  limits.clearanceUpTo = 1e-4;
  const ContactReport report = findContacts(bodies, limits);
  const double share = std::sqrt(0.5);  // share of a displacement along the axis that is across a cone of 90 degrees
  const Contact seated = contactWith("seated", bodies, report);
  EXPECT_EQ(seated.kind, ContactKind::Contact);
  EXPECT_EQ(seated.uncertainty, 0.0);
  ASSERT_TRUE(seated.axis);
  EXPECT_TRUE(seated.axis->conical);
  EXPECT_FALSE(seated.axis->shaftIsA) << "the plate is the first body";
  EXPECT_NEAR(seated.axis->direction.z(), 1.0, 1e-9);
  EXPECT_NEAR(seated.axis->radiusA, 3.25e-3, 1e-8);
  EXPECT_NEAR(seated.axis->radiusB, 3.25e-3, 1e-8);
  const Contact deep = contactWith("deep", bodies, report);
  EXPECT_EQ(deep.kind, ContactKind::Overlap);
  EXPECT_NEAR(deep.overlap, 1e-4 * share, 1e-9);
  EXPECT_EQ(deep.uncertainty, 0.0);
  const Contact high = contactWith("high", bodies, report);
  EXPECT_EQ(high.kind, ContactKind::Clearance);
  EXPECT_NEAR(high.gap, 5e-5 * share, 1e-9);
  EXPECT_EQ(high.uncertainty, 0.0);
  const Contact ball = contactWith("ball", bodies, report);
  EXPECT_EQ(ball.kind, ContactKind::Contact);
  EXPECT_EQ(ball.uncertainty, 0.0);
  const Contact small = contactWith("small", bodies, report);
  EXPECT_EQ(small.kind, ContactKind::Clearance);
  EXPECT_NEAR(small.gap, 5e-5, 1e-9);
}

TEST(ContactReport, KnowsTheFitsOfAStepProduct) {
  const std::vector<ContactBody> bodies = stepBodies("fits.step");
  std::map<std::string, std::string> kinds;
  for (const Contact& contact : findContacts(bodies).contacts) {
    const auto nameOf = [&](std::size_t i) { return lastStepOf(bodies[i].id.text()); };
    const auto [low, high] = std::minmax({nameOf(contact.a), nameOf(contact.b)});
    kinds[low + " " + high] = kContactKindNames.of(contact.kind);
  }
  const std::map<std::string, std::string> expected{{"bolt bracket", "cylindrical"}, {"bolt plate", "cylindrical"},
                                                    {"bolt nut", "cylindrical"},     {"bracket plate", "planar"},
                                                    {"nut plate", "planar"},         {"plate screw", "thread"},
                                                    {"dowel plate", "press"},        {"block plate", "clash"}};
  EXPECT_EQ(kinds, expected);
}

}  // namespace
}  // namespace glissade
