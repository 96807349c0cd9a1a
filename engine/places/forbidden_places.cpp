#include "engine/places/forbidden_places.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "engine/places/edit_binding.h"

namespace glissade {
namespace {

using Index = std::array<int, 3>;

/// Cells from `least` to `most`, both included.
struct Block {
  Index least;
  Index most;
};

/// Calls visit(index) for each cell of a block until it returns false. Returns true if it never did.
template <class Visit>
bool forEach(const Block& block, const Visit& visit) {
  for (int x = block.least[0]; x <= block.most[0]; ++x) {
    for (int y = block.least[1]; y <= block.most[1]; ++y) {
      for (int z = block.least[2]; z <= block.most[2]; ++z) {
        if (!visit(Index{x, y, z})) return false;
      }
    }
  }
  return true;
}

/// Covers a set of cells with blocks. Every group of up to 2 x 2 x 2 neighbours in the set lies in a block.
class BlockCover {
 public:
  BlockCover(const CellGrid& grid, const std::vector<std::size_t>& cells)
      : grid_(grid), wanted_(grid.size(), false), covered_(grid.size(), 0) {
    for (const std::size_t cell : cells) wanted_[cell] = true;
  }

  std::vector<Block> blocks(const std::vector<std::size_t>& cells) {
    // Groups of many cells come first, so that their parts need not be tested again.
    for (int size = 7; size >= 0; --size) {
      for (const std::size_t cell : cells) addFrom(cell, size);
    }
    return blocks_;
  }

 private:
  /// The group at a cell. Bit `axis` of `size` states that the group has two cells along the axis.
  static Block groupAt(const Index& least, int size) {
    Block group{least, least};
    for (int axis = 0; axis < 3; ++axis) group.most[static_cast<std::size_t>(axis)] += size >> axis & 1;
    return group;
  }

  bool isWanted(const Block& block) const {
    return grid_.contains(block.least) && grid_.contains(block.most) &&
           forEach(block, [&](const Index& at) { return wanted_[grid_.at(at[0], at[1], at[2])]; });
  }

  void addFrom(std::size_t cell, int size) {
    if ((covered_[cell] >> size & 1U) != 0) return;
    const Block group = groupAt(grid_.coordinates(cell), size);
    if (!isWanted(group)) return;
    const Block block = grown(group);
    blocks_.push_back(block);
    forEach(block, [&](const Index& at) {
      for (int within = 0; within < 8; ++within) {
        const Index most = groupAt(at, within).most;
        const bool inside = most[0] <= block.most[0] && most[1] <= block.most[1] && most[2] <= block.most[2];
        if (inside) covered_[grid_.at(at[0], at[1], at[2])] |= static_cast<std::uint8_t>(1U << within);
      }
      return true;
    });
  }

  /// Extends a block by one layer on each of the six sides in turn, as long as possible.
  Block grown(Block block) const {
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Block layer = block;
        layer.least[axis] = layer.most[axis] = block.most[axis] + 1;
        if (isWanted(layer)) {
          ++block.most[axis];
          grows = true;
        }
        layer.least[axis] = layer.most[axis] = block.least[axis] - 1;
        if (isWanted(layer)) {
          --block.least[axis];
          grows = true;
        }
      }
    }
    return block;
  }

  const CellGrid& grid_;
  std::vector<bool> wanted_;
  std::vector<std::uint8_t> covered_;  ///< groups whose least corner is the cell, as bits by size, for each cell
  std::vector<Block> blocks_;
};

/// The box of a block. Neighbours have exactly the same coordinate for the plane between them.
Box3 boxOf(const CellGrid& grid, const Block& block) {
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    box.min()[axis] = grid.frame.origin[axis] + grid.cellSize() * block.least[a];
    box.max()[axis] = grid.frame.origin[axis] + grid.cellSize() * (block.most[a] + 1);
  }
  return box;
}

/// The edit's statement about its place; nothing where there is none.
std::optional<bool> forbids(const PlaceEdit& edit) {
  const auto found = edit.attributes.find("forbidden");
  if (found == edit.attributes.end()) return std::nullopt;
  const bool* value = std::get_if<bool>(&found->second);
  return value == nullptr ? std::nullopt : std::make_optional(*value);
}

}  // namespace

bool operator==(const ForbiddenPlace& a, const ForbiddenPlace& b) {
  return a.name == b.name &&
         std::equal(a.boxes.begin(), a.boxes.end(), b.boxes.begin(), b.boxes.end(),
                    [](const Box3& one, const Box3& two) { return one.min() == two.min() && one.max() == two.max(); });
}

bool forbidsPlaces(const SemanticEdits& edits) {
  return std::any_of(edits.places.begin(), edits.places.end(),
                     [](const PlaceEdit& edit) { return forbids(edit).value_or(false); });
}

Result<ForbiddenPlaces> forbiddenPlacesOf(const TopologicalMap& map, const SemanticEdits& edits) {
  std::vector<bool> forbidden(map.places.size(), false);
  std::vector<std::string> names;
  for (const Place& place : map.places) names.push_back(place.name);
  for (std::size_t i = 0; i < edits.places.size(); ++i) {
    const PlaceEdit& edit = edits.places[i];
    const int place = boundPlace(map, edit.at);
    const auto said = forbids(edit);
    if (place == kNoPlace && said.value_or(false)) {
      return Diagnostic{ErrorKind::MalformedInput, "", "/places/" + std::to_string(i),
                        GLISSADE_TEXT("forbids a place that is not there: its point lies in no place and near none"),
                        GLISSADE_TEXT("Forbid the place where it is now, or remove this edit.")};
    }
    if (place == kNoPlace) continue;
    const auto p = static_cast<std::size_t>(place);
    if (!edit.name.empty()) names[p] = edit.name;
    if (said) forbidden[p] = *said;
  }
  ForbiddenPlaces places;
  for (std::size_t p = 0; p < map.places.size(); ++p) {
    if (forbidden[p]) places.push_back({names[p], boxesOfCells(map.grid, map.places[p].cells)});
  }
  return places;
}

std::vector<Box3> boxesOfCells(const CellGrid& grid, const std::vector<std::size_t>& cells) {
  std::vector<Box3> boxes;
  for (const Block& block : BlockCover(grid, cells).blocks(cells)) boxes.push_back(boxOf(grid, block));
  return boxes;
}

}  // namespace glissade
