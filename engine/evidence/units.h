#pragma once

#include <string>
#include <vector>

#include "engine/evidence/placed_bodies.h"
#include "engine/model/body_id.h"

namespace glissade::evidence {

/// True if these hold all of the bodies together, so that they are handled as one: units that a person states (`said`,
/// bodies by id), bodies that are pressed into each other, inserts and bearings in their holes, and rolling bearings
/// that are drawn with their balls or rollers. The one definition: plans say what is a unit by it, and the judge, too.
bool areOneUnit(const std::vector<const Body*>& bodies, const std::vector<std::vector<BodyId>>& said,
                PlacedBodies& placed);

}  // namespace glissade::evidence
