#pragma once

#include <string>
#include <vector>

#include "engine/planning/path.h"

namespace glissade {

/// The method of motions that a person found.
inline constexpr const char* kByHand = "by hand";

/// A step that a person wants at a place of the plan. Bodies by name, as in SequenceDemands; several leave as one.
struct DemandedPlace {
  std::vector<std::string> bodies;
  std::size_t place = 1;  ///< of removal, from 1
  bool locked = false;    ///< it keeps its place where a person moves other steps

  bool operator==(const DemandedPlace&) const = default;
};

/// The only motion by which these bodies leave: a person has found it, or wants to keep it.
struct DemandedMotion {
  std::vector<std::string> bodies;
  std::vector<PathPoint> path;  ///< as AssemblyStep::path
  std::string method;           ///< kByHand, or that of the step that it was

  friend bool operator==(const DemandedMotion& a, const DemandedMotion& b);
};

/// A body does not move in this direction, nor in one within tolerance::kForbiddenCone of it, until it has left the
/// bodies that it touches (DirectionRule).
struct ForbiddenDirection {
  std::string body;
  Vector3 direction = Vector3::UnitZ();  ///< world frame, any length

  bool operator==(const ForbiddenDirection&) const = default;
};

/// The direction, of any length, is forbidden by one of these, which are of unit length.
bool isForbidden(const Vector3& direction, const std::vector<Vector3>& forbidden);

/// The places after a person has moved a step, as a list of steps is edited: locked steps keep theirs, the others make
/// way. `steps`: the bodies of each step of the plan, by id. The step `from` comes to stand at `to`, or, where a locked
/// one is there, beside it. Indices from 0. What is returned is the moved step and what was in `places`, ascending.
std::vector<DemandedPlace> movedTo(std::size_t to, std::size_t from, const std::vector<std::vector<std::string>>& steps,
                                   const std::vector<DemandedPlace>& places);

}  // namespace glissade
