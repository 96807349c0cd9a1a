// The layers of the second paper and samplers from outside, as a program sees them: public headers only.
#include <glissade/glissade.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "tests/engine/api/values.h"

namespace {

namespace g = glissade;
using glissade::ErrorKind;
using glissade::test::at;
using glissade::test::kNan;

g::Body beam(const std::string& id, const g::Vector3& edges, const g::Vector3& middle) {
  return {id, "", *g::Mesh::box(edges), {middle, g::Quaternion::Identity()}};
}

/// A wall with a small and a large window, and the object on one side of it.
g::Problem windows() {
  const auto world =
      g::World::make({beam("below", {0.2, 4, 1.5}, {0, 0, -1.25}), beam("above", {0.2, 4, 1.5}, {0, 0, 1.25}),
                      beam("left", {0.2, 0.8, 1}, {0, -1.6, 0}), beam("post", {0.2, 1.2, 1}, {0, 0.1, 0}),
                      beam("right", {0.2, 0.6, 1}, {0, 1.7, 0})},
                     *g::Mesh::box({0.2, 0.2, 0.2}));
  return *g::Problem::make(*world, at(-1.5, 0.7, 0), at(1.5, 0.7, 0), g::Box{{-2, -2, -2}, {2, 2, 2}});
}

g::Layers layers() {
  static const g::Layers made = *g::Layers::make(windows(), {.cellSize = 0.1, .topologyLevel = 5});
  return made;
}

std::vector<std::string> namesOf(const g::CoarsePlan& plan) {
  std::vector<std::string> names;
  for (const g::CoarseStep& step : plan.steps) names.push_back(step.placeName);
  return names;
}

std::size_t passageOn(const g::CoarsePlan& plan, const std::vector<g::Place>& places) {
  const auto step = std::find_if(plan.steps.begin(), plan.steps.end(),
                                 [&](const g::CoarseStep& each) { return places[each.place].passage; });
  EXPECT_NE(step, plan.steps.end());
  return step->place;
}

TEST(Layers, CellsPlacesAndBordersFitTogether) {
  const g::OctreeCells cells = layers().cells();
  ASSERT_EQ(cells.centres.size(), cells.sizes.size());
  ASSERT_EQ(cells.kinds.size(), cells.sizes.size());
  double volume = 0.0;
  for (const double size : cells.sizes) volume += std::pow(size, 3);
  EXPECT_NEAR(volume, 64.0, 1e-9);
  EXPECT_TRUE(std::count(cells.kinds.begin(), cells.kinds.end(), g::CellKind::Static) > 0);
  const auto places = layers().places();
  ASSERT_GE(places.size(), 4U);
  EXPECT_EQ(std::count_if(places.begin(), places.end(), [](const g::Place& place) { return place.passage; }), 2);
  for (const g::Place& place : places) {
    double covered = 0.0;
    for (const g::Box& box : place.boxes) covered += (box.upper - box.lower).prod();
    EXPECT_NEAR(covered, place.volume, 1e-9) << place.name;
    EXPECT_EQ(std::get<double>(place.attributes.at("complexity")), place.complexity);
  }
  const auto borders = layers().borders();
  ASSERT_FALSE(borders.empty());
  for (const g::Border& border : borders) EXPECT_LT(std::max(border.places[0], border.places[1]), places.size());
}

TEST(Layers, TheCoarsePlanIsTheCheapestWayOfItsGraph) {
  const auto plan = layers().coarsePlan("gt");
  ASSERT_TRUE(plan) << plan.error().text();
  ASSERT_GE(plan->nodes.size(), 3U);
  EXPECT_EQ(plan->graph.nodes[plan->nodes.front()].name, "S");
  EXPECT_EQ(plan->graph.nodes[plan->nodes.back()].name, "G");
  EXPECT_EQ(plan->steps.size() + 1, plan->nodes.size());
  EXPECT_FALSE(plan->steps.back().border);
  EXPECT_TRUE(plan->steps.back().decided);
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < plan->nodes.size(); ++i) {
    const auto edge = std::find_if(plan->graph.edges.begin(), plan->graph.edges.end(), [&](const auto& each) {
      return each.from == plan->nodes[i] && each.to == plan->nodes[i + 1];
    });
    ASSERT_NE(edge, plan->graph.edges.end());
    cost += edge->cost + plan->graph.nodes[plan->nodes[i + 1]].cost;
  }
  EXPECT_NEAR(cost, plan->cost, 1e-9);
}

TEST(Layers, AChangedAttributeChangesTheCoarsePlanAndTheRun) {
  const auto before = *layers().coarsePlan("gt");
  const std::size_t window = passageOn(before, layers().places());
  const g::Layers changed = *layers().withPlaceValue(window, "forbidden", true);
  EXPECT_EQ(std::get<bool>(changed.places()[window].attributes.at("forbidden")), true);
  EXPECT_EQ(std::get<bool>(layers().places()[window].attributes.at("forbidden")), false);
  const auto after = *changed.coarsePlan("gt");
  EXPECT_NE(namesOf(after), namesOf(before));

  const g::Run run = g::plan(changed.problem(), {.strategy = "gts", .seed = 1});
  ASSERT_TRUE(run.path) << run.path.error().text();
  EXPECT_TRUE(g::check(changed.problem(), *run.path)->valid());
  const g::Run through = g::plan(layers().problem(), {.strategy = "gts", .seed = 1});
  ASSERT_TRUE(through.path);
  EXPECT_TRUE(g::check(layers().problem(), *through.path)->valid());
  EXPECT_EQ(g::check(changed.problem(), *through.path)->kind, g::VerdictKind::Invalid);
}

TEST(Layers, AnAttributeAndARuleFromOutsideDecideTheWay) {
  const auto before = *layers().coarsePlan("gt");
  const std::size_t window = passageOn(before, layers().places());
  const std::string name = layers().places()[window].name;
  const auto risk = [&](const g::Place& place) { return place.name == name ? 1.0 : 0.0; };
  const auto known = layers().withAttribute({.name = "risk", .minimum = 0.0, .maximum = 1.0}, risk);
  ASSERT_TRUE(known) << known.error().text();
  EXPECT_EQ(std::get<double>(known->places()[window].attributes.at("risk")), 1.0);
  const auto ruled = known->withRules({.edge = "distance * (1 + 100 * place.risk)"});
  ASSERT_TRUE(ruled) << ruled.error().text();
  EXPECT_EQ(ruled->rules("own")->edge, "distance * (1 + 100 * place.risk)");
  const auto after = *ruled->coarsePlan("own");
  EXPECT_NE(namesOf(after), namesOf(before));
  const g::Run run = g::plan(ruled->problem(), {.strategy = "own", .seed = 1});
  ASSERT_TRUE(run.path) << run.path.error().text();
  EXPECT_TRUE(run.path->certificate().certified());
}

TEST(Layers, BodiesOfAWorldAreStaticAndMobileOnesShapeNoPlaces) {
  EXPECT_EQ(std::get<std::string>(layers().ofBody("post")->at("mobility")), "static");
  const auto mobile = layers().withBodyValue("post", "mobility", std::string("mobile"));
  ASSERT_TRUE(mobile) << mobile.error().text();
  EXPECT_EQ(std::get<std::string>(mobile->ofBody("post")->at("mobility")), "mobile");
  const auto kinds = mobile->cells().kinds;
  EXPECT_GT(std::count(kinds.begin(), kinds.end(), g::CellKind::Mobile), 0);
  EXPECT_NE(mobile->places().size(), layers().places().size());
}

TEST(Layers, WrongArgumentsAreRefused) {
  EXPECT_EQ(g::Layers::make(windows(), {.cellSize = kNan}).error().kind, ErrorKind::MalformedInput);
  EXPECT_FALSE(g::Layers::make(windows(), {.cellSize = -1}));
  EXPECT_FALSE(g::Layers::make(windows(), {.memory = kNan}));
  EXPECT_FALSE(g::Layers::make(windows(), {.topologyLevel = 99}));
  EXPECT_FALSE(g::Layers::make(windows(), {.identifier = "nonsense"}));
  glissade::StopSource source;
  source.requestStop();
  EXPECT_EQ(g::Layers::make(windows(), {.stop = source.token()}).error().kind, ErrorKind::Interrupted);

  EXPECT_EQ(layers().withPlaceValue(999, "forbidden", true).error().kind, ErrorKind::Usage);
  EXPECT_FALSE(layers().withPlaceValue(0, "nonsense", true));
  EXPECT_FALSE(layers().withPlaceValue(0, "forbidden", 1.0));
  EXPECT_FALSE(layers().withPlaceValue(0, "preference", kNan));
  EXPECT_FALSE(layers().withPlaceValue(0, "preference", -1.0));
  EXPECT_FALSE(layers().ofBody("nobody"));
  EXPECT_FALSE(layers().withBodyValue("nobody", "mobility", std::string("mobile")));
  EXPECT_FALSE(layers().withBodyValue("post", "mobility", std::string("tired")));

  EXPECT_FALSE(layers().withAttribute({.name = "Not a word"}));
  EXPECT_FALSE(layers().withAttribute({.name = "forbidden"}));
  EXPECT_FALSE(layers().withAttribute({.name = "risk", .initial = kNan}));
  for (const g::AttributeValue& wrong : {g::AttributeValue(kNan), g::AttributeValue(2.0), g::AttributeValue(true)}) {
    const auto risk = [&](const g::Place&) { return wrong; };
    const auto refused = layers().withAttribute({.name = "risk", .minimum = 0.0, .maximum = 1.0}, risk);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("place P1"), std::string::npos) << refused.error().text();
  }
  const auto throws = [](const g::Place&) -> g::AttributeValue { throw std::runtime_error("no idea"); };
  EXPECT_FALSE(layers().withAttribute({.name = "risk"}, throws));

  EXPECT_FALSE(layers().withRules({.edge = "distance +"}));
  EXPECT_FALSE(layers().withRules({.edge = "place.nonsense"}));
  EXPECT_FALSE(layers().withRules({.fine = {}}));
  EXPECT_FALSE(layers().withRules({.fine = {{"1", false, "nonsense"}}}));
  EXPECT_FALSE(layers().withRules({.edge = "0 - distance"})->coarsePlan("own"));
  EXPECT_EQ(layers().rules("birrt").error().kind, ErrorKind::Usage);
  EXPECT_EQ(layers().coarsePlan("nonsense").error().kind, ErrorKind::Usage);
}

/// Draws near the middle of the larger window only.
g::DrawFunction nearTheWindow(const g::Problem& problem, std::uint64_t seed) {
  const auto random = std::make_shared<std::mt19937_64>(seed);
  return [random, from = problem.start()] {
    std::normal_distribution<double> spread(0.0, 0.3);
    g::Pose drawn = from;
    for (int axis = 0; axis < 3; ++axis) drawn.position[axis] = std::clamp(spread(*random), -2.0, 2.0);
    drawn.position.y() = std::clamp(1.0 + drawn.position.y(), -2.0, 2.0);
    return drawn;
  };
}

TEST(Sampler, ASamplerFromOutsideDrawsForEveryPlanner) {
  for (const char* strategy : {"birrt", "g", "auto", "ompl-rrtconnect"}) {
    const g::PlanOptions options{.strategy = strategy, .seed = 1, .sampler = nearTheWindow};
    const g::Run run = g::plan(windows(), options);
    ASSERT_TRUE(run.path) << strategy << ": " << run.path.error().text();
    EXPECT_TRUE(g::check(windows(), *run.path)->valid()) << strategy;
    const g::Run again = g::plan(windows(), options);
    EXPECT_EQ(again.counts.randomConfigurations, run.counts.randomConfigurations) << strategy;
    EXPECT_EQ(again.path->length(), run.path->length()) << strategy;
  }
  // The path shows the draws of the sampler: they have no turn, and so has the path.
  const g::Run run = g::plan(windows(), {.strategy = "birrt", .seed = 1, .sampler = nearTheWindow});
  EXPECT_LT(run.path->rotation(), 1e-9);
}

TEST(Sampler, AWrongDrawIsADiagnostic) {
  using Draw = g::DrawFunction;
  const std::pair<Draw, const char*> wrongs[] = {
      {[] { return at(kNan, 0, 0); }, "not finite"},
      {[] { return at(7, 0, 0); }, "outside of the bounds"},
      {[]() -> g::Pose { throw std::runtime_error("no idea"); }, "no idea"},
      {Draw(), "made no function"},
  };
  for (const char* strategy : {"birrt", "g", "auto", "ompl-rrtconnect"}) {
    for (const auto& [draw, reason] : wrongs) {
      const auto sampler = [&draw = draw](const g::Problem&, std::uint64_t) { return draw; };
      const g::Run run = g::plan(windows(), {.strategy = strategy, .sampler = sampler});
      ASSERT_FALSE(run.path) << strategy;
      EXPECT_NE(run.path.error().text().find(reason), std::string::npos) << strategy << ": " << run.path.error().text();
      const bool isThrown = std::string(reason) == "no idea";
      EXPECT_EQ(run.path.error().kind, isThrown ? ErrorKind::Internal : ErrorKind::Usage);
      g::Session session = *g::Session::make(windows(), {.strategy = strategy, .sampler = sampler});
      EXPECT_EQ(session.step(1000), g::SessionState::Ended) << strategy;
    }
  }
}

}  // namespace
