#include "engine/files/plan_glb.h"

#include <gtest/gtest.h>

#include "tests/engine/files/glb_content.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using test::GlbContent;
using Elements = std::vector<std::vector<float>>;

AssemblyPlan planOfDrawer(const AssembledProduct& product) {
  AssemblyPlan plan;
  int axis = 0;
  for (const BodyId& id : std::vector<BodyId>{"cap", "pin", "drawer"}) {
    const Pose& start = product.bodies[product.indexOf(id)].X_WB;
    AssemblyStep step{{StepMotion()}};
    step.only().body = id;
    step.only().path = {{start, Author::Computer},
                        {{start.position + 3.0 * Vector3::Unit(axis++), start.orientation}, Author::Computer}};
    plan.steps.push_back(step);
  }
  return plan;
}

struct TranslationTrack {
  std::string node;
  Elements times;
  Elements positions;
};

std::vector<TranslationTrack> tracksOf(const GlbContent& glb) {
  std::vector<TranslationTrack> tracks;
  const auto& animation = glb.json["animations"][0];
  for (const auto& channel : animation["channels"]) {
    if (channel["target"]["path"] != "translation") continue;
    const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
    tracks.push_back({glb.json["nodes"][channel["target"]["node"].get<std::size_t>()]["name"],
                      glb.elements(sampler["input"]), glb.elements(sampler["output"])});
  }
  return tracks;
}

Vector3 vectorOf(const std::vector<float>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

TEST(PlanGlb, StepsFollowOneAnotherAndEndWhereTheirPathsEnd) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = planOfDrawer(product);
  for (const PlanOrder order : {PlanOrder::Removal, PlanOrder::Assembly}) {
    const auto bytes = planAsGlb(plan, product, order, "drawer");
    ASSERT_TRUE(bytes.ok());
    const GlbContent glb(*bytes);
    EXPECT_EQ(glb.json["nodes"].size(), product.bodies.size() + 1);
    const auto tracks = tracksOf(glb);
    ASSERT_EQ(tracks.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      const AssemblyStep& step = plan.steps[order == PlanOrder::Assembly ? 2 - i : i];
      EXPECT_EQ(tracks[i].node, step.only().body.text());
      for (std::size_t k = 1; k < tracks[i].times.size(); ++k) {
        EXPECT_GT(tracks[i].times[k][0], tracks[i].times[k - 1][0]);
      }
      EXPECT_NEAR(tracks[i].times.back()[0], 2.0 * static_cast<double>(i + 1), 1e-2);
      const Vector3 first = step.only().path.front().q.position;
      const Vector3 last = step.only().path.back().q.position;
      const bool assembly = order == PlanOrder::Assembly;
      EXPECT_LT((vectorOf(tracks[i].positions.front()) - (assembly ? last : first)).norm(), 1e-5);
      EXPECT_LT((vectorOf(tracks[i].positions.back()) - (assembly ? first : last)).norm(), 1e-5);
    }
  }
}

TEST(PlanGlb, APlanWithoutStepsIsAStillPicture) {
  const auto bytes = planAsGlb({}, test::chain(), PlanOrder::Removal, "chain");
  ASSERT_TRUE(bytes.ok());
  EXPECT_FALSE(GlbContent(*bytes).json.contains("animations"));
}

TEST(PlanGlb, AStepBeyondSinglePrecisionIsAnError) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = planOfDrawer(product);
  plan.steps[0].only().path.back().q.position.x() = 1e300;
  EXPECT_FALSE(planAsGlb(plan, product, PlanOrder::Removal, "drawer").ok());
}

}  // namespace
}  // namespace glissade
