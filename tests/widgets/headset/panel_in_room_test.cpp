#include "widgets/openxr/panel_in_room.h"
#include "engine/geometry/least_rotation.h"

#include <gtest/gtest.h>

#include "widgets/openxr/controller_link.h"

namespace glissade {
namespace {

constexpr std::size_t kLeft = 0;
constexpr std::size_t kRight = 1;
const Pose kHead = Pose::translation({0.1, 1.6, 0.2});

class PanelInRoomTest : public testing::Test {
 protected:
  PanelInRoomTest() {
    states_[kLeft].X_RG = states_[kLeft].X_RA = Pose::translation({-0.2, 1.1, -0.3});
    input_.X_RH = kHead;
    advance();
  }

  void advance() {
    taken_ = states_;
    panel_.advance(taken_, input_);
  }
  /// The hand points at this place of the panel, in shares of its width and height.
  void pointAt(std::size_t hand, double x, double y) {
    const Vector3 p_P((x - 0.5) * PanelInRoom::kWidth, (0.5 - y) * PanelInRoom::kHeight, 0.0);
    const Vector3 target = *panel_.X_RP() * p_P;
    const Vector3 from = target + panel_.X_RP()->orientation * Vector3(0.1, -0.2, 0.3);
    const Pose X_RA{from, leastRotation(-Vector3::UnitZ(), target - from)};
    states_[hand].X_RG = states_[hand].X_RA = X_RA;
    advance();
  }
  void pull(std::size_t hand, double trigger) {
    states_[hand].trigger = trigger;
    advance();
  }
  bool isPressed() const { return panel_.touch() && panel_.touch()->pointer.pressed; }
  Vector3 towardsHead() const { return (kHead.position - panel_.X_RP()->position).normalized(); }

  PanelInRoom panel_;
  BothControllers states_;
  BothControllers taken_;  ///< the states without the input that the panel has taken
  PanelInput input_;
};

TEST_F(PanelInRoomTest, ItGoesWithTheOtherHandAndFacesThePerson) {
  ASSERT_TRUE(panel_.X_RP());
  EXPECT_GT((panel_.X_RP()->orientation * Vector3::UnitZ()).dot(towardsHead()), 0.8);
  const Pose before = *panel_.X_RP();
  const Pose moved = Pose::translation({0.3, 0.1, 0.0});
  states_[kLeft].X_RG = moved * *states_[kLeft].X_RG;
  advance();
  EXPECT_LT(((moved * before).position - panel_.X_RP()->position).norm(), 1e-12);
  states_[kLeft].X_RG.reset();
  advance();
  EXPECT_FALSE(panel_.X_RP()) << "a hand that is not tracked";
}

TEST_F(PanelInRoomTest, OfALeftHandedPersonItIsInTheRightHand) {
  states_[kRight].X_RG = Pose::translation({0.2, 1.1, -0.3});
  input_.mainHand = ControllerSide::Left;
  advance();
  EXPECT_GT(panel_.X_RP()->position.x(), 0.0);
}

TEST_F(PanelInRoomTest, BeforeThePersonItStaysWhereItWas) {
  input_.isInFront = true;
  input_.X_RH.orientation = Quaternion(Eigen::AngleAxisd(0.5, Vector3::UnitY()));
  advance();
  const Pose placed = *panel_.X_RP();
  const Vector3 p_RP = placed.position - kHead.position;
  EXPECT_NEAR(p_RP.norm(), PanelInRoom::kDistance, 1e-9);
  EXPECT_GT((placed.orientation * Vector3::UnitZ()).dot(towardsHead()), 0.999);
  EXPECT_NEAR((placed.orientation * Vector3::UnitX()).y(), 0.0, 1e-12) << "level";
  EXPECT_LT(p_RP.x(), 0.0) << "where the person looks";
  input_.X_RH = Pose::translation({1.0, 1.0, 1.0});
  states_[kLeft].X_RG = Pose::translation({0.0, 0.5, 0.0});
  advance();
  EXPECT_EQ(*panel_.X_RP(), placed);
  input_.isInFront = false;
  advance();
  EXPECT_LT((panel_.X_RP()->position - states_[kLeft].X_RG->position).norm(), 0.4);
}

TEST_F(PanelInRoomTest, APlaceThatIsPointedAtIsSaidFromTheUpperLeftCorner) {
  pointAt(kRight, 0.25, 0.75);
  ASSERT_TRUE(panel_.touch());
  EXPECT_EQ(panel_.touch()->side, ControllerSide::Right);
  EXPECT_LT((panel_.touch()->pointer.at - Eigen::Vector2d(0.25, 0.75)).norm(), 1e-9);
  EXPECT_NEAR(panel_.touch()->distance, Vector3(0.1, -0.2, 0.3).norm(), 1e-9);
  pointAt(kRight, 1.05, 0.5);
  EXPECT_FALSE(panel_.touch());
}

TEST_F(PanelInRoomTest, ItsBackIsNotPointedAt) {
  const Vector3 behind = panel_.X_RP()->position - panel_.X_RP()->orientation * Vector3(0.0, 0.0, 0.3);
  states_[kRight].X_RA = Pose{behind, leastRotation(-Vector3::UnitZ(), panel_.X_RP()->position - behind)};
  advance();
  EXPECT_FALSE(panel_.touch());
}

TEST_F(PanelInRoomTest, AHandThatPointsAtItDoesNothingElse) {
  states_[kRight].squeeze = states_[kLeft].squeeze = 1.0;
  pointAt(kRight, 0.5, 0.5);
  pull(kRight, 1.0);
  EXPECT_EQ(taken_[kRight].squeeze, 0.0);
  EXPECT_EQ(taken_[kRight].trigger, 0.0);
  EXPECT_EQ(taken_[kLeft].squeeze, 1.0) << "the other hand pulls the world";
  pointAt(kRight, 2.0, 0.5);
  pull(kRight, 0.0);
  pull(kRight, 1.0);
  EXPECT_EQ(taken_[kRight].squeeze, 1.0);
  EXPECT_EQ(taken_[kRight].trigger, 1.0);
}

TEST_F(PanelInRoomTest, AHandThatHoldsTheObjectGoesPastIt) {
  input_.holds[kRight] = true;
  states_[kRight].squeeze = 1.0;
  pointAt(kRight, 0.5, 0.5);
  EXPECT_FALSE(panel_.touch());
  EXPECT_EQ(taken_[kRight].squeeze, 1.0);
}

TEST_F(PanelInRoomTest, ATriggerThatWasPulledElsewhereIsNoPress) {
  states_[kRight].trigger = 1.0;
  pointAt(kRight, 0.5, 0.5);
  advance();
  EXPECT_FALSE(isPressed());
  pull(kRight, 0.0);
  pull(kRight, 1.0);
  EXPECT_TRUE(isPressed());
}

TEST_F(PanelInRoomTest, APressLastsUntilTheTriggerIsReleased) {
  pointAt(kRight, 0.5, 0.5);
  pull(kRight, 0.9 * ControllerLink::kTriggerPressed);
  EXPECT_FALSE(isPressed());
  pull(kRight, 1.0);
  EXPECT_TRUE(isPressed());
  pull(kRight, 0.9 * ControllerLink::kTriggerPressed);
  EXPECT_TRUE(isPressed());
  pull(kRight, 0.0);
  EXPECT_FALSE(isPressed());
}

TEST_F(PanelInRoomTest, ADragGoesPastTheEdge) {
  pointAt(kRight, 0.9, 0.5);
  pull(kRight, 1.0);
  pointAt(kRight, 1.3, 0.5);
  ASSERT_TRUE(isPressed());
  EXPECT_EQ(panel_.touch()->pointer.at.x(), 1.0);
  pull(kRight, 0.0);
  EXPECT_FALSE(isPressed());
}

}  // namespace
}  // namespace glissade
