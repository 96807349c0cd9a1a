#pragma once

#include <string>
#include <vector>

#include "engine/fits/assembled_product.h"
#include "engine/fits/joint.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade {

/// Groups of bodies, by name for people, that a plan handles as one although neither evidence nor a person says that
/// they are a unit (evidence::areOneUnit()). The judge's verdict on the plan is conditional on them.
struct StatedUnits {
  std::vector<std::vector<std::string>> leaving{};  ///< groups that leave, or remain of a group
  std::vector<std::string> base{};                  ///< the bodies that stay; empty: they need no statement
};

/// `words`: a person's statements about joints. `stay`: the bodies that a person fixes as base, by name.
StatedUnits statedUnitsOf(const AssemblyPlan& plan, const AssembledProduct& product,
                          const std::vector<JointEdit>& words, const std::vector<std::string>& stay);

}  // namespace glissade
