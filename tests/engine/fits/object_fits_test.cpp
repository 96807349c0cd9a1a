#include "engine/fits/object_fits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/geometry/primitives.h"
#include "engine/geometry/thinned_mesh.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/fits/turned_parts.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

/// A screw in a plate's tapped hole, its head on the plate, and a distant block, at random poses.
struct Screwed {
  explicit Screwed(double shaft, RandomStream& random) {
    const Pose place = randomPose(random, 0.3);
    obstacles = {test::partAt("plate", test::makeRing(0.0021, 0.02, 0.01, 40), place),
                 test::partAt("block", makeBox({0.01, 0.01, 0.01}), place * Pose::translation({0.1, 0.0, 0.0}))};
    object = test::partAt("screw", test::makeRing(0.0, shaft, 0.03, 37), place);
  }

  Result<ObjectFits> find(const FitSettings& settings) const {
    const AssembledProduct product = test::productOf(obstacles, object, settings);
    return findObjectFits({product, obstacles.size()});
  }

  std::vector<RigidBody> obstacles;
  RigidBody object;
};

FitSettings switchedOn() {
  FitSettings settings;
  settings.on = true;
  return settings;
}

TEST(ObjectFits, AllowsAThreadWhatItOverlapsByAndLeavesAGap) {
  RandomStream random(1, "thread");
  for (int round = 0; round < 5; ++round) {
    const Screwed screwed(0.0024, random);
    const auto fits = screwed.find(switchedOn());
    ASSERT_TRUE(fits);
    ASSERT_EQ(fits->allowed.size(), 1U);
    const Fit& fit = fits->allowed.front();
    EXPECT_EQ(fit.obstacle, 0U);
    EXPECT_EQ(fit.kind, ContactKind::Thread);
    EXPECT_EQ(fit.role, Fit::Role::Shaft);
    EXPECT_NEAR(fit.overlap, 0.0003, 1e-7);
    EXPECT_GT(fit.allowance, 0.0003);
    EXPECT_LT(fit.allowance, 0.00034);
    EXPECT_TRUE(fits->clashes.empty());
    const auto world = CollisionWorld::build(screwed.obstacles, screwed.object.mesh);
    EXPECT_TRUE(world->makeQuery()->collides(screwed.object.X_WB));
    const auto thinned = withFits(world, screwed.object.mesh, fits->allowed);
    EXPECT_TRUE(thinned->makeQuery()->clearAbove(screwed.object.X_WB, 0.5 * assembledGap(0.015)));
  }
}

TEST(ObjectFits, AnAcceptedRodThroughAPlateLeavesAlongAHoleOfItsOwnShape) {
  const std::vector<RigidBody> obstacles{test::partAt("plate", makeBox({0.04, 0.04, 0.006}), Pose::identity())};
  const RigidBody rod = test::partAt("rod", test::prism(32, 0.004, 0.05), Pose::translation({0.0, 0.0, -0.02}));
  FitSettings settings = switchedOn();
  const auto refused = findObjectFits({test::productOf(obstacles, rod, settings), 1});
  ASSERT_TRUE(refused);
  ASSERT_EQ(refused->clashes.size(), 1U);
  const std::string advice = toString(refused->warnings.front().advice);
  EXPECT_NE(advice.find("--accept-clashes 3mm"), std::string::npos) << advice;
  settings.acceptedClash = 4e-3;
  const auto fits = findObjectFits({test::productOf(obstacles, rod, settings), 1});
  ASSERT_TRUE(fits);
  ASSERT_EQ(fits->allowed.size(), 2U);
  EXPECT_TRUE(fits->allowed[0].hollow && fits->allowed[0].yields) << "the plate, which is the larger one";
  EXPECT_LT(fits->allowed[1].allowance, 1e-5);
  EXPECT_EQ(toString(inWords(fits->allowed[0], "rod", "plate")),
            "plate without what overlaps rod, up to 3 mm deep (accepted clash)");
  const auto query = withFits(CollisionWorld::build(obstacles, rod.mesh), rod.mesh, fits->allowed)->makeQuery();
  const auto to = [&](const Vector3& way) {
    return query->checkMotion(rod.X_WB, Pose::translation(way), 2e-7, SeekViolation::Any, {}).status;
  };
  EXPECT_EQ(to({0.0, 0.0, 0.1}), CertificateStatus::Certified);
  EXPECT_EQ(to({0.1, 0.0, 0.0}), CertificateStatus::Violated);
}

TEST(ObjectFits, SaysItInWords) {
  const Fit screw{{"plate", ContactKind::Thread, 0.0004, 0.00041}, 0, 0, Fit::Role::Shaft};
  EXPECT_EQ(toString(inWords(screw, "screw", "plate")), "screw, 0.41 mm in the tapped hole of plate (thread)");
  const Fit nut{{"bolt", ContactKind::Cylindrical, 0.0, 0.0000213}, 0, 0, Fit::Role::Hole};
  EXPECT_EQ(toString(inWords(nut, "nut", "bolt")), "nut, 0.0213 mm on the shaft of bolt (cylindrical)");
  Fit block{{"plate", ContactKind::Planar, 0.0, 0.000001}};
  EXPECT_EQ(toString(inWords(block, "block", "plate")), "block, 0.001 mm on plate (planar)");
  block.evidence.byPerson = 1e-6;
  EXPECT_EQ(toString(inWords(block, "block", "plate")), "block, 0.001 mm on plate (planar, user-defined)");
}

TEST(ObjectFits, AllowsNothingToBodiesThatStandApart) {
  RandomStream random(2, "apart");
  const Screwed screwed(0.002, random);
  const auto fits = screwed.find(switchedOn());
  ASSERT_TRUE(fits);
  EXPECT_TRUE(fits->allowed.empty());
  const auto world = CollisionWorld::build(screwed.obstacles, screwed.object.mesh);
  EXPECT_EQ(withFits(world, screwed.object.mesh, fits->allowed), world);
}

TEST(ObjectFits, AClashNeedsAPersonsWord) {
  RandomStream random(3, "clash");
  const Screwed screwed(0.0033, random);
  const auto refused = screwed.find(switchedOn());
  ASSERT_TRUE(refused);
  EXPECT_TRUE(refused->allowed.empty());
  ASSERT_EQ(refused->clashes.size(), 1U);
  ASSERT_EQ(refused->warnings.size(), 1U);
  EXPECT_EQ(toString(refused->warnings.front().reason), "overlap by 1.203 mm, which is a clash")
      << "1.2 mm, of triangles";

  FitSettings upTo = switchedOn();
  upTo.acceptedClash = 0.0011;
  EXPECT_TRUE(screwed.find(upTo)->allowed.empty());
  upTo.acceptedClash = 0.00121;
  ASSERT_EQ(screwed.find(upTo)->allowed.size(), 1U);
  EXPECT_EQ(screwed.find(upTo)->allowed.front().kind, ContactKind::Clash);
  FitSettings one = switchedOn();
  one.pairs = {{"screw", "plate", {}, {}, true}};
  EXPECT_EQ(screwed.find(one)->allowed.size(), 1U);
}

/// A rod of 20 mm whose end is 157 mm deep in a block: the sides of the rod are 115 mm from the surface of the block,
/// and the surface of the block is 10 mm deep in the rod.
TEST(ObjectFits, APairHasOneDepthWhicheverBodyMoves) {
  const RigidBody block = test::partAt("block", makeBox({0.45, 0.27, 0.42}), Pose::identity());
  const RigidBody rod = test::partAt("rod", makeBox({0.02, 0.33, 0.02}), Pose::translation({-0.06, 0.143, 0.105}));
  const auto clashOf = [](const RigidBody& fixed, const RigidBody& object, double accepted) {
    FitSettings settings = switchedOn();
    settings.acceptedClash = accepted;
    const auto fits = findObjectFits({test::productOf({fixed}, object, settings), 1});
    return fits->clashes.empty() ? std::string() : toString(fits->clashes.front().refused);
  };
  for (const auto& [fixed, object] : {std::pair(block, rod), std::pair(rod, block)}) {
    EXPECT_EQ(clashOf(fixed, object, 0.0), "overlap by 10 mm, which is a clash");
    EXPECT_EQ(clashOf(fixed, object, 0.01 - 1e-6), "overlap by 10 mm, which is a clash");
    EXPECT_EQ(clashOf(fixed, object, 0.01), "");
  }
}

/// Two crossing bars without notches: a person may have forgotten to cut either of them.
TEST(ObjectFits, WhereItIsNotClearWhichBodyIsCutAPersonNamesIt) {
  const RigidBody along = test::partAt("along", makeBox({0.1, 0.01, 0.01}), Pose::identity());
  const RigidBody across = test::partAt("across", makeBox({0.01, 0.1, 0.01}), Pose::translation({0.0, 0.0, 0.004}));
  FitSettings settings = switchedOn();
  settings.acceptedClash = 0.006;
  const auto unclear = findObjectFits({test::productOf({along}, across, settings), 1});
  ASSERT_TRUE(unclear);
  ASSERT_EQ(unclear->clashes.size(), 1U);
  EXPECT_NE(toString(unclear->clashes.front().refused).find("which of the two is cut is not clear"), std::string::npos);
  for (const char* name : {"along", "across"}) {
    settings.cut = {name};
    const auto named = findObjectFits({test::productOf({along}, across, settings), 1});
    ASSERT_EQ(named->allowed.size(), 2U) << name;
    EXPECT_TRUE(named->allowed.front().hollow);
    EXPECT_EQ(named->allowed.front().yields, settings.cut.front() == "along");
  }
}

/// A foot that is drawn 1.2 mm too low. A clash is accepted that is deep enough to thin either body.
TEST(ObjectFits, ABodyThatAPersonNamesIsCutAlsoWhereAThinnerOneIsFree) {
  const RigidBody plate = test::partAt("plate", makeBox({0.1, 0.1, 0.02}), Pose::identity());
  const RigidBody foot = test::partAt("foot", makeBox({0.02, 0.02, 0.05}), Pose::translation({0.0, 0.0, 0.0338}));
  FitSettings settings = switchedOn();
  settings.acceptedClash = 0.005;
  const auto unnamed = findObjectFits({test::productOf({plate}, foot, settings), 1});
  ASSERT_FALSE(unnamed->allowed.empty());
  EXPECT_FALSE(unnamed->allowed.front().hollow);
  for (const char* name : {"plate", "foot"}) {
    settings.cut = {name};
    const auto named = findObjectFits({test::productOf({plate}, foot, settings), 1});
    ASSERT_EQ(named->allowed.size(), 2U) << name;
    EXPECT_TRUE(named->allowed.front().hollow) << name;
    EXPECT_EQ(named->allowed.front().yields, settings.cut.front() == "plate");
  }
}

TEST(ObjectFits, AnOverlapOfPlanesIsPlainAndThatOfAPinIsNot) {
  const auto contactOf = [](const RigidBody& fixed, const RigidBody& object) {
    return findObjectFits({test::productOf({fixed}, object, switchedOn()), 1})->contacts.front();
  };
  const RigidBody plate = test::partAt("plate", makeBox({0.1, 0.1, 0.02}), Pose::identity());
  const RigidBody foot = test::partAt("foot", makeBox({0.02, 0.02, 0.05}), Pose::translation({0.0, 0.0, 0.03425}));
  const Contact plain = contactOf(plate, foot);
  EXPECT_TRUE(plain.isPlainOverlap);
  EXPECT_NEAR(plain.overlap, 7.5e-4, 1e-9);
  const RigidBody bored = test::partAt("bored", test::makeRing(0.005, 0.04, 0.02, 40), Pose::identity());
  const RigidBody pin = test::partAt("pin", test::makeRing(0.0, 0.00505, 0.03, 40), Pose::identity());
  EXPECT_FALSE(contactOf(bored, pin).isPlainOverlap) << "a press fit";
}

/// A tube in a thin bush, and in a plate that has the room that tube and bush lack.
TEST(ObjectFits, WhatWouldLoseMoreThanTwoFifthsOfBothIsAClash) {
  const auto tube = test::partAt("tube", test::makeRing(0.0019, 0.0024, 0.03, 40), Pose::identity());
  for (const auto& [outer, fits] : {std::pair(0.0025, false), std::pair(0.02, true)}) {
    const auto host = test::partAt("host", test::makeRing(0.0021, outer, 0.01, 40), Pose::identity());
    const AssembledProduct product = test::productOf({host}, tube, switchedOn());
    const auto found = findObjectFits({product, 1});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->allowed.size(), fits ? 2U : 0U) << "of what is deep as a thread both give way, so that it turns";
    EXPECT_EQ(found->clashes.size(), fits ? 0U : 1U);
    EXPECT_EQ(found->warnings.size(), found->clashes.size());
  }
}

TEST(ObjectFits, WhatAPersonSaysGoesBeforeWhatWasMeasured) {
  RandomStream random(4, "edits");
  const Screwed screwed(0.0024, random);
  FitSettings settings = switchedOn();
  settings.pairs = {{"plate", "screw", ContactKind::Press, 0.00037, false}};
  const auto fits = screwed.find(settings);
  ASSERT_TRUE(fits);
  ASSERT_EQ(fits->allowed.size(), 1U);
  EXPECT_EQ(fits->allowed.front().kind, ContactKind::Press);
  EXPECT_EQ(fits->allowed.front().allowance, 0.00037);
  EXPECT_EQ(fits->allowed.front().evidence.byPerson, 0.00037);
  settings.pairs.front().allowance = 0.0;
  EXPECT_TRUE(screwed.find(settings)->allowed.empty());
}

TEST(ObjectFits, BadSettingsGetOneClearMessage) {
  RandomStream random(5, "bad");
  const Screwed screwed(0.0024, random);
  const auto reasonOf = [&](const FitEdit& edit) {
    FitSettings settings = switchedOn();
    settings.pairs = {{"plate", "block", ContactKind::Contact, {}, false}, edit};
    const auto fits = screwed.find(settings);
    if (fits) return std::string("no error");
    EXPECT_EQ(fits.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(fits.error().location), "/fits/pairs/1");
    EXPECT_FALSE(fits.error().advice.empty());
    return toString(fits.error().reason);
  };
  EXPECT_NE(reasonOf({"screw", "washer", {}, 0.0001, false}).find("'washer', which is not there"), std::string::npos);
  EXPECT_NE(reasonOf({"screw", "plate", {}, 0.02, false}).find("thickness"), std::string::npos);
  EXPECT_NE(reasonOf({"screw", "block", {}, 0.0001, false}).find("do not touch"), std::string::npos);
}

/// A ring about z without its first triangle that faces outwards, or towards the axis.
enum class Looking { Outwards, ToTheAxis };
MeshPtr opened(const MeshPtr& ring, Looking looking) {
  TriangleMesh open = *ring;
  const auto isMeant = [&](const TriangleIndices& t) {
    const Vector3 normal = faceNormal(open, t);
    if (std::abs(normal.z()) > 0.5) return false;
    return (normal.dot(open.vertices[t[0]]) > 0.0) == (looking == Looking::Outwards);
  };
  open.triangles.erase(std::find_if(open.triangles.begin(), open.triangles.end(), isMeant));
  return std::make_shared<const TriangleMesh>(std::move(open));
}

TEST(ObjectFits, TheOtherBodyGivesWayForAnOpeningAtTheContactAndWhereBothAreOpenThatIsSaid) {
  RandomStream random(6, "open");
  Screwed screwed(0.0021, random);
  screwed.object.mesh = opened(screwed.object.mesh, Looking::Outwards);
  const auto one = screwed.find(switchedOn());
  ASSERT_TRUE(one);
  ASSERT_EQ(one->allowed.size(), 1U);
  EXPECT_TRUE(one->allowed.front().yields);
  screwed.obstacles[0].mesh = opened(screwed.obstacles[0].mesh, Looking::ToTheAxis);
  const auto both = screwed.find(switchedOn());
  ASSERT_TRUE(both);
  EXPECT_TRUE(both->allowed.empty());
  ASSERT_EQ(both->warnings.size(), 1U);
  EXPECT_NE(toString(both->warnings.front().reason).find("the surfaces are open 0 mm and 0 mm from the contact"),
            std::string::npos)
      << toString(both->warnings.front().reason);
}

/// The chamfers at the ends have corners between their edges. They stay where the shaft is thinned, outside of the
/// bore. A pair that is free where it is assembled has to be free along the axis, too.
TEST(ObjectFits, AShaftThatIsTakenThinnerComesOutOfItsHole) {
  RandomStream random(8, "tips");
  for (int round = 0; round < 10; ++round) {
    const double radius = random.uniform(0.00234, 0.0024);
    const double height = random.uniform(0.00015, 0.0003);
    Screwed screwed(radius, random);
    std::vector<test::Station> stations{{-0.015, test::circle(0.0)},
                                        {-0.015, test::circle(0.85 * radius)},
                                        {-0.015 + 0.6 * height, test::circle(0.94 * radius)},
                                        {-0.015 + height, test::circle(radius)}};
    for (std::size_t i = stations.size(); i > 0; --i) {
      stations.push_back({-stations[i - 1].height, stations[i - 1].contour});
    }
    screwed.object.mesh = std::make_shared<const TriangleMesh>(test::turnedMesh(stations, false, 37 + round));
    const auto fits = screwed.find(switchedOn());
    ASSERT_TRUE(fits);
    ASSERT_FALSE(fits->allowed.empty()) << round;
    MeshPtr object = screwed.object.mesh;
    RigidBody plate = screwed.obstacles[0];
    for (const Fit& fit : fits->allowed) (fit.yields ? plate.mesh : object) = fit.thinned;
    const auto query = CollisionWorld::build({plate}, object)->makeQuery();
    const Pose& from = screwed.object.X_WB;
    int ways = 0;
    for (const double sense : {1.0, -1.0}) {
      Pose to = from;
      to.position += from.orientation * Vector3(0.0, 0.0, sense * 0.06);
      ways += query->checkMotion(from, to, 1e-7, SeekViolation::Any, {}).status == CertificateStatus::Certified;
    }
    EXPECT_GE(ways, 1) << round;
  }
}

/// The plate moves off its screw: the hole is thinned along its length, while the shaft would be thinned only inside
/// the hole.
TEST(ObjectFits, TheBodyWithTheHoleGivesWay) {
  RandomStream random(7, "whichever");
  const Screwed screwed(0.0024, random);
  const AssembledProduct product = test::productOf(screwed.obstacles, screwed.object, switchedOn());
  const auto fits = findObjectFits({product, 0});
  ASSERT_TRUE(fits);
  ASSERT_EQ(fits->allowed.size(), 1U);
  const Fit& fit = fits->allowed.front();
  EXPECT_EQ(fit.obstacle, 2U);
  EXPECT_FALSE(fit.yields);
  EXPECT_EQ(fit.role, Fit::Role::Hole);
  const std::string words = toString(inWords(fit, "plate", "screw"));
  EXPECT_EQ(words.find("plate, "), 0U) << words;
  std::vector<RigidBody> others{product.bodies[1], product.bodies[2]};
  Fit moved = fit;
  moved.obstacle = 1;
  const auto world = CollisionWorld::build(others, product.bodies[0].mesh);
  EXPECT_TRUE(world->makeQuery()->collides(product.bodies[0].X_WB));
  EXPECT_FALSE(withFits(world, product.bodies[0].mesh, {moved})->makeQuery()->collides(product.bodies[0].X_WB));
}

}  // namespace
}  // namespace glissade
