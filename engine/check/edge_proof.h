#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/course.h"
#include "engine/check/piece_tree.h"

namespace glissade::check {

/// The smallest distance of two surfaces that was met on an edge.
struct MetOnEdge {
  double distance = std::numeric_limits<double>::infinity();
  double at = 0.0;  ///< place on the edge, in [0, 1]
  Vector3 onFixed = Vector3::Zero();
  Vector3 onMoving = Vector3::Zero();
};

/// Proves triangle by triangle that surfaces stay apart on one edge. Two triangles are apart in an interval of time if
/// a plane is between them at its middle, and the corners do not cross that plane in the interval: a corner that slides
/// along the plane hardly approaches it, however near the two are. An interval without a proof is halved. Pieces of the
/// surfaces are excluded together if balls about them stay apart.
class EdgeProof {
 public:
  /// Limit of the pairs of pieces that are compared for an edge; beyond it the edge is undecided.
  static constexpr std::uint64_t kMostCompared = 40'000'000;

  /// Refers to both arguments.
  EdgeProof(const Course& course, const StopToken& stop) : course_(course), turning_(course.turning()), stop_(stop) {
    timeAt(0.0, 1.0, 0);
  }

  enum class Answer { Apart, Near, Open };
  /// Apart: the distance of the two is at least `wanted` on the whole edge. Near: it is less at the place in `met`.
  /// Open: stopped, or neither was shown. `error`: rounding error of distances.
  Answer stayApart(const PieceTree& moving, const PieceTree& fixed, double wanted, double error, MetOnEdge& met);

 private:
  /// An interval of time. Intervals are stored, so that the surface is placed once for each.
  struct Time {
    double middle;
    double half;
    int halvings;
    Eigen::Isometry3d place;      ///< pose of the moving surface at the middle
    std::uint32_t firstHalf = 0;  ///< 0: the interval was not divided
    std::uint32_t secondHalf = 0;
  };
  struct Open {
    std::uint32_t moving;  ///< indices of nodes
    std::uint32_t fixed;
    std::uint32_t time;
  };

  std::uint32_t timeAt(double begin, double end, int halvings);
  void divide(std::uint32_t time);
  double apartAsBalls(const PieceTree::Node& moving, const PieceTree::Node& fixed, const Time& time) const;
  double motionOf(const PieceTree::Node& moving, const Time& time) const;
  double apart(const PieceTree::Triangle& moving, const PieceTree::Triangle& fixed, const Time& time, double enough,
               MetOnEdge& met) const;

  const Course& course_;
  Vector3 turning_;
  const StopToken& stop_;
  std::vector<Time> times_;
  std::uint64_t compared_ = 0;
};

}  // namespace glissade::check
