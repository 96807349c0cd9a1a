#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/places/attribute.h"
#include "engine/places/topological_map.h"

namespace glissade {

/// A place that a person forbids: the object's reference point keeps out of its boxes, which are closed. World frame.
struct ForbiddenPlace {
  std::string name;
  std::vector<Box3> boxes;
};
using ForbiddenPlaces = std::vector<ForbiddenPlace>;

bool operator==(const ForbiddenPlace& a, const ForbiddenPlace& b);

/// True if an edit forbids a place.
bool forbidsPlaces(const SemanticEdits& edits);

/// The forbidden places, in the order of the map, with the cells that belong to them (Place::cells). A cell belongs to
/// one place; overlaps of borders only matter for milestones. The same map and edits give the same boxes. Errors,
/// MalformedInput with a JSON pointer into a scenario: an edit forbids a place that does not exist.
Result<ForbiddenPlaces> forbiddenPlacesOf(const TopologicalMap& map, const SemanticEdits& edits);

/// A small number of boxes that cover exactly these cells (ascending). A face, an edge or a corner that only these
/// cells surround is inside one box.
std::vector<Box3> boxesOfCells(const CellGrid& grid, const std::vector<std::size_t>& cells);

}  // namespace glissade
