#pragma once

#include <string>
#include <vector>

#include "engine/check/condition.h"
#include "engine/check/placed_bodies.h"
#include "engine/check/plan.h"

namespace glissade::check {

/// How the bodies of a plan leave.
struct Leaving {
  std::size_t alone = 0;                ///< or taken off the group that they have left with
  std::size_t asUnits = 0;              ///< with others that are handled as one
  std::size_t inGroups = 0;             ///< with others, and not taken apart
  std::size_t apart = 0;                ///< alone, or in what the plan says is a unit
  std::vector<Condition> conditions{};  ///< units that the plan states itself
};

/// A unit is what a person says is one, what is pressed into each other, or what the plan says is one: that is a
/// condition.
Leaving leavingOf(const Plan& plan, const Product& product, PlacedBodies& placed);

/// That the bodies of the plan's base stay, where it has several no person says that they stay, and they are no unit.
std::vector<Condition> baseOf(const Plan& plan, const Product& product, PlacedBodies& placed);

}  // namespace glissade::check
