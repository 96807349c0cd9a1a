#include <algorithm>

#include "engine/places/place_identifier.h"

namespace glissade {
namespace {

/// Layers of cells by which a place grows at each level.
constexpr int kLayersPerLevel = 2;
/// Least number of finest cells of a place. Smaller places are merged with a neighbour.
constexpr std::size_t kLeastRegionCells = 64;

/// The aligned blocks of one level: blocks of free cells that have no label yet.
class LevelBlocks {
 public:
  LevelBlocks(const FreeSpace& space, int level, const PlaceLabels& labels)
      : grid_(space.grid), edge_(1 << static_cast<unsigned>(space.grid.level - level)) {
    for (std::size_t a = 0; a < 3; ++a) counts_[a] = grid_.counts[a] / edge_;
    free_.assign(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2], 1);
    for (std::size_t cell = 0; cell < labels.size(); ++cell) {
      const auto c = grid_.coordinates(cell);
      const std::array<int, 3> block{c[0] / edge_, c[1] / edge_, c[2] / edge_};
      if (!inside(block)) continue;
      if (!space.open(cell) || labels[cell] != kNoPlace) free_[at(block)] = 0;
    }
  }

  std::size_t size() const { return free_.size(); }
  bool free(std::size_t block) const { return free_[block] != 0; }
  void take(std::size_t block) { free_[block] = 0; }

  void paint(std::size_t block, int label, PlaceLabels& labels) const {
    forEachCell(block, [&](std::size_t cell) { labels[cell] = label; });
  }

  /// The lowest label among the cells that share a face with the block, from `first` on.
  int labelBeside(std::size_t block, int first, const PlaceLabels& labels) const {
    int lowest = kNoPlace;
    forEachCell(block, [&](std::size_t cell) {
      grid_.forEachNeighbour(cell, [&](std::size_t next) {
        const int label = labels[next];
        if (label >= first && (lowest == kNoPlace || label < lowest)) lowest = label;
      });
    });
    return lowest;
  }

  template <class Visit>
  void forEachNeighbour(std::size_t block, Visit&& visit) const {
    const auto b = coordinates(block);
    for (std::size_t a = 0; a < 3; ++a) {
      for (const int step : {-1, 1}) {
        auto next = b;
        next[a] += step;
        if (inside(next)) visit(at(next));
      }
    }
  }

 private:
  std::size_t at(const std::array<int, 3>& b) const {
    return (static_cast<std::size_t>(b[0]) * counts_[1] + b[1]) * counts_[2] + b[2];
  }
  std::array<int, 3> coordinates(std::size_t block) const {
    const int i = static_cast<int>(block);
    return {i / (counts_[1] * counts_[2]), i / counts_[2] % counts_[1], i % counts_[2]};
  }
  bool inside(const std::array<int, 3>& b) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (b[a] < 0 || b[a] >= counts_[a]) return false;
    }
    return true;
  }
  template <class Visit>
  void forEachCell(std::size_t block, Visit&& visit) const {
    const auto b = coordinates(block);
    for (int x = b[0] * edge_; x < (b[0] + 1) * edge_; ++x) {
      for (int y = b[1] * edge_; y < (b[1] + 1) * edge_; ++y) {
        for (int z = b[2] * edge_; z < (b[2] + 1) * edge_; ++z) visit(grid_.at(x, y, z));
      }
    }
  }

  const CellGrid& grid_;
  int edge_;
  std::array<int, 3> counts_{0, 0, 0};
  std::vector<char> free_;
};

/// Free cells connected to cells of upper levels join the place of those cells. `firstPlace` is the first label that is
/// not a passage: places do not grow out of passages.
void aggregate(LevelBlocks& blocks, int firstPlace, const StopToken& stop, PlaceLabels& labels) {
  for (int layer = 0; layer < kLayersPerLevel; ++layer) {
    std::vector<std::pair<std::size_t, int>> joining;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
      if (!blocks.free(block)) continue;
      if (stop.stopRequested()) return;
      const int label = blocks.labelBeside(block, firstPlace, labels);
      if (label != kNoPlace) joining.emplace_back(block, label);
    }
    for (const auto& [block, label] : joining) {
      blocks.paint(block, label, labels);
      blocks.take(block);
    }
  }
}

/// The remaining free cells form new places; connected cells form one place.
int initialise(LevelBlocks& blocks, int nextLabel, const StopToken& stop, PlaceLabels& labels) {
  for (std::size_t seed = 0; seed < blocks.size(); ++seed) {
    if (!blocks.free(seed)) continue;
    if (stop.stopRequested()) break;
    std::vector<std::size_t> connected{seed};
    blocks.take(seed);
    for (std::size_t i = 0; i < connected.size(); ++i) {
      blocks.paint(connected[i], nextLabel, labels);
      blocks.forEachNeighbour(connected[i], [&](std::size_t next) {
        if (!blocks.free(next)) return;
        blocks.take(next);
        connected.push_back(next);
      });
    }
    ++nextLabel;
  }
  return nextLabel;
}

}  // namespace

PlaceLabels growRegions(const IdentificationInput& input) {
  PlaceLabels labels = labelsOfPassages(input);
  const int passages = static_cast<int>(input.passages.size());
  int next = passages;
  for (int level = 1; level <= input.space.grid.level && !input.stop.stopRequested(); ++level) {
    LevelBlocks blocks(input.space, level, labels);
    aggregate(blocks, passages, input.stop, labels);
    next = initialise(blocks, next, input.stop, labels);
  }
  if (!input.stop.stopRequested()) tidyLabels(input.space, kLeastRegionCells, passages, labels);
  return labels;
}

}  // namespace glissade
