#pragma once

#include <string>
#include <vector>

#include "engine/check/condition.h"
#include "engine/check/evidence_names.h"
#include "engine/check/plan.h"
#include "engine/evidence/placed_bodies.h"

namespace glissade::check {

/// Numbers of bodies by the way in which they leave a plan.
struct Leaving {
  std::size_t alone = 0;     ///< bodies that leave alone, or are taken off the group with which they have left
  std::size_t asUnits = 0;   ///< bodies that leave with others that are handled as one
  std::size_t inGroups = 0;  ///< bodies that leave in a group that is not taken apart
  std::size_t apart = 0;     ///< bodies that leave alone, or in a unit by a person's or the plan's statement
  std::vector<Condition> conditions{};  ///< units that only the plan states
};

/// A unit is a group that a person or the plan calls a unit, or parts that are pressed into each other. A unit by the
/// plan's statement is a condition.
Leaving leavingOf(const Plan& plan, const Product& product, PlacedBodies& placed);

/// The condition that the bodies of the plan's base stay, if there are several, no person says so, and they are no
/// unit.
std::vector<Condition> baseOf(const Plan& plan, const Product& product, PlacedBodies& placed);

}  // namespace glissade::check
