#include "engine/places/place_identifier.h"

#include <algorithm>
#include <map>

namespace glissade {

const PlaceIdentifierEntry* PlaceIdentifierRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

PlaceIdentifierRegistry makePlaceIdentifierRegistry() {
  PlaceIdentifierRegistry registry;
  registry.add({"region-growing", GLISSADE_TEXT("Region growing"),
                GLISSADE_TEXT("Grows places from the coarsest free cells down (Cailhol et al. 2019, section 5.1.2)."),
                growRegions});
  registry.add({"watershed", GLISSADE_TEXT("Watershed"),
                GLISSADE_TEXT("Floods the distance transform from its widest spots (Meyer 1994)."), watershed});
  return registry;
}

PlaceLabels labelsOfPassages(const IdentificationInput& input) {
  PlaceLabels labels(input.space.grid.size(), kNoPlace);
  for (std::size_t i = 0; i < input.passages.size(); ++i) {
    for (const std::size_t cell : input.passages[i].cells) labels[cell] = static_cast<int>(i);
  }
  return labels;
}

namespace {

/// Gives free cells without a label the label of a neighbour, layer by layer.
void fillFromNeighbours(const FreeSpace& space, PlaceLabels& labels) {
  std::vector<std::size_t> front;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] != kNoPlace) front.push_back(cell);
  }
  for (std::size_t i = 0; i < front.size(); ++i) {
    space.grid.forEachNeighbour(front[i], [&](std::size_t next) {
      if (!space.open(next) || labels[next] != kNoPlace) return;
      labels[next] = labels[front[i]];
      front.push_back(next);
    });
  }
}

std::vector<std::size_t> sizesOf(const PlaceLabels& labels) {
  std::vector<std::size_t> sizes;
  for (const int label : labels) {
    if (label == kNoPlace) continue;
    if (static_cast<std::size_t>(label) >= sizes.size()) sizes.resize(static_cast<std::size_t>(label) + 1);
    ++sizes[static_cast<std::size_t>(label)];
  }
  return sizes;
}

/// Number of faces shared by each pair of labels, lower label first.
std::map<std::pair<int, int>, std::size_t> sharedFaces(const FreeSpace& space, const PlaceLabels& labels) {
  std::map<std::pair<int, int>, std::size_t> faces;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] == kNoPlace) continue;
    space.grid.forEachNeighbour(cell, [&](std::size_t next) {
      if (next > cell && labels[next] != kNoPlace && labels[next] != labels[cell]) {
        ++faces[std::minmax(labels[cell], labels[next])];
      }
    });
  }
  return faces;
}

}  // namespace

void tidyLabels(const FreeSpace& space, std::size_t leastCells, int keep, PlaceLabels& labels) {
  fillFromNeighbours(space, labels);
  std::vector<std::size_t> sizes = sizesOf(labels);
  const auto faces = sharedFaces(space, labels);
  std::vector<int> target(sizes.size());
  for (std::size_t label = 0; label < sizes.size(); ++label) {
    target[label] = static_cast<int>(label);
    if (static_cast<int>(label) < keep || sizes[label] >= leastCells) continue;
    std::size_t most = 0;
    for (const auto& [pair, count] : faces) {
      const int own = static_cast<int>(label);
      if (pair.first != own && pair.second != own) continue;
      const int other = pair.first == own ? pair.second : pair.first;
      // Only towards larger places, so that no two small ones exchange labels; passages keep their shape.
      const auto o = static_cast<std::size_t>(other);
      const bool larger = sizes[o] > sizes[label] || (sizes[o] == sizes[label] && other < own);
      if (other >= keep && larger && count > most) {
        most = count;
        target[label] = other;
      }
    }
  }
  const auto rootOf = [&](int label) {
    while (target[static_cast<std::size_t>(label)] != label) label = target[static_cast<std::size_t>(label)];
    return label;
  };
  std::vector<int> number(sizes.size(), kNoPlace);
  int next = 0;
  for (std::size_t label = 0; label < sizes.size(); ++label) {
    const bool root = target[label] == static_cast<int>(label);
    if (root && (static_cast<int>(label) < keep || sizes[label] > 0)) number[label] = next++;
  }
  for (int& label : labels) {
    if (label != kNoPlace) label = number[static_cast<std::size_t>(rootOf(label))];
  }
}

}  // namespace glissade
