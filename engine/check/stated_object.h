#pragma once

#include <string>
#include <vector>

#include "engine/check/body.h"
#include "engine/check/scenario_json.h"

namespace glissade::check {

/// Of an object's bodies, in their order.
using ObjectGeometry = std::vector<LoadedGeometryPtr>;

Pose unitRotation(const Pose& pose);

/// Adds each part of the geometry as a body where the scenario has it.
void addParts(const StatedScenario::StatedBody& stated, const LoadedGeometry& geometry, std::vector<Body>& bodies);

/// The object's bodies as the one that moves, at the start.
Body objectOf(const StatedScenario& scenario, const ObjectGeometry& geometry);

/// The bodies of an object of several as bodies of the product, where they start.
std::vector<Body> groupBodiesOf(const StatedScenario& scenario, const ObjectGeometry& geometry);

/// What a person says of the bodies of a group, as said of the group: what asks for more, or is said of each of its
/// bodies. So it is the least allowance, and a clash that is accepted for all. Of kinds and threads the first one
/// counts. What is between two of its bodies is about nothing.
FitWords wordsOfGroup(const FitWords& fits, const std::vector<Body>& group, const std::string& groupId);

}  // namespace glissade::check
