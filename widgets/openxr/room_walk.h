#pragma once

#include <numbers>
#include <optional>

#include "widgets/openxr/controller_state.h"
#include "widgets/openxr/room_placement.h"

namespace glissade {

/// The input by which a person moves through the world.
struct WalkInput {
  BothControllers controllers;
  Vector3 p_RH = Vector3::Zero();  ///< head in the room
  ControllerSide mainHand = ControllerSide::Right;
  std::array<bool, 2> holds{};  ///< whether each hand holds the object, by ControllerSide
};

/// Moves a person's room through the world by the hands alone; nothing moves by itself.
///
/// The closed other hand pulls the world. Both closed hands, if neither holds the object, also turn and scale it: the
/// point that each hand has grasped stays in that hand. The world stays upright. A stick that is pushed forward shows
/// the point of the floor at which the hand points; when it is released, the person stands there. A stick to the side
/// turns the person by a step.
class RoomWalk {
 public:
  static constexpr double kClosed = 0.6;     ///< squeeze above which a hand is closed
  static constexpr double kOpened = 0.3;     ///< squeeze below which a closed hand is open
  static constexpr double kPushed = 0.7;     ///< deflection above which a stick is pushed
  static constexpr double kReleased = 0.3;   ///< deflection below which a pushed stick is released
  static constexpr double kFarthest = 10.0;  ///< longest step, metres of the room
  static constexpr double kTurn = std::numbers::pi / 6.0;
  static constexpr double kLeastScale = 1e-3;  ///< metres of the room for each metre of the world
  static constexpr double kLargestScale = 1e3;

  /// Sets the person's placement.
  void place(const RoomPlacement& room);
  const RoomPlacement& room() const { return room_; }
  /// Moves the room by the present input.
  void advance(const WalkInput& input);
  /// The place in the world where the person will stand when the pushed stick is released.
  std::optional<Vector3> target() const;

 private:
  /// The points of the world that the hands have grasped.
  struct Pull {
    Vector3 p_W;                         ///< at the hand, or in the middle of both hands
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
