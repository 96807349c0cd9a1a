#pragma once

#include "engine/base/diagnostic.h"
#include "engine/places/attribute.h"
#include "engine/places/topological_map.h"

namespace glissade {

/// The place to which an edit at this point belongs: the one that holds the point, else that of the nearest cell, if it
/// is no farther than the place's half width (a body may now stand where the place was widest). kNoPlace: none.
int boundPlace(const TopologicalMap& map, const Vector3& at);

/// The borders to which a milestone at this point belongs: those whose overlap holds the point, else the nearest one,
/// if it is no farther than half the width of the narrower of its places. Empty: none.
std::vector<int> boundBorders(const TopologicalMap& map, const Vector3& at);

/// The edits without those of places and milestones that belong to no place or border.
SemanticEdits withoutStrays(const TopologicalMap& map, SemanticEdits edits);

/// Warnings about edits that have no effect or belong to a place elsewhere, and about names and places with two edits.
/// Their locations are JSON pointers into a scenario.
Warnings editWarnings(const TopologicalMap& map, const SemanticEdits& edits);

}  // namespace glissade
