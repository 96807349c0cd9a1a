#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Author of the configuration from which a node was grown.
enum class Author : std::uint8_t { Computer, Operator, Contact };
inline constexpr EnumNames<Author, 3> kAuthorNames{{"computer", "operator", "contact"}};

/// One value for each Author.
template <class T>
using PerAuthor = std::array<T, 3>;

/// Root from which a node first grew; it decides the colour of the trees. Hand: a trail of the hand that began on its
/// own.
enum class TreeSide : std::uint8_t { Start, Goal, Hand };

struct RoadmapNode {
  Pose q;
  Author author = Author::Computer;
  TreeSide side = TreeSide::Start;
};

/// An undirected edge between node indices; the papers count it twice.
struct RoadmapEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// Nodes and edges appended since the chunk before; never changed once published. Node indices in
/// edges are global: chunk k's nodes follow those of the chunks before it.
struct RoadmapChunk {
  std::vector<RoadmapNode> nodes;
  std::vector<RoadmapEdge> edges;
};
using RoadmapChunks = std::vector<std::shared_ptr<const RoadmapChunk>>;

}  // namespace glissade
