#pragma once

#include <string>
#include <vector>

#include "engine/check/evidence_names.h"
#include "engine/check/scenario_json.h"
#include "engine/evidence/body.h"

namespace glissade::check {

/// Geometry of each of an object's bodies, in their order.
using ObjectGeometry = std::vector<LoadedGeometryPtr>;

Pose unitRotation(const Pose& pose);

/// Adds each part of the geometry as a body at its pose in the scenario.
void addParts(const StatedScenario::StatedBody& stated, const LoadedGeometry& geometry, std::vector<Body>& bodies);

/// The object's bodies as one moving body, at the start.
Body objectOf(const StatedScenario& scenario, const ObjectGeometry& geometry);

/// The bodies of an object of several bodies as bodies of the product, at the start.
std::vector<Body> groupBodiesOf(const StatedScenario& scenario, const ObjectGeometry& geometry);

/// Merges the statements about the bodies of a group: the stricter one counts, or the one that is stated for each of
/// its bodies. This is the least allowance, and a clash that is accepted for all. Of kinds and threads the first one
/// counts. Statements about two bodies of the group are dropped.
FitWords wordsOfGroup(const FitWords& fits, const std::vector<Body>& group, const BodyId& groupId);

}  // namespace glissade::check
