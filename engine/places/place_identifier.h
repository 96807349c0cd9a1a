#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/message.h"
#include "engine/places/free_space.h"
#include "engine/places/passages.h"

namespace glissade {

/// Label of the place of each cell of a grid; kNoPlace for cells with static bodies.
using PlaceLabels = std::vector<int>;
inline constexpr int kNoPlace = -1;

/// Input of an identification.
struct IdentificationInput {
  const FreeSpace& space;
  const std::vector<double>& clearance;  ///< result of distanceTransform(space)
  const std::vector<Passage>& passages;  ///< result of findPassages(space): each is a place already
  StopToken stop = {};                   ///< ends the identification, which leaves the labels unfinished
};

/// A way to divide the free space into places (paper 2, section 5.1.2: "the modular architecture
/// allows defining new place identification"). Labels begin with the passages, in their order, and
/// go on without gaps. The same input gives the same labels.
struct PlaceIdentifierEntry {
  std::string id;
  CatalogueText label;        ///< name in the window
  CatalogueText description;  ///< one sentence with the source
  std::function<PlaceLabels(const IdentificationInput&)> identify;
};

class PlaceIdentifierRegistry {
 public:
  void add(PlaceIdentifierEntry entry) { entries_.push_back(std::move(entry)); }
  /// The entry of an id; null where it is unknown.
  const PlaceIdentifierEntry* find(std::string_view id) const;
  const std::vector<PlaceIdentifierEntry>& entries() const { return entries_; }

 private:
  std::vector<PlaceIdentifierEntry> entries_;
};

PlaceIdentifierRegistry makePlaceIdentifierRegistry();

/// Region growing from the coarsest free cells to the finest (paper 2, section 5.1.2 and figure 12). Deviations:
/// doorways are places from the beginning, because octree cells find a hole only where its position fits the grid; a
/// place grows by two layers of cells at each level instead of one, so that the layer along an oblique wall does not
/// become a place.
PlaceLabels growRegions(const IdentificationInput& input);

/// Watershed of the distance transform (Meyer 1994): places are the basins around the widest points, joined where the
/// connection between them is nearly as wide. Linear in the cells except for one sort.
PlaceLabels watershed(const IdentificationInput& input);

/// Labels of the passages; all other cells are kNoPlace.
PlaceLabels labelsOfPassages(const IdentificationInput& input);

/// Gives the cells of labels smaller than `leastCells` to the neighbour with which they share most faces, and free
/// cells without a label to an adjacent label; then renumbers the labels without gaps. The first `keep` labels are
/// unchanged.
void tidyLabels(const FreeSpace& space, std::size_t leastCells, int keep, PlaceLabels& labels);

}  // namespace glissade
