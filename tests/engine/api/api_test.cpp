// The public library as a program sees it: public headers only.
#include <glissade/glissade.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "tests/engine/api/values.h"
#include "tests/engine/support/directories.h"

namespace {

namespace g = glissade;
using glissade::ErrorKind;
using glissade::test::at;
using glissade::test::kNan;

std::string sample(const std::string& file) { return glissade::test::sourceDirectory() + "/samples/" + file; }

g::Mesh cube(double edge) { return *g::Mesh::box({edge, edge, edge}); }

/// A cube that has to get past another one.
g::World world() { return *g::World::make({{"wall", "", cube(0.4), {}}}, cube(0.1)); }

g::Problem problem() { return *g::Problem::make(world(), at(-1, 0, 0), at(1, 0, 0), g::Box{{-2, -2, -2}, {2, 2, 2}}); }

TEST(Api, AScenarioIsPlannedAndCheckedAsByTheCommandLine) {
  const auto scenario = g::load<g::Scenario>(sample("environment-1/scenario.json"));
  ASSERT_TRUE(scenario) << scenario.error().text();
  const g::Run run = g::plan(*scenario, {.seed = 1, .operatorName = "expert"});
  ASSERT_TRUE(run.path) << run.path.error().text();
  EXPECT_TRUE(run.path->certificate().certified());
  EXPECT_GT(run.counts.randomConfigurations, 0U);
  const auto verdict = g::check(*scenario, *run.path);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->valid()) << verdict->text;
  const g::Run again = g::plan(*scenario, {.seed = 1, .operatorName = "expert"});
  ASSERT_TRUE(again.path);
  EXPECT_EQ(again.path->length(), run.path->length());
}

TEST(Api, AProblemOfArraysIsPlannedAndChecked) {
  const g::Run run = g::plan(problem(), {.strategy = "birrt"});
  ASSERT_TRUE(run.path) << run.path.error().text();
  const auto verdict = g::check(problem(), *run.path);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->valid()) << verdict->text;
  const auto straight = g::Path::make({at(-1, 0, 0), at(1, 0, 0)});
  EXPECT_EQ(g::check(problem(), *straight)->kind, g::VerdictKind::Invalid);
  const auto curve = g::clearance(world(), *run.path, {.samples = 20});
  ASSERT_TRUE(curve);
  EXPECT_GE(curve->size(), run.path->configurations().size());
  const auto swept = g::sweep(cube(0.1), run.path->configurations(), {.bound = 0.05});
  ASSERT_TRUE(swept) << swept.error().text();
  EXPECT_TRUE(swept->surface.isClosed());
}

TEST(Api, AProductIsTakenApart) {
  const auto product = g::load<g::Product>(sample("bolted-brackets/scenario.json"));
  ASSERT_TRUE(product) << product.error().text();
  EXPECT_FALSE(g::fits(*product)->empty());
  EXPECT_FALSE(g::joints(*product)->empty());
  std::size_t found = 0;
  const auto plan = g::sequence(*product, {.progress = [&](const g::AssemblyPlan& so) { found = so.steps().size(); }});
  ASSERT_TRUE(plan) << plan.error().text();
  EXPECT_EQ(plan->end(), g::PlanEnd::Complete);
  std::size_t motions = 0;
  for (const g::Step& step : plan->steps()) motions += step.motions.size();
  EXPECT_EQ(found, motions) << "a plan that grows has a step for each motion";
  EXPECT_EQ(plan->removed(), plan->parts());
  const auto verdict = g::check(*product, *plan);
  ASSERT_TRUE(verdict);
  EXPECT_TRUE(verdict->valid()) << verdict->text;
}

/// The judge has to read the file with the same deflection.
TEST(Api, APlanStatesTheDeflectionOfItsProduct) {
  const std::string file = glissade::test::stepFileDirectory() + "/bolt-in-plate.step";
  const auto product = g::load<g::Product>(file, {.deflection = 2e-5});
  ASSERT_TRUE(product) << product.error().text();
  const auto plan = g::sequence(*product);
  ASSERT_TRUE(plan) << plan.error().text();
  EXPECT_NE(plan->json(file).find("\"deflection_m\": 2e-05"), std::string::npos);
}

TEST(Api, APlannerFromOutsideIsCertified) {
  g::Planners planners;
  std::vector<g::Pose> way;
  const auto shows = [&](g::PlannerContext&) { return way; };
  ASSERT_TRUE(planners.add("mine", shows));
  EXPECT_FALSE(planners.add("mine", shows));
  EXPECT_FALSE(planners.add("birrt", shows));
  EXPECT_FALSE(planners.add("", shows));
  EXPECT_FALSE(planners.add("none", {}));
  const auto run = [&](std::vector<g::Pose> shown) {
    way = std::move(shown);
    return g::plan(problem(), {.strategy = "mine", .planners = &planners}).path;
  };
  const auto around = run({at(-1, 0, 0), at(0, 0, 1), at(1, 0, 0)});
  ASSERT_TRUE(around) << around.error().text();
  EXPECT_TRUE(around->certificate().certified());
  for (const auto& wrong : std::vector<std::vector<g::Pose>>{{},
                                                             {at(-1, 0, 0), at(1, 0, 0)},
                                                             {at(-1, 0, 1), at(1, 0, 0)},
                                                             {at(-1, 0, 0), at(0, 0, 1)},
                                                             {at(-1, 0, 0), at(kNan, 0, 0)}}) {
    const auto refused = run(wrong);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::NoPath) << refused.error().text();
  }
}

TEST(Api, ASessionGoesOnStepByStepAsAWholeRunDoes) {
  const auto scenario = g::load<g::Scenario>(sample("environment-1/scenario.json"));
  const g::PlanOptions options{.strategy = "contact-birrt", .seed = 3, .operatorName = "expert"};
  const g::Run whole = g::plan(*scenario, options);
  ASSERT_TRUE(whole.path);
  g::Session session = *g::Session::make(*scenario, options);
  EXPECT_FALSE(session.path());
  std::uint64_t steps = 0;
  while (session.step(7) == g::SessionState::Running) {
    ASSERT_EQ(session.counts().steps, steps += 7);
    ASSERT_EQ(session.counts().nodes, session.roadmap().nodes.size());
  }
  ASSERT_EQ(session.state(), g::SessionState::Solved);
  EXPECT_FALSE(session.failure());
  EXPECT_EQ(session.counts().steps, whole.counts.steps);
  EXPECT_EQ(session.path()->length(), whole.path->length());
  const g::Roadmap roadmap = session.roadmap();
  EXPECT_EQ(roadmap.nodes.front().position, scenario->problem().start().position);
  EXPECT_EQ(roadmap.authors.size(), roadmap.nodes.size());
  EXPECT_EQ(roadmap.trees.size(), roadmap.nodes.size());
  EXPECT_NE(std::count(roadmap.authors.begin(), roadmap.authors.end(), g::Author::Operator), 0);
  for (const auto& [from, to] : roadmap.edges) ASSERT_LT(std::max(from, to), roadmap.nodes.size());
}

TEST(Api, ParametersOfASessionChangeBetweenItsSteps) {
  const auto scenario = g::load<g::Scenario>(sample("environment-1/scenario.json"));
  const g::PlanOptions options{.strategy = "contact-birrt", .operatorName = "expert", .parameters = {{"alpha", 1.0}}};
  g::Session session = *g::Session::make(*scenario, options);
  session.step(50);
  const auto ofOperator = [&] {
    const g::Roadmap roadmap = session.roadmap();
    return std::count(roadmap.authors.begin(), roadmap.authors.end(), g::Author::Operator);
  };
  ASSERT_EQ(ofOperator(), 0) << "at 1 the computer draws all";
  EXPECT_FALSE(session.set({{"alpha", 0.0}, {"nonsense", 1.0}}));
  EXPECT_FALSE(session.set({{"alpha", kNan}}));
  EXPECT_EQ(session.parameters()["alpha"], 1.0);
  ASSERT_TRUE(session.set({{"alpha", 0.0}}));
  EXPECT_EQ(session.parameters()["alpha"], 0.0);
  session.step(200);
  EXPECT_GT(ofOperator(), 0);
}

TEST(Api, AnOperatorFromOutsideMovesTheObject) {
  const g::PlanOptions still{.strategy = "contact-birrt",
                             .operatorFunction = [](const g::HandView& view) { return view.hand; },
                             .parameters = {{"alpha", 0.0}}};
  g::Session session = *g::Session::make(problem(), still);
  session.step(100);
  EXPECT_EQ(session.hand().position, at(-1, 0, 0).position);
  // Over the wall, at half a metre a second.
  const auto leads = [](const g::HandView& view) {
    g::Pose next = view.hand;
    const bool isBefore = next.position.x() < 0.9;
    const double height = isBefore ? 0.5 : 0.0;
    const g::Vector3 to = std::abs(next.position.z() - height) > 0.01 && (isBefore || next.position.x() >= 0.9)
                              ? g::Vector3(next.position.x(), 0.0, height)
                              : g::Vector3(1.0, 0.0, height);
    const g::Vector3 way = to - next.position;
    next.position += std::min(1.0, 0.5 * view.seconds / std::max(1e-9, way.norm())) * way;
    return next;
  };
  g::PlanOptions led = still;
  led.operatorFunction = leads;
  const g::Run run = g::plan(problem(), led);
  ASSERT_TRUE(run.path) << run.path.error().text();
  EXPECT_TRUE(run.path->certificate().certified());
}

TEST(Api, AnOperatorFromOutsideThatFailsIsADiagnostic) {
  const g::OperatorFunction lost = [](const g::HandView&) { return at(kNan, 0, 0); };
  const g::OperatorFunction throws = [](const g::HandView&) -> g::Pose { throw std::runtime_error("no idea"); };
  for (const auto& [wrong, reason] : {std::pair{lost, "not finite"}, std::pair{throws, "no idea"}}) {
    const g::PlanOptions options{
        .strategy = "contact-birrt", .operatorFunction = wrong, .parameters = {{"alpha", 0.5}}};
    const g::Run run = g::plan(problem(), options);
    ASSERT_FALSE(run.path);
    EXPECT_NE(run.path.error().text().find(reason), std::string::npos) << run.path.error().text();
    g::Session session = *g::Session::make(problem(), options);
    EXPECT_EQ(session.step(100), g::SessionState::Ended);
    EXPECT_NE(session.failure()->text().find(reason), std::string::npos);
  }
}

TEST(Api, WrongSessionsAreRefused) {
  g::Planners planners;
  ASSERT_TRUE(planners.add("mine", [](g::PlannerContext&) { return std::vector<g::Pose>(); }));
  EXPECT_FALSE(g::Session::make(problem(), {.strategy = "mine", .planners = &planners}));
  EXPECT_FALSE(g::Session::make(problem(), {.strategy = "nonsense"}));
  EXPECT_FALSE(g::Session::make(problem(), {.operatorName = "nobody"}));
  EXPECT_FALSE(g::Session::make(problem(), {.parameters = {{"alpha", 2.0}}}));
  const auto inCollision = g::Problem::make(world(), at(0, 0, 0), at(1, 0, 0));
  g::Session ended = *g::Session::make(*inCollision);
  EXPECT_EQ(ended.step(10), g::SessionState::Ended);
  ASSERT_TRUE(ended.failure());
  EXPECT_EQ(ended.failure()->kind, ErrorKind::InCollision);
  g::StopSource stopped;
  stopped.requestStop();
  g::Session waiting = *g::Session::make(problem());
  EXPECT_EQ(waiting.step(1'000'000, stopped.token()), g::SessionState::Running);
}

TEST(Api, APlannerFromOutsideThatThrowsIsADiagnostic) {
  g::Planners planners;
  ASSERT_TRUE(
      planners.add("throws", [](g::PlannerContext&) -> std::vector<g::Pose> { throw std::runtime_error("no idea"); }));
  const g::Run run = g::plan(problem(), {.strategy = "throws", .planners = &planners});
  ASSERT_FALSE(run.path);
  EXPECT_NE(run.path.error().text().find("no idea"), std::string::npos) << run.path.error().text();
}

TEST(Api, APlannerFromOutsideEndsAtTheLimitOfSteps) {
  g::Planners planners;
  ASSERT_TRUE(planners.add("endless", [](g::PlannerContext& context) {
    while (context.step()) {
    }
    return std::vector<g::Pose>();
  }));
  const g::Run run =
      g::plan(problem(), {.strategy = "endless", .parameters = {{"max_steps", 500}}, .planners = &planners});
  ASSERT_FALSE(run.path);
  EXPECT_EQ(run.path.error().kind, ErrorKind::LimitReached) << run.path.error().text();
}

TEST(Api, WrongMeshesWorldsAndProblemsAreRefused) {
  using Vertices = std::vector<g::Vector3>;
  const Vertices corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(g::Mesh::make(corners, {{0, 1, 2}}));
  EXPECT_FALSE(g::Mesh::make(corners, {}));
  EXPECT_FALSE(g::Mesh::make({}, {}));
  EXPECT_FALSE(g::Mesh::make(corners, {{0, 1, 3}}));
  EXPECT_FALSE(g::Mesh::make(corners, {{0, 1, 1}}));
  EXPECT_FALSE(g::Mesh::make({{kNan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  EXPECT_FALSE(g::Mesh::make({{1e12, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  EXPECT_FALSE(g::Mesh::box({1, 0, 1}));
  EXPECT_FALSE(g::Mesh::box({1, kNan, 1}));

  EXPECT_TRUE(g::World::make({}, cube(1)));
  EXPECT_FALSE(g::World::make({{"", "", cube(1), {}}}, cube(1)));
  EXPECT_FALSE(g::World::make({{"a", "", cube(1), {}}, {"a", "", cube(1), {}}}, cube(1)));
  EXPECT_FALSE(g::World::make({{"a", "", cube(1), at(kNan, 0, 0)}}, cube(1)));
  EXPECT_FALSE(g::World::make({{"a", "", cube(1), {{0, 0, 0}, {2, 0, 0, 0}}}}, cube(1)));
  EXPECT_FALSE(g::Product::make({}));
  EXPECT_FALSE(g::Product::make({{"a", "", cube(1), {}}}));

  EXPECT_FALSE(g::Problem::make(world(), at(kNan, 0, 0), {}));
  EXPECT_FALSE(g::Problem::make(world(), at(0, 0, 0), at(0, kNan, 0)));
  EXPECT_FALSE(g::Problem::make(world(), at(0, 0, 0), {}, g::Box{{1, 1, 1}, {0, 0, 0}}));
  EXPECT_FALSE(g::Problem::make(world(), at(0, 0, 0), {}, {}, {{"alfa", 1}}));
  EXPECT_FALSE(g::Problem::make(world(), at(0, 0, 0), {}, {}, {{"alpha", kNan}}));
  EXPECT_FALSE(g::Path::make({}));
  EXPECT_FALSE(g::Path::make({at(0, kNan, 0)}));
}

TEST(Api, WrongQuestionsAreRefused) {
  g::Query query = world().query();
  EXPECT_TRUE(*query.collides(at(0, 0, 0)));
  EXPECT_NEAR(query.nearest(at(1, 0, 0))->distance, 0.75, 1e-9);
  EXPECT_TRUE(query.certify(at(-1, 0, 1), at(1, 0, 1), 1e-3)->certified());
  EXPECT_EQ(query.certify(at(-1, 0, 0), at(1, 0, 0), 1e-3)->status, g::ProofStatus::Violated);
  EXPECT_NEAR(*query.freeShare(at(-1, 0, 1), at(1, 0, 1), 0.01), 1.0, 1e-12);
  EXPECT_FALSE(query.collides(at(kNan, 0, 0)));
  EXPECT_FALSE(query.nearest(at(kNan, 0, 0)));
  EXPECT_FALSE(query.certify(at(kNan, 0, 0), at(0, 0, 0), 1));
  EXPECT_FALSE(query.certify(at(1, 0, 0), at(kNan, 0, 0), 1));
  EXPECT_FALSE(query.certify(at(1, 0, 0), at(1, 0, 0), 0));
  EXPECT_FALSE(query.certify(at(1, 0, 0), at(1, 0, 0), kNan));
  EXPECT_FALSE(query.freeShare(at(1, 0, 0), at(1, 0, 1), 0));
  EXPECT_FALSE(query.freeShare(at(0, 0, 0), at(1, 0, 1), 0.1));
}

TEST(Api, WrongOptionsAreRefused) {
  const auto errorOf = [](const g::PlanOptions& options) {
    const g::Run run = g::plan(problem(), options);
    return run.path ? ErrorKind::Internal : run.path.error().kind;
  };
  EXPECT_EQ(errorOf({.strategy = "nonsense"}), ErrorKind::Usage);
  EXPECT_EQ(errorOf({.operatorName = "nobody"}), ErrorKind::Usage);
  EXPECT_EQ(errorOf({.parameters = {{"alfa", 1}}}), ErrorKind::Usage);
  EXPECT_EQ(errorOf({.parameters = {{"alpha", 7}}}), ErrorKind::Usage);
  const auto path = *g::Path::make({at(-1, 0, 0)});
  EXPECT_FALSE(g::check(problem(), path, {.requiredClearance = 0}));
  EXPECT_FALSE(g::check(problem(), path, {.requiredClearance = kNan}));
  EXPECT_FALSE(g::sweep(cube(1), {}));
  EXPECT_FALSE(g::sweep(cube(1), {at(0, 0, 0)}, {.bound = 0}));
  EXPECT_FALSE(g::sweep(cube(1), {at(0, 0, 0)}, {.bound = kNan}));
  EXPECT_FALSE(g::sweep(cube(1), {at(0, kNan, 0)}));
  EXPECT_FALSE(g::clearance(world(), path, {.samples = 10'000'000'000}));
  const auto product = *g::Product::make({{"a", "", cube(1), {}}, {"b", "", cube(1), at(2, 0, 0)}});
  EXPECT_FALSE(g::fits(product, {.clearanceUpTo = kNan}));
  EXPECT_FALSE(g::fits(product, {.clashAbove = -1}));
  EXPECT_FALSE(g::sequence(product, {.strategy = "nonsense"}));
  EXPECT_FALSE(g::sequence(product, {.staying = {"nobody"}}));
  EXPECT_FALSE(g::sequence(product, {.timeLimit = kNan}));
  EXPECT_TRUE(g::sequence(product, {.threads = 1}));
}

TEST(Api, FilesThatDoNotExistAreNamed) {
  const std::string none = "/no/such/file.json";
  EXPECT_EQ(g::load<g::Scenario>(none).error().file, none);
  EXPECT_EQ(g::load<g::Product>(none).error().kind, ErrorKind::MalformedInput);
  EXPECT_FALSE(g::load<g::Product>("/no/such/file.step"));
  EXPECT_FALSE(g::load<g::Mesh>("/no/such/file.stl"));
  EXPECT_FALSE(g::load<g::Mesh>(""));
  EXPECT_FALSE(g::load<g::Path>(none));
  EXPECT_FALSE(g::load<g::AssemblyPlan>(none));
  EXPECT_FALSE(g::load<g::Product>(none, {.deflection = kNan}));
  EXPECT_FALSE(g::load<g::Scenario>(none, {.acceptedClash = -1}));
  EXPECT_FALSE(g::check(none, none));
  const auto scenario = *g::load<g::Scenario>(sample("environment-1/scenario.json"));
  const auto path = *g::Path::make({at(0, 0, 0)});
  EXPECT_FALSE(path.save("/no/such/folder/path.csv", scenario));
  EXPECT_EQ(path.save("path.nonsense", scenario).error().kind, ErrorKind::Usage);
}

TEST(Api, AStopEndsEveryFunction) {
  glissade::StopSource source;
  source.requestStop();
  const auto stop = source.token();
  EXPECT_EQ(g::plan(problem(), {.strategy = "birrt", .stop = stop}).path.error().kind, ErrorKind::Interrupted);
  const auto path = *g::Path::make({at(-1, 0, 0), at(0, 0, 1), at(1, 0, 0)});
  EXPECT_EQ(g::check(problem(), path, {.stop = stop})->kind, g::VerdictKind::Undecided);
  const auto blocked = *g::Path::make({at(-1, 0, 0), at(1, 0, 0)});
  EXPECT_EQ(g::check(problem(), blocked, {.stop = stop})->kind, g::VerdictKind::Undecided);
  EXPECT_FALSE(g::sweep(cube(1), path.configurations(), {.stop = stop}));
  EXPECT_FALSE(g::clearance(world(), path, {.stop = stop}));
  const auto product = *g::Product::make({{"a", "", cube(1), {}}, {"b", "", cube(1), at(1, 0, 0)}});
  EXPECT_FALSE(g::fits(product, {.stop = stop}));
  EXPECT_FALSE(g::joints(product, {.stop = stop}));
  EXPECT_FALSE(g::sequence(product, {.stop = stop}));
  EXPECT_FALSE(g::load<g::Product>(sample("bolted-brackets/scenario.json"), {.stop = stop}));
}

TEST(Api, TheVersionIsThatOfTheHeaders) { EXPECT_STREQ(g::libraryVersion(), GLISSADE_VERSION); }

}  // namespace
