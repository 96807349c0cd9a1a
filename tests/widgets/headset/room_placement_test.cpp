#include "widgets/openxr/room_placement.h"

#include <gtest/gtest.h>

#include "widgets/openxr/eye_sight.h"

namespace glissade {
namespace {

const Box3 kMachine(Vector3(-1.0, 2.0, 0.5), Vector3(3.0, 4.0, 2.5));
const Box3 kNut(Vector3(0.10, 0.10, 0.10), Vector3(0.12, 0.12, 0.11));

Vector3 inWorldAt(const RoomPlacement& room, const Vector3& p_R) {
  return inWorld(room, Pose::translation(p_R)).position;
}

void expectNear(const Vector3& actual, const Vector3& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-12) << actual.transpose() << " is not " << expected.transpose();
}

TEST(RoomPlacement, UpInTheRoomIsUpInTheWorldAndAheadIsItsFront) {
  const RoomPlacement room = placeRoom(kMachine, ProductSize::True);
  const Quaternion R_WR = room.X_WR.orientation;
  expectNear(R_WR * Vector3::UnitY(), Vector3::UnitZ());
  expectNear(R_WR * -Vector3::UnitZ(), Vector3::UnitY());
  expectNear(R_WR * Vector3::UnitX(), Vector3::UnitX());
}

TEST(RoomPlacement, ALargeProductStandsOnTheFloorBeforeThePerson) {
  const RoomPlacement room = placeRoom(kMachine, ProductSize::True);
  EXPECT_EQ(room.scale, 1.0);
  expectNear(inWorldAt(room, Vector3(0.0, 0.0, -1.2)), {1.0, 2.0, 0.5});
}

TEST(RoomPlacement, ASmallProductAtTrueScaleIsOnATable) {
  const RoomPlacement room = placeRoom(kNut, ProductSize::True);
  EXPECT_EQ(room.scale, 1.0);
  expectNear(inWorldAt(room, Vector3(0.0, 0.75, -0.5)), {0.11, 0.10, 0.10});
}

TEST(RoomPlacement, OnATableEveryProductIsAsLargeAsTheTableHasRoomFor) {
  for (const Box3& product : {kMachine, kNut}) {
    const RoomPlacement room = placeRoom(product, ProductSize::OnTable);
    EXPECT_DOUBLE_EQ(room.scale * product.sizes().maxCoeff(), 0.6);
    const Vector3 foot(product.center().x(), product.min().y(), product.min().z());
    expectNear(inWorldAt(room, Vector3(0.0, 0.75, -0.5)), foot);
  }
}

TEST(RoomPlacement, WithoutAProductTheOriginIsOnTheFloor) {
  const RoomPlacement room = placeRoom(Box3(), ProductSize::OnTable);
  EXPECT_EQ(room.scale, 1.0);
  expectNear(inWorldAt(room, Vector3(0.0, 0.0, -0.5)), Vector3::Zero());
}

TEST(RoomPlacement, AnEyeSeesWithTheScaleOfTheRoom) {
  const RoomPlacement room = placeRoom(kMachine, ProductSize::OnTable);
  const Pose X_RE{Vector3(0.1, 1.6, 0.2), Quaternion(Eigen::AngleAxisd(0.3, Vector3::UnitY()))};
  const EyeSight sight = sightOf(room, X_RE, {});
  expectNear(sight.X_WE.position, inWorldAt(room, X_RE.position));
  EXPECT_LT(angleBetween(sight.X_WE.orientation, room.X_WR.orientation * X_RE.orientation), 1e-7);
  EXPECT_DOUBLE_EQ(sight.nearPlane * room.scale, 0.05);
}

TEST(RoomPlacement, APointOfTheWorldIsFoundInTheRoom) {
  const RoomPlacement room = placeRoom(Box3(Vector3(0, 0, 0), Vector3(3, 3, 3)), ProductSize::OnTable);
  const Vector3 p_R(0.2, 1.1, -0.3);
  EXPECT_LT((inRoom(room, inWorld(room, Pose::translation(p_R)).position) - p_R).norm(), 1e-12);
}

}  // namespace
}  // namespace glissade
