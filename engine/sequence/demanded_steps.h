#pragma once

#include <string>
#include <vector>

#include "engine/planning/path.h"

namespace glissade {

/// The method of motions that a person led.
inline constexpr const char* kByHand = "by hand";

/// A step that a person wants at a place of the plan. Bodies by name, as in SequenceDemands; several leave as one.
struct DemandedPlace {
  std::vector<std::string> bodies;
  std::size_t place = 1;  ///< number of the removal step, from 1
  bool locked = false;    ///< the step keeps its place when a person moves other steps

  bool operator==(const DemandedPlace&) const = default;
};

/// The only motion by which these bodies may leave: a person led it, or wants to keep it.
struct DemandedMotion {
  std::vector<std::string> bodies;
  std::vector<PathPoint> path;  ///< see StepMotion::path
  std::string method;           ///< kByHand, or the method of the step that the motion was taken from

  friend bool operator==(const DemandedMotion& a, const DemandedMotion& b);
};

/// A direction in which a body may not move, with the cone tolerance::kForbiddenCone about it, until the body is clear
/// of the bodies that it touches (DirectionRule).
struct ForbiddenDirection {
  std::string body;
  Vector3 direction = Vector3::UnitZ();  ///< world frame, any length

  bool operator==(const ForbiddenDirection&) const = default;
};

/// True if the direction, of any length, is within the cone of one of the forbidden unit directions.
bool isForbidden(const Vector3& direction, const std::vector<Vector3>& forbidden);

/// The order after a person has moved the step `from` to the place of `to` as in the edit of a list: locked steps keep
/// their places, the others move up or down. Indices from 0; `isLocked`: one entry for each step.
std::vector<std::size_t> movedOrder(std::size_t to, std::size_t from, const std::vector<bool>& isLocked);

/// True for each step that is locked at a place. `steps`: as in movedTo().
std::vector<bool> lockedSteps(const std::vector<std::vector<std::string>>& steps,
                              const std::vector<DemandedPlace>& places);

/// The places after a person has moved a step, see movedOrder(). `steps`: the ids of the bodies of each step of the
/// plan. The step `from` gets the place of `to`, or the next place if a locked step is there. Indices from 0. Returns
/// the moved step and the steps of `places`, ascending by place.
std::vector<DemandedPlace> movedTo(std::size_t to, std::size_t from, const std::vector<std::vector<std::string>>& steps,
                                   const std::vector<DemandedPlace>& places);

}  // namespace glissade
