#pragma once

#include "engine/scenario/scenario.h"

namespace glissade {

/// The demands of the scenario, and what the attributes of its bodies say (class, mass, fragile, base, stays,
/// goes_with, goes_before, needs_tool): rigid bodies have the attributes of the scenario's body that they are part of
/// and of their assemblies, and those of its class where it says nothing itself. The user's own attributes are there
/// for costs. Errors, MalformedInput: a class that there is not, classes whose parents are wrong.
Result<SequenceDemands> knownDemands(const Scenario& scenario, const AssembledProduct& product);

/// The class of each of these bodies, as their attributes state it; empty where they state none.
std::vector<std::string> classesOf(const SemanticEdits& edits, const std::vector<RigidBody>& bodies);

}  // namespace glissade
