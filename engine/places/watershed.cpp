#include <algorithm>
#include <numeric>

#include "engine/places/place_identifier.h"

namespace glissade {
namespace {

/// Share of the narrower basin's clearance from which the connection between two basins makes them one place. Places of
/// the paper have similar narrowness.
constexpr double kSameNarrowness = 0.7;
constexpr std::size_t kLeastBasinCells = 64;

/// Basins that are joined while the water level falls, each with the clearance of its widest point.
class Basins {
 public:
  int add(double peak) {
    parent_.push_back(static_cast<int>(parent_.size()));
    peak_.push_back(peak);
    return parent_.back();
  }
  int root(int basin) {
    while (parent_[at(basin)] != basin) basin = parent_[at(basin)] = parent_[at(parent_[at(basin)])];
    return basin;
  }
  double peak(int root) const { return peak_[at(root)]; }
  /// Joins two basins into the wider one, or into the older among equals.
  void join(int a, int b) {
    if (peak_[at(b)] > peak_[at(a)] || (peak_[at(b)] == peak_[at(a)] && b < a)) std::swap(a, b);
    parent_[at(b)] = a;
  }

 private:
  static std::size_t at(int basin) { return static_cast<std::size_t>(basin); }
  std::vector<int> parent_;
  std::vector<double> peak_;
};

}  // namespace

PlaceLabels watershed(const IdentificationInput& input) {
  const CellGrid& grid = input.space.grid;
  PlaceLabels labels = labelsOfPassages(input);
  const int passages = static_cast<int>(input.passages.size());
  std::vector<std::size_t> order;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (input.space.open(cell) && labels[cell] == kNoPlace) order.push_back(cell);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return input.clearance[a] > input.clearance[b]; });
  Basins basins;
  for (const std::size_t cell : order) {
    if (input.stop.stopRequested()) return labels;
    const double level = input.clearance[cell];
    std::vector<int> touching;
    grid.forEachNeighbour(cell, [&](std::size_t next) {
      if (labels[next] < passages) return;
      const int basin = basins.root(labels[next] - passages);
      if (std::find(touching.begin(), touching.end(), basin) == touching.end()) touching.push_back(basin);
    });
    std::sort(touching.begin(), touching.end(),
              [&](int a, int b) { return basins.peak(a) != basins.peak(b) ? basins.peak(a) > basins.peak(b) : a < b; });
    if (touching.empty()) touching.push_back(basins.add(level));
    for (std::size_t i = 1; i < touching.size(); ++i) {
      if (level >= kSameNarrowness * basins.peak(touching[i])) basins.join(touching[0], touching[i]);
    }
    labels[cell] = passages + touching[0];
  }
  for (int& label : labels) {
    if (label >= passages) label = passages + basins.root(label - passages);
  }
  tidyLabels(input.space, kLeastBasinCells, passages, labels);
  return labels;
}

}  // namespace glissade
