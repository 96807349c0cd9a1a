#include "engine/collision/kernel/pair_traversal.h"

#include <algorithm>
#include <limits>

namespace glissade {

unsigned PairTraversal::within(const Opened& opened, float reach, float* separation) {
  ++pairs_;
  const lanes::BoxLanes& obstacle = obstacles_->nodes[BoxTree::nodeAround(opened.first.obstacle)];
  const lanes::BoxLanes& moved = placed.node(BoxTree::nodeAround(opened.first.object));
  const unsigned near = opened.obstacle
                            ? functions_.boxesWithin(obstacle, moved, BoxTree::laneOf(opened.first.object),
                                                     placed.slack(), reach, separation)
                            : functions_.boxesWithin(moved, obstacle, BoxTree::laneOf(opened.first.obstacle),
                                                     placed.slack(), reach, separation);
  return near & opened.mask;
}

unsigned PairTraversal::withinSweep(const Opened& opened, float reach) {
  ++pairs_;
  const std::uint32_t index = BoxTree::nodeAround(opened.first.object);
  const lanes::BoxLanes& obstacle = obstacles_->nodes[BoxTree::nodeAround(opened.first.obstacle)];
  const lanes::BoxLanes& moved = placed.node(index);
  const lanes::SweepLanes& sweep = placed.sweepOf(index);
  const float slack = placed.slack() + placed.sweepSlack();
  const unsigned near = opened.obstacle
                            ? functions_.boxesWithinSweep(obstacle, moved, BoxTree::laneOf(opened.first.object), sweep,
                                                          false, slack, reach)
                            : functions_.boxesWithinSweep(moved, obstacle, BoxTree::laneOf(opened.first.obstacle),
                                                          sweep, true, slack, reach);
  return near & opened.mask;
}

void PairTraversal::distances(const Opened& opened, float* squared) {
  ++pairs_;
  const lanes::BoxLanes& obstacle = obstacles_->nodes[BoxTree::nodeAround(opened.first.obstacle)];
  const lanes::BoxLanes& moved = placed.node(BoxTree::nodeAround(opened.first.object));
  if (opened.obstacle) {
    functions_.boxDistances(obstacle, moved, BoxTree::laneOf(opened.first.object), placed.slack(), squared);
  } else {
    functions_.boxDistances(moved, obstacle, BoxTree::laneOf(opened.first.obstacle), placed.slack(), squared);
  }
}

/// Bits of the triangles in two leaves.
unsigned PairTraversal::columnsOf(const BoxPair& leaves) const {
  const unsigned rows = (1U << (lanes::kLeafTriangles * object.leafOf(leaves.object).count)) - 1U;
  return rows & (((1U << obstacles_->leafOf(leaves.obstacle).count) - 1U) * 0x1111U);
}

unsigned PairTraversal::mayMeet(const BoxPair& leaves) {
  ++pairs_;
  lanes::TriangleLanes moved;
  placed.leaf(leaves.object, moved);
  return functions_.trianglesMayMeet(obstacles_->leafOf(leaves.obstacle).lanes, moved,
                                     object.leafOf(leaves.object).count, placed.slack()) &
         columnsOf(leaves);
}

unsigned PairTraversal::within(const BoxPair& leaves, float reach) {
  ++pairs_;
  lanes::TriangleLanes moved;
  placed.leaf(leaves.object, moved);
  return functions_.trianglesWithin(obstacles_->leafOf(leaves.obstacle).lanes, moved,
                                    object.leafOf(leaves.object).count, placed.slack(), reach) &
         columnsOf(leaves);
}

unsigned PairTraversal::mayMeetInSweep(const BoxPair& leaves, float reach, bool byNearest) {
  ++pairs_;
  lanes::TriangleLanes moved;
  lanes::TriangleLanes ways;
  placed.leaf(leaves.object, moved);
  placed.sweepTriangles(moved, ways);
  return functions_.trianglesMayMeetInSweep(obstacles_->leafOf(leaves.obstacle).lanes, moved, ways,
                                            object.leafOf(leaves.object).count, placed.slack() + placed.sweepSlack(),
                                            reach, byNearest) &
         columnsOf(leaves);
}

PairTraversal::LeafDistances PairTraversal::triangleDistances(const BoxPair& leaves) {
  ++pairs_;
  const BoxTree::Leaf& obstacle = obstacles_->leafOf(leaves.obstacle);
  const BoxTree::Leaf& moved = object.leafOf(leaves.object);
  lanes::TriangleLanes lanesOfMoved;
  placed.leaf(leaves.object, lanesOfMoved);
  LeafDistances result;
  result.firstObstacle = obstacle.first;
  result.firstObject = moved.first;
  functions_.triangleDistances(obstacle.lanes, lanesOfMoved, moved.count, placed.slack(), result.squared.data(),
                               result.estimate.data());
  for (std::size_t i = 0; i < LeafDistances::kPairs; ++i) {
    if (i % lanes::kLeafTriangles < obstacle.count && i / lanes::kLeafTriangles < moved.count) continue;
    result.squared[i] = result.estimate[i] = std::numeric_limits<float>::infinity();
  }
  return result;
}

std::array<double, 4> PairTraversal::exactDistances(std::span<const TrianglePair> pairs) {
  ++pairs_;
  lanes::TrianglePairLanes lanes;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const TrianglePair& pair = pairs[std::min(lane, pairs.size() - 1)];
    const Triangle& a = obstacleTriangle(pair.obstacle);
    const Triangle b = placed.triangle(pair.object);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (int i = 0; i < 3; ++i) {
        lanes.a[corner][i][lane] = a[corner][i];
        lanes.b[corner][i][lane] = b[corner][i];
      }
    }
  }
  std::array<double, 4> squared;
  functions_.exactDistances(lanes, squared.data());
  return squared;
}

}  // namespace glissade
