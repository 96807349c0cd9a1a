#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/collision/kernel/placed_object.h"

namespace glissade {

/// A box of the obstacles and a box of the object that may be near each other.
struct BoxPair {
  BoxTree::Box obstacle = 0;
  BoxTree::Box object = 0;
};

/// Indices in the trees' lists of triangles.
struct TrianglePair {
  std::uint32_t obstacle = 0;
  std::uint32_t object = 0;
};

/// One thread's view of two trees at one pose, and the steps of every query. A pair of boxes that are not both leaves
/// is opened on the side of the larger one.
class PairTraversal {
 public:
  PairTraversal(const BoxTree& obstacles, const BoxTree& object, const lanes::LaneFunctions& functions)
      : object(object), placed(obstacles, object, functions), obstacles_(&obstacles), functions_(functions) {}

  const BoxTree& obstacles() const { return *obstacles_; }
  /// Replaces the obstacles' tree. The object must be moved afterwards.
  void setObstacles(const BoxTree& obstacles) {
    obstacles_ = &obstacles;
    placed.setObstacles(obstacles);
  }

  bool bothLeaves(const BoxPair& pair) const { return obstacles_->isLeaf(pair.obstacle) && object.isLeaf(pair.object); }

  /// The up to eight pairs below an opened pair.
  struct Opened {
    BoxPair first;
    bool obstacle;  ///< true: the lanes are boxes of the obstacle
    unsigned mask;  ///< bits of the used lanes

    BoxPair operator[](unsigned lane) const {
      return obstacle ? BoxPair{first.obstacle + lane, first.object} : BoxPair{first.obstacle, first.object + lane};
    }
  };
  Opened open(const BoxPair& pair) const {
    const bool obstacle =
        !obstacles_->isLeaf(pair.obstacle) &&
        (object.isLeaf(pair.object) || obstacles_->radius[pair.obstacle] >= object.radius[pair.object]);
    if (obstacle) {
      const std::uint32_t node = obstacles_->nodeOf(pair.obstacle);
      return {
          {static_cast<BoxTree::Box>(node * lanes::kWidth), pair.object}, true, (1U << obstacles_->counts[node]) - 1U};
    }
    const std::uint32_t node = object.nodeOf(pair.object);
    return {{pair.obstacle, static_cast<BoxTree::Box>(node * lanes::kWidth)}, false, (1U << object.counts[node]) - 1U};
  }

  /// Bits of the opened pairs that may be within `reach`, and separations for sorting them.
  unsigned within(const Opened& opened, float reach, float* separation);
  /// Bits of the opened pairs that may be nearer than `reach` at any time of the sweep.
  unsigned withinSweep(const Opened& opened, float reach);
  /// Lower bounds on the squared distances of the opened pairs.
  void distances(const Opened& opened, float* squared);

  /// Bits 4 k + i of the pairs of triangles of two leaves that may meet.
  unsigned mayMeet(const BoxPair& leaves);
  /// Bits 4 k + i of the pairs of triangles of two leaves that may be within `reach`.
  unsigned within(const BoxPair& leaves, float reach);
  /// Bits 4 k + i of the pairs of triangles of two leaves that may be nearer than `reach` at some time of the sweep;
  /// `byNearest`: see LaneFunctions.
  unsigned mayMeetInSweep(const BoxPair& leaves, float reach, bool byNearest);
  /// Largest motion of a box of the object in the sweep, and largest deviation of its points from a straight line.
  float wayOf(BoxTree::Box box) const {
    return placed.sweepOf(BoxTree::nodeAround(box)).length[BoxTree::laneOf(box)] + placed.sweepSlack();
  }
  float bendOf(BoxTree::Box box) const { return placed.sweepOf(BoxTree::nodeAround(box)).bend[BoxTree::laneOf(box)]; }
  /// Lower bounds on the squared distances, and estimates (LaneFunctions); unused places hold +infinity.
  struct LeafDistances {
    static constexpr std::size_t kPairs = std::size_t{lanes::kLeafTriangles} * lanes::kLeafTriangles;
    alignas(32) std::array<float, kPairs> squared;
    alignas(32) std::array<float, kPairs> estimate;
    std::uint32_t firstObstacle;
    std::uint32_t firstObject;

    TrianglePair operator[](std::size_t i) const {
      const auto at = static_cast<std::uint32_t>(i);
      return {firstObstacle + at % lanes::kLeafTriangles, firstObject + at / lanes::kLeafTriangles};
    }
  };
  LeafDistances triangleDistances(const BoxPair& leaves);
  /// Squared distances of up to four pairs of triangles, equal to those of triangleDistance.
  std::array<double, 4> exactDistances(std::span<const TrianglePair> pairs);

  const Triangle& obstacleTriangle(std::uint32_t index) const { return obstacles_->triangles[index].corners; }

  /// Number of pairs tested so far. Up to eight pairs of boxes, all triangles of two leaves, and four pairs of
  /// triangles count as one each.
  std::uint64_t pairs() const { return pairs_; }

  const BoxTree& object;
  PlacedObject placed;

 private:
  unsigned columnsOf(const BoxPair& leaves) const;

  const BoxTree* obstacles_;
  const lanes::LaneFunctions& functions_;
  std::uint64_t pairs_ = 0;
};

}  // namespace glissade
