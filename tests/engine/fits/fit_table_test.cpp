#include "engine/fits/fit_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/primitives.h"
#include "engine/import/step_import.h"
#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/fits/turned_parts.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

FitTable tableOf(const AssembledProduct& product) {
  ThreadTeam team(1);
  auto table = FitTable::find(product, team, {});
  EXPECT_TRUE(table.ok()) << (table.ok() ? "" : toString(table.error()));
  return table.ok() ? std::move(*table) : FitTable::whole(product);
}

/// Rings on one shaft, of random radii and lengths: gaps, fits, threads and clashes.
AssembledProduct randomRings(RandomStream& random) {
  const Pose place = randomPose(random, 0.2);
  std::vector<RigidBody> bodies{test::partAt("shaft", test::makeRing(0.0, 0.005, 0.08, 40), place)};
  double z = -0.03;
  for (int i = 0; i < 4; ++i) {
    const double length = random.uniform(0.004, 0.012);
    const double inner = 0.005 + random.uniform(-0.0015, 0.0005);
    const double outer = inner + random.uniform(0.0005, 0.01);
    const Pose at = place * Pose::translation({0.0, 0.0, z + 0.5 * length});
    bodies.push_back(test::partAt("ring" + std::to_string(i), test::makeRing(inner, outer, length, 36), at));
    z += length + (random.uniform(0.0, 1.0) < 0.5 ? 0.0 : 0.001);
  }
  FitSettings settings;
  settings.on = true;
  const RigidBody last = bodies.back();
  bodies.pop_back();
  return test::productOf(std::move(bodies), last, settings);
}

/// Expects that the fits of a single moving body equal those of the table, pair by pair.
void expectSameAsAlone(const AssembledProduct& product, const FitTable& table) {
  for (const PairFit& pair : table.pairs()) {
    for (const bool moveA : {true, false}) {
      const std::size_t moving = moveA ? pair.contact.a : pair.contact.b;
      const std::size_t other = moveA ? pair.contact.b : pair.contact.a;
      const auto alone = findObjectFits({product, moving});
      ASSERT_TRUE(alone.ok());
      std::vector<Fit> fits;
      for (const Fit& fit : alone->allowed) {
        if (fit.obstacle == other) fits.push_back(fit);
      }
      const std::vector<Fit>& taken = pair.ways[moveA ? 0 : 1].taken;
      ASSERT_EQ(taken.size(), fits.size()) << pair.a << " " << pair.b;
      for (std::size_t i = 0; i < fits.size(); ++i) {
        EXPECT_EQ(taken[i].allowance, fits[i].allowance);
        EXPECT_EQ(taken[i].yields, fits[i].yields);
        EXPECT_EQ(taken[i].kind, fits[i].kind);
        EXPECT_EQ(taken[i].kind, pair.contact.kind);
      }
    }
  }
}

/// Deadlines that are over leave all pairs, deadlines that are not leave none.
TEST(FitTable, PairsThatDeadlinesLeaveAreNamed) {
  RandomStream random(3, "rings");
  const AssembledProduct product = randomRings(random);
  ThreadTeam team(1);
  StopSource over;
  over.requestStop();
  const StopToken never;
  const std::size_t all = tableOf(product).pairs().size();
  for (const auto& [contacts, pairs] : {std::pair(over.token(), never), std::pair(never, over.token())}) {
    const auto left = FitTable::find(product, team, {}, {}, FitDeadlines{contacts, pairs});
    ASSERT_TRUE(left.ok());
    EXPECT_TRUE(left->pairs().empty());
    EXPECT_GE(left->notCompared().size(), all);
  }
  const auto whole = FitTable::find(product, team, {}, {}, FitDeadlines{never, never});
  ASSERT_TRUE(whole.ok());
  EXPECT_EQ(whole->pairs().size(), all);
  EXPECT_TRUE(whole->notCompared().empty());
}

TEST(FitTable, IsWhatEachBodyFindsAlone) {
  RandomStream random(1, "rings");
  for (int round = 0; round < 6; ++round) {
    const AssembledProduct product = randomRings(random);
    expectSameAsAlone(product, tableOf(product));
  }
}

/// Whichever body moves, one body of the pair is thinned; by at least as much if the larger one moves.
TEST(FitTable, TheSameBodyGivesWayWhicheverMoves) {
  RandomStream random(2, "rings");
  int pairs = 0;
  for (int round = 0; round < 6; ++round) {
    const AssembledProduct product = randomRings(random);
    const FitTable table = tableOf(product);
    for (const PairFit& pair : table.pairs()) {
      if (pair.status() != FitStatus::Allowed) continue;
      ++pairs;
      ASSERT_EQ(pair.ways[0].taken.size(), pair.ways[1].taken.size());
      for (std::size_t i = 0; i < pair.ways[0].taken.size(); ++i) {
        const bool aGivesWay = !pair.ways[0].taken[i].yields;
        EXPECT_TRUE(std::any_of(pair.ways[1].taken.begin(), pair.ways[1].taken.end(),
                                [&](const Fit& fit) { return fit.yields == aGivesWay; }))
            << pair.a << " " << pair.b;
      }
    }
  }
  EXPECT_GT(pairs, 20);
}

/// A block on a table that is much larger, and so keeps more clearance when it moves.
TEST(FitTable, WhatSufficesForTheSmallBodySufficesForTheLargeOne) {
  FitSettings settings;
  settings.on = true;
  settings.pairs = {{"block", "table", ContactKind::Contact, 6e-6, false}};
  const AssembledProduct product = test::productOf(
      {test::partAt("table", makeBox({0.4, 0.4, 0.4}), Pose::identity())},
      test::partAt("block", makeBox({0.01, 0.01, 0.01}), Pose::translation({0.0, 0.0, 0.205})), settings);
  ASSERT_GT(0.5 * assembledGap(0.2 * std::sqrt(3.0)), 6e-6);
  const FitTable table = tableOf(product);
  ASSERT_EQ(table.pairs().size(), 1U);
  for (const PairWay& way : table.pairs().front().ways) {
    EXPECT_TRUE(way.refused.empty()) << toString(way.refused);
    ASSERT_EQ(way.taken.size(), 1U);
    EXPECT_EQ(way.taken.front().allowance, 6e-6);
  }
}

TEST(FitTable, ARefusedPairSaysWhy) {
  FitSettings settings;
  settings.on = true;
  const AssembledProduct product =
      test::productOf({test::partAt("plate", test::makeRing(0.0021, 0.02, 0.01, 40), Pose::identity())},
                      test::partAt("peg", test::makeRing(0.0, 0.0033, 0.03, 37), Pose::identity()), settings);
  const FitTable table = tableOf(product);
  ASSERT_EQ(table.pairs().size(), 1U);
  const PairFit& pair = table.pairs().front();
  EXPECT_EQ(pair.status(), FitStatus::Clash);
  EXPECT_EQ(pair.contact.kind, ContactKind::Clash);
  EXPECT_NE(toString(pair.way().refused).find("1.203 mm"), std::string::npos) << toString(pair.way().refused);
  EXPECT_TRUE(pair.thinner().empty());
  EXPECT_EQ(table.warnings().size(), 1U);
}

/// A cone in a rod, with its base in the end of the rod: their surfaces only touch, and the cone is a clash.
TEST(FitTable, AnAcceptedClashStaysAClashWhereSurfacesOnlyTouch) {
  FitSettings settings;
  settings.on = true;
  settings.acceptedClash = 0.006;
  const TriangleMesh cone =
      test::turnedMesh({{0.0, test::circle(0.0)}, {0.0, test::circle(0.003)}, {0.005, test::circle(0.0)}}, false);
  const AssembledProduct product =
      test::productOf({test::partAt("rod", test::rodMesh(0.01, 0.0, 0.1), Pose::identity())},
                      test::partAt("cone", cone, Pose::identity()), settings);
  const FitTable table = tableOf(product);
  ASSERT_EQ(table.pairs().size(), 1U);
  const PairFit& pair = table.pairs().front();
  EXPECT_EQ(pair.contact.kind, ContactKind::Clash);
  EXPECT_EQ(pair.status(), FitStatus::Accepted);
  EXPECT_NEAR(pair.contact.overlap, 0.005, 1e-5);
}

TEST(FitTable, OfAStepProduct) {
  const auto read = importStep(test::stepFile("fits.step"), 0.0);
  ASSERT_TRUE(read);
  AssembledProduct product;
  for (const Occurrence& part : read->parts) {
    RigidBody body;
    body.id = BodyId(part.path);
    body.name = part.path;
    body.mesh = part.mesh;
    body.X_WB = part.X_FP;
    product.bodies.push_back(std::move(body));
    product.deflections.push_back(part.deflection);
  }
  product.fits.on = true;
  product.bodies = aboutTheirMiddles(std::move(product.bodies));
  const FitTable table = tableOf(product);
  EXPECT_EQ(countsByKind(table.pairs()),
            (std::map<std::string, int>{{"clash", 1}, {"cylindrical", 3}, {"planar", 2}, {"press", 1}, {"thread", 1}}));
  expectSameAsAlone(product, table);
}

}  // namespace
}  // namespace glissade
