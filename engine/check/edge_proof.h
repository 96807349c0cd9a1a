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
  double at = 0.0;  ///< where on the edge, in [0, 1]
  Vector3 onFixed = Vector3::Zero();
  Vector3 onMoving = Vector3::Zero();
};

/// Proves that surfaces stay apart on one edge, triangle by triangle. Two triangles are apart in an interval of time
/// where a plane is between them at its middle, and the corners do not move across that plane by what is left: a
/// corner that slides along the plane hardly does, however near the two are. What is not proved so is halved. Pieces
/// of the surfaces are left out together where balls about them stay apart.
class EdgeProof {
 public:
  /// Pairs of pieces that are compared for an edge before it is given up as undecided.
  static constexpr std::uint64_t kMostCompared = 40'000'000;

  /// Refers to both.
  EdgeProof(const Course& course, const StopToken& stop) : course_(course), turning_(course.turning()), stop_(stop) {
    timeAt(0.0, 1.0, 0);
  }

  enum class Answer { Apart, Near, Open };
  /// Apart: the distance of the two is at least `wanted` on the whole edge. Near: it is less at the place that is
  /// written to `met`. Open: stopped, or neither was shown. `error`: of distances, by rounding.
  Answer stayApart(const PieceTree& moving, const PieceTree& fixed, double wanted, double error, MetOnEdge& met);

 private:
  /// An interval of time. They are kept, so that each is placed once.
  struct Time {
    double middle;
    double half;
    int halvings;
    Eigen::Isometry3d place;      ///< of the moving surface at the middle
    std::uint32_t firstHalf = 0;  ///< 0: it was not divided
    std::uint32_t secondHalf = 0;
  };
  struct Open {
    std::uint32_t moving;  ///< nodes
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
