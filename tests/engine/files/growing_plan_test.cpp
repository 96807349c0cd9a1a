#include <gtest/gtest.h>

#include "engine/files/judged_product.h"
#include "engine/files/plan_file.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/sequence/products.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

/// Keeps the plans that it receives.
class KeepingHost final : public SequenceHost {
 public:
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>&, int) override {}
  void stepFound(const AssemblyPlan& plan) override { plans.push_back(plan); }

  std::vector<AssemblyPlan> plans;

 private:
  ThreadTeam team_{0};
  StopToken stop_;
};

TEST(GrowingPlan, CanBeSavedReadAndProvedAtAnyStep) {
  const AssembledProduct product = test::lockedDrawer();
  SequenceDemands demands;
  demands.before = {{"cap", "pin"}};
  KeepingHost host;
  const test::TemporaryFolder folder;
  const std::string file = folder / "growing.json";
  BodySet staying(product.bodies.size(), false);
  staying[product.indexOf("cabinet")] = true;
  const auto plan = planSequence(product, test::fitsOf(product), {staying, "best-first", 3, demands}, host);
  ASSERT_TRUE(plan.ok()) << toString(plan.error());
  ASSERT_GE(host.plans.size(), 2U);
  for (const AssemblyPlan& growing : host.plans) {
    ASSERT_TRUE(savePlan(growing, "drawer", file).ok());
    const auto read = readPlan(file);
    ASSERT_TRUE(read.ok()) << toString(read.error());
    EXPECT_EQ(read->strategy, "best-first");
    EXPECT_EQ(read->seed, 3U);
    EXPECT_EQ(read->demands, demands);
    EXPECT_TRUE(judgePlan(*read, product, std::nullopt, {}).valid()) << growing.steps.size() << " steps";
  }
}

}  // namespace
}  // namespace glissade
