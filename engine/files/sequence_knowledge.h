#pragma once

#include "engine/files/scenario.h"

namespace glissade {

/// The demands of the scenario, with the attributes of its bodies (class, mass, fragile, base, stays, goes_with,
/// goes_before, needs_tool). A rigid body has the attributes of the scenario's body that contains it and of its
/// assemblies, and those of its class where it does not set them itself. The user's own attributes are included for
/// costs. Errors, MalformedInput: an unknown class, classes with wrong parents.
Result<SequenceDemands> knownDemands(const Scenario& scenario, const AssembledProduct& product);

/// The class of each body from its attributes; empty where it has none.
std::vector<std::string> classesOf(const SemanticEdits& edits, const std::vector<RigidBody>& bodies);

}  // namespace glissade
