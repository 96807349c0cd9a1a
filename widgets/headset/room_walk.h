#pragma once

#include <numbers>
#include <optional>

#include "widgets/headset/controller_state.h"
#include "widgets/headset/room_placement.h"

namespace glissade {

/// What a person moves through the world with.
struct WalkInput {
  BothControllers controllers;
  Vector3 p_RH = Vector3::Zero();  ///< of the head, in the room
  ControllerSide mainHand = ControllerSide::Right;
  std::array<bool, 2> holds{};  ///< the object; by ControllerSide
};

/// Moves the room of a person through the world, by their hands alone; nothing goes on by itself.
///
/// The other hand, closed, pulls the world. Both hands closed, where none holds the object, also turn and scale it:
/// what each hand has stays in that hand. The world stays upright. A stick that is pushed forward shows where the hand
/// points at the floor; released, the person stands there. A stick to the side turns them by a step.
class RoomWalk {
 public:
  static constexpr double kClosed = 0.6;     ///< squeeze of a hand that pulls
  static constexpr double kOpened = 0.3;     ///< of one that has let go
  static constexpr double kPushed = 0.7;     ///< of a stick
  static constexpr double kReleased = 0.3;   ///< likewise
  static constexpr double kFarthest = 10.0;  ///< of a step, metres of the room
  static constexpr double kTurn = std::numbers::pi / 6.0;
  static constexpr double kLeastScale = 1e-3;  ///< metres of the room for each metre of the world
  static constexpr double kLargestScale = 1e3;

  /// The person was placed there.
  void place(const RoomPlacement& room);
  const RoomPlacement& room() const { return room_; }
  /// Another moment.
  void advance(const WalkInput& input);
  /// Where the person would stand, in the world, while a stick is pushed forward.
  std::optional<Vector3> target() const;

 private:
  /// What hands have of the world.
  struct Pull {
    Vector3 p_W;                         ///< in the one hand, or in the middle of both
    std::optional<Vector3> between_W{};  ///< from the left hand to the right one
  };

  void pull(const WalkInput& input);
  void keep(const Vector3& p_W, const Vector3& p_R);
  void turn(double angle, const Vector3& p_R);
  void step(const WalkInput& input);
  bool closes(const ControllerState& state, ControllerSide side);

  RoomPlacement room_;
  std::array<bool, 2> closed_{};
  std::optional<Pull> pull_;
  std::optional<Vector3> target_R_;
  std::array<bool, 2> aside_{};  ///< the stick is pushed to the side
};

}  // namespace glissade
