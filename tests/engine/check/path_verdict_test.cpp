#include "engine/check/path_verdict.h"

#include <gtest/gtest.h>

#include "engine/base/tolerances.h"
#include "engine/check/plan_verdict.h"
#include "tests/engine/check/check_bodies.h"
#include "tests/engine/support/forbidden_boxes.h"

namespace glissade::check {
namespace {

/// A knob with twelve sides that leaves upwards through a lip, which overlaps it by less than 0.8 mm.
Question knobUnderItsLip() {
  Question question;
  question.product.bodies = {test::checkBody("lip", test::holedPlate(12, 0.0192, 0.04, 0.015, 0.03)),
                             test::checkBody("knob", test::prism(12, 0.02, 0.02))};
  question.product.fits.on = true;
  question.goal = Pose::translation({0.0, 0.0, 0.1});
  question.workspace = Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0));
  question.requiredClearance = 2e-7;
  question.contactGap = 2e-5;
  return question;
}

Path straightUp(std::optional<double> allowance) {
  Path path;
  path.points = {{Pose::identity()}, {Pose::translation({0.0, 0.0, 0.1})}};
  path.allowances.emplace();
  if (allowance) path.allowances->push_back({"knob", "lip", *allowance});
  return path;
}

TEST(PathVerdict, AnInventedAllowanceIsRefusedWithThePairAndBothNumbers) {
  const Question question = knobUnderItsLip();
  const PathVerdict verdict = judgePath(question, straightUp(0.0012));
  EXPECT_FALSE(verdict.valid());
  ASSERT_EQ(verdict.refusals.size(), 1U);
  for (const char* part : {"'knob'", "'lip'", "1.2 mm", "0.77", "overlap", "allow it for this pair"}) {
    const std::string refusal = toString(verdict.refusals[0]);
    EXPECT_NE(refusal.find(part), std::string::npos) << part << ": " << refusal;
  }
}

TEST(PathVerdict, WhatTheFileSaysIsApplied) {
  const Question question = knobUnderItsLip();
  for (const std::optional<double> small : {std::optional<double>(), std::optional(0.0), std::optional(1e-9)}) {
    const PathVerdict verdict = judgePath(question, straightUp(small));
    EXPECT_TRUE(verdict.refusals.empty());
    EXPECT_EQ(verdict.motion.verdict.status, Status::Violated) << "the knob is caught under the lip";
  }
}

TEST(PathVerdict, FitsThatAreOffAllowNothing) {
  Question question = knobUnderItsLip();
  question.product.fits.on = false;
  const PathVerdict verdict = judgePath(question, straightUp(1e-4));
  EXPECT_EQ(verdict.refusals.size(), 1U);
  EXPECT_NE(verdict.motion.verdict.status, Status::Certified);
}

TEST(PathVerdict, APathOfColumnsHasTheAllowancesThatTheJudgeFinds) {
  const Question question = knobUnderItsLip();
  Path path = straightUp(std::nullopt);
  path.allowances.reset();
  const PathVerdict verdict = judgePath(question, path);
  ASSERT_EQ(verdict.allowances.size(), 2U) << "both give way where one is below a part of a face";
  for (const AppliedAllowance& each : verdict.allowances) {
    EXPECT_FALSE(each.stated);
    EXPECT_LE(each.applied, each.most);
    EXPECT_GT(each.applied, 0.00076);
  }
}

TEST(PathVerdict, EndsAndAllowancesOfOtherBodiesAreSeen) {
  Question question = knobUnderItsLip();
  Path path = straightUp(std::nullopt);
  path.allowances->push_back({"knob", "nobody", 1e-6});
  path.points.back().q.position.z() = 0.05;
  const PathVerdict verdict = judgePath(question, path);
  EXPECT_EQ(verdict.refusals.size(), 1U);
  EXPECT_TRUE(verdict.beginsAtStart);
  EXPECT_FALSE(verdict.endsAtGoal);
  question.workspace = Box3(Vector3::Constant(-0.01), Vector3::Constant(0.01));
  question.goal.reset();
  EXPECT_EQ(judgePath(question, path).outside, std::optional<std::size_t>(1));
}

TEST(PathVerdict, NothingMeetsWhatAPersonForbids) {
  constexpr double kMargin = 1e-4;
  const std::vector<ForbiddenRegion> regions{{"P5", {Box3(Vector3(0, 0, 0), Vector3(1, 1, 1))}}};
  const auto meets = [&](const Vector3& from, const Vector3& to) {
    return firstForbidden({Pose::translation(from), Pose::translation(to)}, regions, kMargin).has_value();
  };
  EXPECT_TRUE(meets({-1, 0.5, 0.5}, {2, 0.5, 0.5}));
  EXPECT_TRUE(meets({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}));
  EXPECT_TRUE(meets({-0.5, 0.49, 0.5}, {0.51, 1.5, 0.5}));
  EXPECT_TRUE(meets({-1, 0, 0.5}, {2, 0, 0.5})) << "along a face";
  EXPECT_TRUE(meets({-1, 1, 0.5}, {1, -1, 0.5})) << "through an edge";
  EXPECT_TRUE(meets({0, 2, 1}, {2, 0, 1})) << "through a corner";
  EXPECT_TRUE(meets({-1, 0.5, 0.5}, {-0.99 * kMargin, 0.5, 0.5}));
  EXPECT_FALSE(meets({-1, 0.5, 0.5}, {-1.01 * kMargin, 0.5, 0.5}));
  EXPECT_FALSE(meets({-1, 1.1, 0.5}, {2, 1.1, 0.5}));
  RandomStream stream(1, "segments");
  for (int i = 0; i < 4000; ++i) {
    const Box3 box = glissade::test::latticeBox(stream, 3);
    const Vector3 from = glissade::test::latticePoint(stream, 3);
    const Vector3 to = glissade::test::latticePoint(stream, 3);
    EXPECT_EQ(firstForbidden({Pose::translation(from), Pose::translation(to)}, {{"P", {box}}}, kMargin).has_value(),
              glissade::test::meetsBox(from, to, box, kMargin));
  }
  const auto found =
      firstForbidden({Pose::translation({3, 3, 3}), Pose::translation({2, 2, 2}), Pose::identity()}, regions, kMargin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edge, 1U);
  EXPECT_EQ(found->place, "P5");
}

TEST(PathVerdict, AForbiddenPlaceThatIsNotKnownIsNotPassedOver) {
  Question question = knobUnderItsLip();
  const Path path = straightUp(std::nullopt);
  question.product.forbidsPlaces = true;
  const PathVerdict unknown = judgePath(question, path);
  ASSERT_FALSE(unknown.refusals.empty());
  EXPECT_NE(toString(unknown.refusals.front()).find("forbids places"), std::string::npos);
  EXPECT_TRUE(unknown.refused());
  question.forbidden = {{"P1", {Box3(Vector3::Constant(5.0), Vector3::Constant(6.0))}}};
  const PathVerdict known = judgePath(question, path);
  EXPECT_TRUE(known.refusals.empty());
  EXPECT_DOUBLE_EQ(known.forbiddenMargin, tolerance::kForbiddenMargin * radiusAboutOrigin(*question.object().mesh));
}

TEST(PlanClaims, EachIsComparedWithTheSteps) {
  Product product;
  product.bodies = {test::checkBody("box", makeBox({1, 1, 1})),
                    test::checkBody("lid", makeBox({1, 1, 1}), {0, 0, 1.1})};
  Plan plan;
  plan.bodies = {"box", "lid"};
  plan.staying = {"box"};
  plan.steps.push_back({{"lid"}, {{Pose::translation({0, 0, 1.1})}, {Pose::translation({0, 0, 5})}}, {}, {}, {}, true});
  plan.end = "complete";
  plan.parts = plan.removed = 1;
  EXPECT_TRUE(judgePlan(product, plan, 1e-4).valid());
  const auto refusals = [&](const auto& change) {
    Plan wrong = plan;
    change(wrong);
    const PlanVerdict verdict = judgePlan(product, wrong, 1e-4);
    EXPECT_FALSE(verdict.valid());
    return verdict.refusals.size();
  };
  EXPECT_EQ(refusals([](Plan& p) { p.steps.clear(); }), 2U) << "removed, and complete";
  EXPECT_EQ(refusals([](Plan& p) { p.removed = 7; }), 1U);
  EXPECT_EQ(refusals([](Plan& p) { p.parts = 2; }), 1U);
  EXPECT_EQ(refusals([](Plan& p) { p.certified = false; }), 1U);
  EXPECT_EQ(refusals([](Plan& p) { p.bodies.emplace_back("ghost"); }), 3U) << "ghost, parts, and complete";
  EXPECT_EQ(refusals([](Plan& p) { p.bodies = {"box", "lid", "lid"}; }), 3U);
  EXPECT_GE(refusals([](Plan& p) {
              p.staying = {"box", "lid"};
              p.steps.clear();
              p.parts = p.removed = 0;
            }),
            1U)
      << "all stay";
  const auto stepRefusals = [&](const auto& change) {
    Plan wrong = plan;
    change(wrong);
    const PlanVerdict verdict = judgePlan(product, wrong, 1e-4);
    EXPECT_FALSE(verdict.valid());
    return verdict.steps.back().refusals.size();
  };
  EXPECT_EQ(stepRefusals([](Plan& p) { p.steps[0].bodies = {"nobody"}; }), 1U);
  EXPECT_EQ(stepRefusals([](Plan& p) { p.steps[0].bodies = {"box"}; }), 1U);
  EXPECT_EQ(stepRefusals([](Plan& p) { p.steps[0].after = {1}; }), 1U);
  EXPECT_EQ(stepRefusals([](Plan& p) { p.steps[0].certified = false; }), 1U);
  EXPECT_EQ(stepRefusals([](Plan& p) { p.steps.push_back(p.steps[0]); }), 1U) << "it has left before";
}

}  // namespace
}  // namespace glissade::check
