#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/environment/free_space.h"
#include "engine/environment/passages.h"

namespace glissade {

/// Which place each cell of a grid belongs to; kNoPlace where static bodies are.
using PlaceLabels = std::vector<int>;
inline constexpr int kNoPlace = -1;

/// What an identification starts from.
struct IdentificationInput {
  const FreeSpace& space;
  const std::vector<double>& clearance;  ///< distanceTransform(space)
  const std::vector<Passage>& passages;  ///< findPassages(space): each is a place already
  StopToken stop = {};                   ///< ends the identification; labels are unfinished then
};

/// A way to divide the free space into places (paper 2, section 5.1.2: "the modular architecture
/// allows defining new place identification"). Labels begin with the passages, in their order, and
/// go on without gaps. The same input gives the same labels.
struct PlaceIdentifierEntry {
  std::string id;
  std::string label;        ///< in the window
  std::string description;  ///< one sentence with the source
  std::function<PlaceLabels(const IdentificationInput&)> identify;
};

class PlaceIdentifierRegistry {
 public:
  void add(PlaceIdentifierEntry entry) { entries_.push_back(std::move(entry)); }
  /// Null where the id is unknown.
  const PlaceIdentifierEntry* find(std::string_view id) const;
  const std::vector<PlaceIdentifierEntry>& entries() const { return entries_; }

 private:
  std::vector<PlaceIdentifierEntry> entries_;
};

PlaceIdentifierRegistry makePlaceIdentifierRegistry();

/// Region growing from the coarsest free cells down (paper 2, section 5.1.2 and figure 12).
/// Deviations: doorways are places from the outset, because octree cells find a hole only where it
/// happens to lie well in the grid; a place grows by two layers of cells a level instead of one, so
/// that the skin along an oblique wall does not become a place.
PlaceLabels growRegions(const IdentificationInput& input);

/// Watershed of the distance transform (Meyer 1994): places are the basins around the widest spots,
/// joined where the way between them is nearly as wide. Linear in the cells but for one sort.
PlaceLabels watershed(const IdentificationInput& input);

/// Labels with the passages set and everything else kNoPlace.
PlaceLabels labelsOfPassages(const IdentificationInput& input);

/// Gives labels smaller than `leastCells` to the neighbour they share most faces with, and free cells
/// without a label to the label they touch; then renumbers so that there are no gaps. The first
/// `keep` labels stay as they are.
void tidyLabels(const FreeSpace& space, std::size_t leastCells, int keep, PlaceLabels& labels);

}  // namespace glissade
