#include "widgets/scene3d/milestone_drag.h"

#include <gtest/gtest.h>

#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// Two milestones along x, viewed along -z.
class MilestoneDragTest : public testing::Test {
 protected:
  MilestoneDragTest() {
    for (const double x : {0.0, 3.0}) {
      TopologicalStep step;
      step.border = 0;
      step.milestone = true;
      step.to = Pose::translation({x, 0, 0});
      plan.steps.push_back(step);
    }
    grid.frame = CellFrame::covering(Box3(Vector3::Constant(-4.0), Vector3::Constant(4.0)));
    grid.level = 3;
    grid.counts = {8, 8, 8};
    std::vector<std::size_t> cells(grid.size());
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = i;
    everywhere = std::make_shared<const SamplingRegion>(grid, cells);
  }

  static Ray downAt(double x, double y) { return {{x, y, 10.0}, -Vector3::UnitZ()}; }
  std::optional<MilestoneDrag> grip(const Ray& ray, double farthest = 1e9) const {
    return MilestoneDrag::grip(plan, boxBody("object", {1, 1, 1}, Pose{}).mesh, ray, farthest, Quaternion::Identity());
  }

  CoarsePlan plan;
  CellGrid grid;
  SamplingRegionPtr everywhere;
};

TEST_F(MilestoneDragTest, GripsTheMilestoneUnderThePointerOnly) {
  EXPECT_EQ(grip(downAt(3.2, 0.1))->step(), 1U);
  EXPECT_FALSE(grip(downAt(1.5, 0.0)));
  EXPECT_FALSE(grip(downAt(3.2, 0.1), 5.0)) << "hidden by a body";
  plan.steps[1].milestone = false;
  EXPECT_FALSE(grip(downAt(3.2, 0.1)));
}

TEST_F(MilestoneDragTest, ThePointThatWasGrippedStaysUnderThePointer) {
  auto drag = grip(downAt(0.3, 0.2));
  drag->moveTo(downAt(1.3, -0.8), *everywhere);
  EXPECT_LT((drag->pose().position - Vector3(1, -1, 0)).norm(), 1e-12);
}

TEST_F(MilestoneDragTest, StaysInTheRegionAndComesBackWithThePointer) {
  auto drag = grip(downAt(0, 0));
  drag->moveTo(downAt(3.5, 0), *everywhere);
  drag->moveTo(downAt(7.5, 0), *everywhere);
  EXPECT_NEAR(drag->pose().position.x(), 3.5, 1e-12);
  drag->moveTo(downAt(2.0, 1.0), *everywhere);
  EXPECT_LT((drag->pose().position - Vector3(2, 1, 0)).norm(), 1e-12);
}

TEST_F(MilestoneDragTest, TurnsAboutTheViewsAxesInPlace) {
  auto drag = grip(downAt(0, 0));
  drag->turn(0.5, 0.0);
  EXPECT_EQ(drag->pose().position, plan.steps[0].to.position);
  const Vector3 turned = drag->pose().orientation * Vector3::UnitZ();
  EXPECT_LT((turned - Vector3::UnitX()).norm(), 1e-12) << "a quarter turn about the view's up";
}

}  // namespace
}  // namespace glissade
