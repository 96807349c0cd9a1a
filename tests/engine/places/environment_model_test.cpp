#include "engine/places/environment_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

using testing::StartsWith;

TEST(EnvironmentModel, RefusesOptionsOutOfRange) {
  struct Row {
    EnvironmentOptions options;
    const char* place;
  };
  for (const Row& row :
       {Row{{-1.0, 16, 5, "watershed"}, "/environment/cell_size"},
        Row{{1e-5, 16, 5, "watershed"}, "/environment/cell_size"}, Row{{0, 0.5, 5, "watershed"}, "/environment/memory"},
        Row{{0, std::nan(""), 5, "watershed"}, "/environment/memory"},
        Row{{0, 16, 1, "watershed"}, "/environment/topology_level"},
        Row{{0, 16, 9, "watershed"}, "/environment/topology_level"},
        Row{{0, 16, 5, "voronoi"}, "/environment/places"}}) {
    const auto built = buildEnvironment({}, test::twoRooms(), row.options);
    ASSERT_FALSE(built.ok()) << row.place;
    EXPECT_EQ(built.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(built.error().location), row.place);
    EXPECT_FALSE(built.error().advice.empty());
  }
  for (const Box3& flat : {Box3(), Box3(Vector3::Zero(), Vector3::Zero())}) {
    const auto built = buildEnvironment({}, flat, {});
    ASSERT_FALSE(built.ok());
    EXPECT_EQ(toString(built.error().location), "/workspace");
  }
}

TEST(EnvironmentModel, TwoRoomsMeetTheirHoleInTwoBorders) {
  for (const char* identifier : {"region-growing", "watershed"}) {
    const auto model = test::environmentOf(test::wallWithAHole(), test::twoRooms(), {1.0 / 32, 16, 6, identifier});
    ASSERT_NE(model, nullptr);
    const TopologicalMap& map = model->map;
    ASSERT_EQ(map.places.size(), 3U);
    ASSERT_EQ(map.borders.size(), 2U);
    const int hole = map.placeAt(Vector3(1.0, 0.5, 0.5));
    ASSERT_NE(hole, kNoPlace);
    const Place& place = map.places[static_cast<std::size_t>(hole)];
    EXPECT_TRUE(place.passage);
    EXPECT_EQ(place.axis, 0);
    EXPECT_NEAR(place.narrowness, 0.25, 1e-6);
    EXPECT_GE(place.complexity, 3);  // a quarter of the rooms' width of 1 m
    for (const Border& border : map.borders) {
      EXPECT_TRUE(border.placeA == hole || border.placeB == hole);
      EXPECT_LT(border.placeA, border.placeB);
      EXPECT_NEAR(border.opening, 0.25 * 0.25, 1e-9);
      EXPECT_NEAR(border.centre.y(), 0.5, 1e-9);
      EXPECT_NEAR(border.centre.z(), 0.5, 1e-9);
      EXPECT_NEAR(std::abs(border.normal.x()), 1.0, 1e-9);
      EXPECT_FALSE(border.cells.empty());
    }
    EXPECT_NE(map.placeAt(Vector3(0.3, 0.5, 0.5)), map.placeAt(Vector3(1.7, 0.5, 0.5)));
    EXPECT_EQ(map.placeAt(Vector3(1.0, 0.1, 0.5)), kNoPlace);  // in the wall
    EXPECT_EQ(map.placeAt(Vector3(3.0, 0.5, 0.5)), kNoPlace);
    EXPECT_EQ(map.placeNear(Vector3(3.0, 0.5, 0.5)), map.placeAt(Vector3(1.9, 0.5, 0.5)));
  }
}

TEST(EnvironmentModel, MobileBodiesClutterPlacesButDoNotShapeThem) {
  std::vector<RigidBody> bodies = test::wallWithAHole();
  const EnvironmentOptions options{1.0 / 32, 16, 6, "watershed"};
  const auto empty = test::environmentOf(bodies, test::twoRooms(), options);
  bodies.push_back(boxBody("crate", {0.25, 0.5, 0.5}, Pose::translation(Vector3(1.5, 0.5, 0.5))));
  bodies.back().mobility = Mobility::Mobile;
  const auto with = test::environmentOf(bodies, test::twoRooms(), options);
  ASSERT_NE(empty, nullptr);
  ASSERT_NE(with, nullptr);
  EXPECT_EQ(with->map.placeOf, empty->map.placeOf);
  for (std::size_t place = 0; place < with->map.places.size(); ++place) {
    EXPECT_FALSE(empty->cluttered[place]);
    EXPECT_EQ(with->cluttered[place], static_cast<int>(place) == with->map.placeAt(Vector3(1.5, 0.5, 0.5)));
  }
  const std::size_t inTheCrate = *with->map.grid.find(Vector3(1.5, 0.5, 0.5));
  EXPECT_EQ(with->clearance[inTheCrate], 0.0);
  EXPECT_GT(empty->clearance[inTheCrate], 0.0);
}

/// Compares all properties of two models of the same bodies.
void expectSame(const EnvironmentModel& a, const EnvironmentModel& b) {
  EXPECT_TRUE(*a.octree == *b.octree);
  EXPECT_EQ(a.space.kinds, b.space.kinds);
  EXPECT_EQ(a.map.placeOf, b.map.placeOf);
  EXPECT_EQ(a.cluttered, b.cluttered);
  EXPECT_EQ(a.clearance, b.clearance);
  EXPECT_EQ(a.statics_W.vertices, b.statics_W.vertices);
}

TEST(EnvironmentModel, UpdatedForMovedBodiesEqualsOneBuiltAfresh) {
  RandomStream stream(3, "moved bodies");
  const EnvironmentOptions options{1.0 / 32, 16, 5, "watershed"};
  const Box3 workspace(Vector3::Zero(), Vector3::Ones());
  std::vector<RigidBody> bodies = test::randomBodies(stream, 6);
  EnvironmentModelPtr model = test::environmentOf(bodies, workspace, options);
  for (int move = 0; move < 12; ++move) {
    bodies[static_cast<std::size_t>(stream.uniform(0, 6))].X_WB.position += 0.2 * randomPose(stream, 1.0).position;
    const auto updated = updateEnvironment(*model, bodies, workspace, options);
    ASSERT_TRUE(updated.ok());
    model = *updated;
    expectSame(*model, *test::environmentOf(bodies, workspace, options));
  }
}

TEST(EnvironmentModel, UpdatedKeepsItsPlacesWhereOnlyMobileBodiesMoved) {
  std::vector<RigidBody> bodies = test::wallWithAHole();
  bodies.push_back(boxBody("crate", Vector3::Constant(0.2), Pose::translation({0.4, 0.5, 0.5})));
  bodies.back().mobility = Mobility::Mobile;
  const EnvironmentOptions options{0.0, 1, 6, "watershed"};
  const EnvironmentModelPtr before = test::environmentOf(bodies, test::twoRooms(), options);
  const auto clutteredAt = [&](const EnvironmentModel& model, const Vector3& p_W) {
    return bool(model.cluttered[static_cast<std::size_t>(model.map.placeAt(p_W))]);
  };
  const Vector3 left(0.2, 0.2, 0.2);
  const Vector3 right(1.8, 0.2, 0.2);
  EXPECT_TRUE(clutteredAt(*before, left));
  EXPECT_FALSE(clutteredAt(*before, right));

  bodies.back().X_WB.position.x() = 1.6;
  const auto after = updateEnvironment(*before, bodies, test::twoRooms(), options);
  ASSERT_TRUE(after.ok());
  EXPECT_FALSE(clutteredAt(**after, left));
  EXPECT_TRUE(clutteredAt(**after, right));
  EXPECT_EQ((*after)->map.placeOf, before->map.placeOf);
  EXPECT_EQ((*after)->octree->depth(), before->octree->depth());

  bodies.front().X_WB.position.y() -= 0.1;  // makes the hole wider
  const auto wider = updateEnvironment(**after, bodies, test::twoRooms(), options);
  ASSERT_TRUE(wider.ok());
  EXPECT_NE((*wider)->map.placeOf, before->map.placeOf);
}

}  // namespace
}  // namespace glissade
