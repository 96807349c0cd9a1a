#include "engine/planning/fine/geometrical_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

const Box3 kRoom(Vector3::Zero(), Vector3(2, 1, 1));
const Vector3 kFrom(0.25, 0.5, 0.5);
const Vector3 kTo(1.75, 0.5, 0.5);
constexpr double kRadius = 0.1;

EnvironmentModelPtr roomWith(RigidBody body, Mobility mobility) {
  body.mobility = mobility;
  return test::environmentOf({std::move(body)}, kRoom, {1.0 / 16, 16, 5, "watershed"});
}

RigidBody box(const Vector3& size) { return boxBody("box", size, Pose::translation(Vector3(1, 0.5, 0.5))); }

std::vector<std::size_t> openCells(const EnvironmentModel& model) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < model.space.grid.size(); ++cell) {
    if (model.space.open(cell)) cells.push_back(cell);
  }
  return cells;
}

std::vector<std::size_t> pathIn(const EnvironmentModel& model, const std::vector<std::size_t>& area) {
  return findCellPath(model, area, model.clearance, kFrom, kTo, kRadius);
}

class RoundABox : public testing::TestWithParam<Mobility> {};

TEST_P(RoundABox, ThePathIsConnectedAndFree) {
  const auto model = roomWith(box({0.25, 0.75, 1.0}), GetParam());
  ASSERT_NE(model, nullptr);
  const CellGrid& grid = model->space.grid;
  const auto path = pathIn(*model, openCells(*model));
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), grid.find(kFrom));
  EXPECT_EQ(path.back(), grid.find(kTo));
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(model->space.kinds[path[i]], CellKind::Free);
    if (i > 0) {
      EXPECT_NEAR((grid.centre(path[i]) - grid.centre(path[i - 1])).norm(), grid.cellSize(), 1e-12);
    }
  }
}

TEST_P(RoundABox, ThroughAWallThereIsNoWay) {
  const auto model = roomWith(box({0.25, 1.0, 1.0}), GetParam());
  ASSERT_NE(model, nullptr);
  EXPECT_TRUE(pathIn(*model, openCells(*model)).empty());
}

INSTANTIATE_TEST_SUITE_P(Mobilities, RoundABox, testing::Values(Mobility::Static, Mobility::Mobile),
                         [](const auto& parameter) {
                           return parameter.param == Mobility::Static ? "Static" : "Mobile";
                         });

TEST(FindCellPath, StaysInItsArea) {
  const auto model = roomWith(box({0.25, 0.5, 1.0}), Mobility::Static);
  ASSERT_NE(model, nullptr);
  const CellGrid& grid = model->space.grid;
  std::vector<std::size_t> left;  // only one way round the box
  for (const std::size_t cell : openCells(*model)) {
    if (grid.centre(cell).y() < 0.6) left.push_back(cell);
  }
  const auto path = pathIn(*model, left);
  ASSERT_FALSE(path.empty());
  for (const std::size_t cell : path) EXPECT_TRUE(std::binary_search(left.begin(), left.end(), cell));
  EXPECT_TRUE(findCellPath(*model, {}, model->clearance, kFrom, kTo, kRadius).empty());
}

TEST(FindCellPath, TakesTheWideSideOfABox) {
  // The gaps beside the box are 0.25 m and 0.5 m wide, and the narrow one is nearer.
  const auto model =
      roomWith(boxBody("box", {0.25, 0.25, 1.0}, Pose::translation(Vector3(1, 0.375, 0.5))), Mobility::Static);
  ASSERT_NE(model, nullptr);
  const CellGrid& grid = model->space.grid;
  const Vector3 from(0.25, 0.34, 0.5);
  const Vector3 to(1.75, 0.34, 0.5);
  const auto sideOf = [&](double radius) {
    for (const std::size_t cell : findCellPath(*model, openCells(*model), model->clearance, from, to, radius)) {
      const Vector3 p = grid.centre(cell);
      if (std::abs(p.x() - 1.0) < 0.05) return p.y() < 0.375 ? "narrow" : "wide";
    }
    return "none";
  };
  EXPECT_STREQ(sideOf(0.001), "narrow");
  EXPECT_STREQ(sideOf(0.5), "wide");
}

TEST(RegionAlong, IsTheAreaAboutThePath) {
  const auto model = roomWith(box({0.25, 0.5, 1.0}), Mobility::Static);
  ASSERT_NE(model, nullptr);
  const CellGrid& grid = model->space.grid;
  const auto area = openCells(*model);
  const auto path = pathIn(*model, area);
  ASSERT_FALSE(path.empty());
  const double radius = 2.5 * grid.cellSize();
  const auto region = regionAlong(grid, path, area, radius);
  EXPECT_TRUE(std::is_sorted(region.begin(), region.end()));
  EXPECT_TRUE(std::includes(area.begin(), area.end(), region.begin(), region.end()));
  EXPECT_EQ(std::set<std::size_t>(region.begin(), region.end()).size(), region.size());
  EXPECT_LT(region.size(), area.size());
  EXPECT_GT(region.size(), 2 * path.size());
  for (const std::size_t cell : path) EXPECT_TRUE(std::binary_search(region.begin(), region.end(), cell));
  for (const std::size_t cell : region) {
    double nearest = 1e300;
    for (const std::size_t step : path) nearest = std::min(nearest, (grid.centre(step) - grid.centre(cell)).norm());
    EXPECT_LE(nearest, radius);
  }
  EXPECT_EQ(regionAlong(grid, path, area, 0.0).size(), path.size());
}

}  // namespace
}  // namespace glissade
