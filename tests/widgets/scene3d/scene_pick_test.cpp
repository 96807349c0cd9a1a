#include "widgets/scene3d/scene_pick.h"

#include <gtest/gtest.h>

#include "engine/places/environment_model.h"
#include "tests/engine/support/test_worlds.h"
#include "widgets/scene3d/cell_surface.h"

namespace glissade {
namespace {

TEST(ScenePick, TheNearestBodyAlongTheRay) {
  const std::vector<RigidBody> bodies{boxBody("far", {1, 1, 1}, Pose::translation({5, 0, 0})),
                                      boxBody("near", {1, 1, 1}, Pose::translation({2, 0, 0}))};
  const auto hit = pickBody(bodies, {Vector3::Zero(), Vector3::UnitX()});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, 1U);
  EXPECT_NEAR(hit->distance, 1.5, 1e-12);
  EXPECT_FALSE(pickBody(bodies, {Vector3::Zero(), Vector3::UnitY()}));
  // A ray from inside a body hits its far side.
  const auto inside = pickBody(bodies, {Vector3(2.0, 0.0, 0.0), Vector3::UnitX()});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->distance, 0.5, 1e-12);
}

TEST(ScenePick, TheMiddleOfTheViewLooksAtTheFocus) {
  CameraController camera;
  camera.setStandardView(StandardView::Front);
  camera.fit(Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0)));
  const Ray ray = rayThrough(camera, 0.0, 0.0);
  EXPECT_LT((ray.origin + camera.distance() * ray.direction - camera.focus()).norm(), 1e-9);
}

TEST(ScenePick, AHoleIsMeantNotTheRoomsAroundIt) {
  const Problem problem = windowProblem();
  EnvironmentOptions options;
  options.cellSize = 0.07;
  options.topologyLevel = 6;
  const auto environment = buildEnvironment(problem.world->obstacles(), problem.bounds, options);
  ASSERT_TRUE(environment.ok());
  const TopologicalMap& map = (*environment)->map;
  const int through = pickPlace(map, {{-3, 0, 0}, Vector3::UnitX()}, 1e9);
  ASSERT_NE(through, kNoPlace);
  EXPECT_TRUE(map.places[static_cast<std::size_t>(through)].passage);
  const int before = pickPlace(map, {{-3, 0, 0}, Vector3::UnitX()}, 2.0);
  EXPECT_FALSE(map.places[static_cast<std::size_t>(before)].passage);
}

TEST(CellSurface, ABlockOfCellsHasSixFacesHoweverManyCells) {
  CellGrid grid;
  grid.level = 3;
  grid.counts = {8, 8, 8};
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const auto c = grid.coordinates(cell);
    if (c[0] >= 1 && c[0] < 4 && c[1] >= 2 && c[1] < 7 && c[2] < 3) cells.push_back(cell);
  }
  const auto faces = outerSurface(grid, cells);
  EXPECT_EQ(faces.size(), 6U);
  double area = 0.0;
  for (const CellFace& face : faces) {
    area += (face.corners[1] - face.corners[0]).cross(face.corners[3] - face.corners[0]).norm();
  }
  const double edge = grid.cellSize();
  EXPECT_NEAR(area, 2.0 * (3 * 5 + 5 * 3 + 3 * 3) * edge * edge, 1e-12);
}

TEST(ScenePick, WhatASectionCutsAwayIsNotThere) {
  const std::vector<RigidBody> bodies{boxBody("near", {1, 1, 1}, Pose::translation({2, 0, 0})),
                                      boxBody("far", {1, 1, 1}, Pose::translation({5, 0, 0}))};
  const Ray ray{Vector3::Zero(), Vector3::UnitX()};
  const auto open = pickBody(bodies, ray, {}, {{-Vector3::UnitX(), -2.2}});
  ASSERT_TRUE(open);
  EXPECT_EQ(open->body, 0U);
  EXPECT_NEAR(open->distance, 2.5, 1e-12);
  const auto behind = pickBody(bodies, ray, {}, {{-Vector3::UnitX(), -3.0}});
  ASSERT_TRUE(behind);
  EXPECT_EQ(behind->body, 1U);
}

}  // namespace
}  // namespace glissade
