// Tests which holes fit, and which way the strategies take: paper 2, table 1 and sections 6.1 and 6.2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/planning/coarse/topological_planner.h"
#include "engine/planning/planner.h"
#include "tests/engine/support/shape_game.h"

namespace glissade {
namespace {

/// A game that is built once for all tests of this program, because it takes two seconds.
const test::KnownGame& game(const std::string& preset, const std::string& shape) {
  static std::map<std::string, test::KnownGame> games;
  return games.try_emplace(preset + shape, preset, shape).first->second;
}

/// Names of the places on the cheapest path, in order.
std::vector<std::string> route(const test::KnownGame& game, const std::string& strategy, const SemanticEdits& edits,
                               const LearntCosts& learnt = {}) {
  const SemanticModel semantics =
      semanticsOf(game.loaded.problem, *game.knowledge, std::make_shared<const SemanticEdits>(edits));
  std::vector<std::string> locals;
  const PlannerRegistry registry = makeLocalPlannerRegistry();
  for (const PlannerEntry& entry : registry.entries()) locals.push_back(entry.id);
  const auto rules = parseRules(presetRules(strategy), semantics.table(), locals);
  const Problem& problem = game.loaded.problem;
  const TopologicalGraph graph =
      *makeTopologicalGraph(game.knowledge->environment->map, semantics, *rules, problem.start.position,
                            std::get<Pose>(problem.goal).position, learnt);
  const std::vector<int> nodes = cheapestPath(graph);
  std::vector<std::string> names;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    names.push_back(semantics.placeName(static_cast<std::size_t>(edgeBetween(graph, nodes[i - 1], nodes[i]).place)));
  }
  return names;
}

std::vector<std::string> route(const std::string& shape, const std::string& strategy) {
  const test::KnownGame& known = game("tight", shape);
  return route(known, strategy, *known.loaded.problem.scene.edits);
}

using Names = std::vector<std::string>;

class Table1 : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Table1, TheComputedCompatibilityIsThatOfThePaper) {
  const std::map<std::string, std::set<std::string>> fits{{"circle", {"P6", "P7", "P9"}},
                                                          {"square", {"P6", "P7", "P9"}},
                                                          {"triangle", {"P7", "P8", "P9"}},
                                                          {"pentagon", {"P9"}},
                                                          {"star", {"P9"}}};
  const auto [preset, shape] = GetParam();
  const test::KnownGame& known = game(preset, shape);
  const SemanticModel semantics = known.semantics();
  for (const char* hole : {"P6", "P7", "P8", "P9"}) {
    const int place = test::placeNamed(semantics, hole);
    ASSERT_NE(place, kNoPlace);
    const PassageFit& fit = known.knowledge->fits[static_cast<std::size_t>(place)];
    EXPECT_EQ(fit.score >= PassageFit::kFits, fits.at(shape).count(hole) == 1) << hole << ", margin " << fit.margin;
    const ProvenValue value = semantics.ofPlace(static_cast<std::size_t>(place), "compatibility");
    EXPECT_EQ(value.provenance, Provenance::Computed);
    EXPECT_EQ(std::get<double>(value.value), fit.score);
  }
  for (const char* room : {"P1", "P2", "P3", "P5"}) {
    EXPECT_GE(known.knowledge->fits[static_cast<std::size_t>(test::placeNamed(semantics, room))].score,
              PassageFit::kFits)
        << room;
  }
}

TEST_P(Table1, AStraightCrossingIsFreeAndGoesFromOneSideToTheOther) {
  const auto [preset, shape] = GetParam();
  const test::KnownGame& known = game(preset, shape);
  const auto query = known.loaded.problem.world->makeQuery();
  int crossings = 0;
  for (std::size_t place = 0; place < known.knowledge->fits.size(); ++place) {
    const auto& crossing = known.knowledge->fits[place].crossing;
    if (!crossing) continue;
    ++crossings;
    const MotionCertificate certificate = certifyPath(*query, {crossing->before, crossing->inside, crossing->behind},
                                                      known.loaded.parameters[ParameterId::RequiredClearance]);
    EXPECT_EQ(certificate.status, CertificateStatus::Certified) << place;
    const Place& passage = known.knowledge->environment->map.places[place];
    EXPECT_LE(crossing->before.position[passage.axis], passage.box.min()[passage.axis]);
    EXPECT_GE(crossing->behind.position[passage.axis], passage.box.max()[passage.axis]);
  }
  EXPECT_GE(crossings, 1);
}

INSTANTIATE_TEST_SUITE_P(Objects, Table1,
                         testing::Combine(testing::Values("paper-like", "tight"),
                                          testing::ValuesIn(test::shapes().begin(), test::shapes().end())),
                         [](const auto& parameter) {
                           return std::string(std::get<0>(parameter.param) == std::string("tight") ? "Tight_"
                                                                                                   : "PaperLike_") +
                                  std::get<1>(parameter.param);
                         });

TEST(ShapeGameRoutes, TheShortestWayTakesTheHolesOfThePaper) {
  const std::map<std::string, std::string> hole{
      {"circle", "P8"}, {"square", "P8"}, {"triangle", "P9"}, {"pentagon", "P9"}, {"star", "P8"}};
  for (const char* shape : test::shapes()) {
    const Names names = route(shape, "gt");
    ASSERT_EQ(names.size(), 5U) << shape;
    EXPECT_EQ(names[1], hole.at(shape)) << shape;
  }
}

TEST(ShapeGameRoutes, OfTheSameShapeByTheWideGap) {
  for (const auto& [shape, hole] :
       std::map<std::string, std::string>{{"circle", "P6"}, {"square", "P7"}, {"triangle", "P8"}, {"pentagon", "P9"}}) {
    EXPECT_EQ(route(shape, "gts1"), (Names{"P1", hole, "P2", "P5", "P3"})) << shape;
  }
  EXPECT_EQ(route("star", "gts1").at(3), "P5");
}

TEST(ShapeGameRoutes, CompatibleByTheWideGap) {
  for (const auto& [shape, hole] : std::map<std::string, std::string>{
           {"circle", "P7"}, {"square", "P9"}, {"triangle", "P9"}, {"pentagon", "P9"}, {"star", "P9"}}) {
    EXPECT_EQ(route(shape, "gts2"), (Names{"P1", hole, "P2", "P5", "P3"})) << shape;
  }
}

class EditedRoutes : public testing::Test {
 protected:
  const test::KnownGame& known = game("tight", "circle");
  SemanticEdits edits = *known.loaded.problem.scene.edits;

  Attributes& of(const char* name) {
    for (PlaceEdit& edit : edits.places) {
      if (edit.name == name) return edit.attributes;
    }
    throw std::runtime_error("no such place");
  }
};

TEST_F(EditedRoutes, AForbiddenPlaceIsAvoided) {
  ASSERT_EQ(route(known, "gt", edits).at(1), "P8");
  of("P8")["forbidden"] = true;
  const Names names = route(known, "gt", edits);
  ASSERT_EQ(names.size(), 5U);
  EXPECT_NE(names[1], "P8");
  of("P4")["forbidden"] = true;
  EXPECT_EQ(route(known, "gt", edits).at(3), "P5");
  of("P5")["forbidden"] = true;
  EXPECT_TRUE(route(known, "gt", edits).empty());
}

TEST_F(EditedRoutes, APreferredPlaceIsChosenAndADislikedOneIsNot) {
  for (const char* name : {"P1", "P2", "P3", "P5", "P6"}) of(name)["preference"] = 100.0;
  EXPECT_EQ(route(known, "gt", edits), (Names{"P1", "P6", "P2", "P5", "P3"}));
  of("P5")["preference"] = 0.01;
  EXPECT_EQ(route(known, "gt", edits).at(3), "P4");
}

TEST_F(EditedRoutes, AnEditedCompatibilityCounts) {
  ASSERT_EQ(route(known, "gts2", edits).at(1), "P7");
  of("P7")["compatibility"] = 0.0;
  EXPECT_NE(route(known, "gts2", edits).at(1), "P7");
}

TEST_F(EditedRoutes, WhatFailedCostsMore) {
  const SemanticModel semantics = known.semantics();
  LearntCosts learnt;
  const int hole = test::placeNamed(semantics, "P8");
  const auto& borders = known.knowledge->environment->map.borders;
  for (std::size_t b = 0; b < borders.size(); ++b) learnt.crossing[{hole, static_cast<int>(b)}] = 10.0;
  const Names names = route(known, "gt", edits, learnt);
  ASSERT_EQ(names.size(), 5U);
  EXPECT_NE(names[1], "P8");
}

/// The coarse plan of the circle by these rules, or the error.
Result<CoarsePlan> planBy(const StrategyRules& rules, const SemanticEdits& edits) {
  const test::KnownGame& known = game("tight", "circle");
  const Problem& problem = known.loaded.problem;
  const SemanticModel semantics = semanticsOf(problem, *known.knowledge, std::make_shared<const SemanticEdits>(edits));
  const auto parsed = parseRules(rules, semantics.table(), idsOf(makeLocalPlannerRegistry()));
  if (!parsed) return parsed.error();
  return makeCoarsePlan(known.knowledge->environment->map, semantics, *parsed, problem.start.position,
                        std::get<Pose>(problem.goal).position, {});
}

TEST(CoarsePlanByRules, ACostThatMeansNothingNamesTheRuleAndThePlace) {
  const SemanticEdits& edits = *game("tight", "circle").loaded.problem.scene.edits;
  const auto expectRefused = [&](const char* node, const char* edge, const char* rule, const char* reason) {
    StrategyRules rules = presetRules("gts");
    rules.node = node;
    rules.edge = edge;
    const auto plan = planBy(rules, edits);
    ASSERT_FALSE(plan.ok()) << edge;
    EXPECT_EQ(plan.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(plan.error().location), rule);
    EXPECT_NE(toString(plan.error().reason).find(reason), std::string::npos) << toString(plan.error().reason);
  };
  expectRefused("0", "-distance", "/rules/edge", "gives the negative cost -");
  expectRefused("0", "-distance", "/rules/edge", " in place P1");
  expectRefused("0", "1 / (place.complexity - place.complexity)", "/rules/edge", "divides by zero in place P1");
  expectRefused("1 - 2 * size", "distance", "/rules/node", "negative");
  expectRefused("size / 0", "distance", "/rules/node", "divides by zero between P");
  StrategyRules rounded = presetRules("gts");
  rounded.edge = "distance + 0.1 + 0.2 - 0.3 - distance";
  EXPECT_TRUE(planBy(rounded, edits).ok());
}

TEST(CoarsePlanByRules, WithoutAWayItNamesWhatIsClosed) {
  SemanticEdits edits = *game("tight", "circle").loaded.problem.scene.edits;
  StrategyRules rules = presetRules("gts");
  rules.edge = "if(place.complexity > 2, infinite, distance)";
  const auto plan = planBy(rules, edits);
  ASSERT_TRUE(plan.ok()) << toString(plan.error());
  EXPECT_TRUE(plan->nodes.empty());
  EXPECT_TRUE(plan->forbidden.empty());
  EXPECT_FALSE(plan->infiniteCost.empty());
  for (PlaceEdit& place : edits.places) place.attributes["forbidden"] = true;
  const auto model = game("tight", "circle").semantics();
  const int hole = test::placeNamed(model, "P2");
  PlaceEdit closed;
  closed.at = game("tight", "circle").knowledge->environment->map.places[static_cast<std::size_t>(hole)].anchor;
  closed.attributes["forbidden"] = true;
  edits.places.push_back(closed);
  const auto forbidden = planBy(presetRules("gts"), edits);
  ASSERT_TRUE(forbidden.ok());
  EXPECT_TRUE(forbidden->nodes.empty());
  EXPECT_THAT(forbidden->forbidden, testing::Contains("P2"));
  EXPECT_TRUE(forbidden->infiniteCost.empty());
}

}  // namespace
}  // namespace glissade
