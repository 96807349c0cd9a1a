#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/oracle/joint_oracle.h"

namespace glissade::oracle {

/// Pairs of bodies that touch or overlap where the product is assembled, by id.
using StatedContacts = std::vector<std::pair<std::string, std::string>>;

/// The violations for which an assembler would refuse the order of a plan, as texts; empty: none. Lines of groups are
/// judged, too.
/// - bodies are put into the air: they touch no body that is there, are joined to none, and touch one in the product
/// - a stack is split: between a nut and its bolt a body is put in that is neither of the stack nor clamped by it, or
///   the two follow each other and are not one step
std::vector<std::string> orderViolationsOf(const StatedLine& plan, const std::vector<StatedJoint>& joints,
                                           const StatedContacts& contacts);

/// Reads the file that `glissade-cli fits --json` writes. Throws std::runtime_error.
StatedContacts readStatedContacts(const std::string& file);

}  // namespace glissade::oracle
