#pragma once

#include "engine/base/diagnostic.h"
#include "engine/environment/attribute.h"
#include "engine/environment/topological_map.h"

namespace glissade {

/// The place that an edit at this point is about: the one that holds the point, else that of the nearest cell, as long
/// as it is no farther than the place's half width (a body may have come to stand where the place was widest).
/// kNoPlace: none.
int boundPlace(const TopologicalMap& map, const Vector3& at);

/// The borders that a milestone at this point is for: those whose overlap holds the point, else the nearest one, as
/// long as it is no farther than half the width of the narrower of its places. Empty: none.
std::vector<int> boundBorders(const TopologicalMap& map, const Vector3& at);

/// The edits without those of places and milestones that count nowhere.
SemanticEdits withoutStrays(const TopologicalMap& map, SemanticEdits edits);

/// What of the edits counts nowhere, or elsewhere than where it is, and names and places that are given twice. Their
/// places are JSON pointers into a scenario.
Warnings editWarnings(const TopologicalMap& map, const SemanticEdits& edits);

}  // namespace glissade
