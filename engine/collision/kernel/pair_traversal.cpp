#include "engine/collision/kernel/pair_traversal.h"

#include <limits>

namespace glissade {

PairTraversal::Opened PairTraversal::open(const BoxPair& pair) const {
  const bool obstacle = !obstacles.isLeaf(pair.obstacle) &&
                        (object.isLeaf(pair.object) || obstacles.radius[pair.obstacle] >= object.radius[pair.object]);
  if (obstacle) {
    const std::uint32_t node = obstacles.nodeOf(pair.obstacle);
    return {{static_cast<BoxTree::Box>(node * lanes::kWidth), pair.object}, true, obstacles.counts[node]};
  }
  const std::uint32_t node = object.nodeOf(pair.object);
  return {{pair.obstacle, static_cast<BoxTree::Box>(node * lanes::kWidth)}, false, object.counts[node]};
}

unsigned PairTraversal::within(const Opened& opened, float reach) {
  const lanes::BoxLanes& obstacle = obstacles.nodes[BoxTree::nodeAround(opened.first.obstacle)];
  const lanes::BoxLanes& moved = placed.node(BoxTree::nodeAround(opened.first.object));
  const unsigned near =
      opened.obstacle
          ? functions_.boxesWithin(obstacle, moved, BoxTree::laneOf(opened.first.object), placed.slack(), reach)
          : functions_.boxesWithin(moved, obstacle, BoxTree::laneOf(opened.first.obstacle), placed.slack(), reach);
  return near & ((1U << opened.lanes) - 1U);
}

void PairTraversal::distances(const Opened& opened, float* squared) {
  const lanes::BoxLanes& obstacle = obstacles.nodes[BoxTree::nodeAround(opened.first.obstacle)];
  const lanes::BoxLanes& moved = placed.node(BoxTree::nodeAround(opened.first.object));
  if (opened.obstacle) {
    functions_.boxDistances(obstacle, moved, BoxTree::laneOf(opened.first.object), placed.slack(), squared);
  } else {
    functions_.boxDistances(moved, obstacle, BoxTree::laneOf(opened.first.obstacle), placed.slack(), squared);
  }
}

unsigned PairTraversal::mayMeet(const BoxPair& leaves) {
  const BoxTree::Leaf& obstacle = obstacles.leafOf(leaves.obstacle);
  lanes::TriangleLanes moved;
  placed.leaf(leaves.object, moved);
  const unsigned rows = (1U << (lanes::kLeafTriangles * object.leafOf(leaves.object).count)) - 1U;
  const unsigned columns = ((1U << obstacle.count) - 1U) * 0x1111U;
  return functions_.trianglesMayMeet(obstacle.lanes, moved, placed.slack()) & rows & columns;
}

void PairTraversal::triangleDistances(const BoxPair& leaves, float* squared) {
  const BoxTree::Leaf& obstacle = obstacles.leafOf(leaves.obstacle);
  lanes::TriangleLanes moved;
  placed.leaf(leaves.object, moved);
  functions_.triangleDistances(obstacle.lanes, moved, placed.slack(), squared);
  const std::uint32_t rows = object.leafOf(leaves.object).count;
  for (std::uint32_t k = 0; k < lanes::kLeafTriangles; ++k) {
    for (std::uint32_t i = 0; i < lanes::kLeafTriangles; ++i) {
      if (k >= rows || i >= obstacle.count) {
        squared[k * lanes::kLeafTriangles + i] = std::numeric_limits<float>::infinity();
      }
    }
  }
}

}  // namespace glissade
