#include "engine/check/edge_proof.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/triangle_pair.h"

namespace glissade::check {
namespace {

/// Share by which bounds are lowered to cover their rounding.
constexpr double kProjectionRounding = 1e-9;
/// Limit of the halvings of an interval of time, given by the precision of numbers.
constexpr int kShortestTime = 48;
constexpr std::uint64_t kComparedBetweenStops = 1024;
/// Triangles can meet if their distance is less than this share of the gap of a plane between them.
constexpr double kSeparatedShare = 0.5;

/// Motion of corners from the middle of an interval to its ends.
struct CornerMoves {
  Corners straight;              ///< displacements along their velocities
  std::array<double, 3> beside;  ///< bounds on the distance of the corners from those displacements
};

CornerMoves still() { return {{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()}, {0.0, 0.0, 0.0}}; }

/// Lower bound on the gap between the moving corners and the others along the unit direction in the whole interval;
/// negative if none is shown.
double apartAlong(const Vector3& direction, const Corners& others, const Corners& moving, const CornerMoves& moves) {
  const double none = std::numeric_limits<double>::infinity();
  double low = none;
  double high = -none;
  double lowest = none;
  double highest = -none;
  for (std::size_t i = 0; i < 3; ++i) {
    const double other = direction.dot(others[i] - others[0]);
    low = std::min(low, other);
    high = std::max(high, other);
    const double height = direction.dot(moving[i] - others[0]);
    const double across = std::abs(direction.dot(moves.straight[i])) + moves.beside[i];
    lowest = std::min(lowest, height - across);
    highest = std::max(highest, height + across);
  }
  return std::max(lowest - high, low - highest);
}

}  // namespace

std::uint32_t EdgeProof::timeAt(double begin, double end, int halvings) {
  const double middle = 0.5 * (begin + end);
  times_.push_back({middle, 0.5 * (end - begin), halvings, course_.at(middle)});
  return static_cast<std::uint32_t>(times_.size() - 1);
}

void EdgeProof::divide(std::uint32_t time) {
  if (times_[time].firstHalf != 0) return;
  const auto [middle, half, halvings, place, unused, none] = times_[time];
  times_[time].firstHalf = timeAt(middle - half, middle, halvings + 1);
  times_[time].secondHalf = timeAt(middle, middle + half, halvings + 1);
}

/// Upper bound on the distance of a point of the piece from its place at the middle of the interval.
double EdgeProof::motionOf(const PieceTree::Node& moving, const Time& time) const {
  const Vector3 arm = time.place * moving.middle - time.place.translation();
  const double turning = turning_.norm();
  const Vector3 turned = turning_.cross(arm);
  const double straight = (course_.way() + turned).norm() + turning * moving.radius;
  const double beside = 0.5 * time.half * turning * (turned.norm() + turning * moving.radius);
  const double most = course_.way().norm() + turned.norm() + turning * moving.radius;
  return time.half * std::min(straight + beside, most);
}

double EdgeProof::apartAsBalls(const PieceTree::Node& moving, const PieceTree::Node& fixed, const Time& time) const {
  return fixed.box.exteriorDistance(Vector3(time.place * moving.middle)) - moving.radius - motionOf(moving, time);
}

/// Lower bound on the distance in the whole interval, at most `enough`. A point on a circle deviates from its tangent
/// by half of the square of the angle, times the radius. In the frame of the moving triangle, the corners of the fixed
/// one move in the opposite direction, on a line that turns in that frame.
double EdgeProof::apart(const PieceTree::Triangle& moving, const PieceTree::Triangle& fixed, const Time& time,
                        double enough, MetOnEdge& met) const {
  const double angle = time.half * turning_.norm();
  const auto movesOf = [&](const Corners& corners, double besides) {
    CornerMoves moves;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 turned = turning_.cross(corners[i] - time.place.translation());
      moves.straight[i] = time.half * (course_.way() + turned);
      moves.beside[i] = 0.5 * angle * time.half * (turned.norm() + besides);
    }
    return moves;
  };
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = time.place * moving.corners[i];
  const CornerMoves moves = movesOf(corners, 0.0);
  double shown = apartAlong(fixed.normal, fixed.corners, corners, moves);
  if (shown >= enough) return shown;
  const CornerMoves seenFromMoving = movesOf(fixed.corners, (2.0 + angle) * course_.way().norm());
  shown = std::max(shown, apartAlong(time.place.linear() * moving.normal, corners, fixed.corners, seenFromMoving));
  if (shown >= enough) return shown;
  const TriangleDistance nearest = triangleDistance(corners, fixed.corners);
  met = {std::sqrt(nearest.squared), time.middle, nearest.onB, nearest.onA};
  if (met.distance > 0.0) {
    const Vector3 between = (nearest.onA - nearest.onB) / met.distance;
    shown = std::max(shown, apartAlong(between, fixed.corners, corners, moves));
    const bool separated = apartAlong(between, fixed.corners, corners, still()) >= kSeparatedShare * met.distance;
    if (!separated && trianglesMeet(corners, fixed.corners)) met.distance = 0.0;
  }
  return shown;
}

EdgeProof::Answer EdgeProof::stayApart(const PieceTree& moving, const PieceTree& fixed, double wanted, double error,
                                       MetOnEdge& met) {
  if (moving.empty() || fixed.empty()) return Answer::Apart;
  const double enough = (wanted + error) * (1.0 + 2.0 * kProjectionRounding);
  std::vector<Open> open{{0, 0, 0}};
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    if (++compared_ > kMostCompared) return Answer::Open;
    if (compared_ % kComparedBetweenStops == 0 && stop_.stopRequested()) return Answer::Open;
    const PieceTree::Node& one = moving.nodes()[next.moving];
    const PieceTree::Node& other = fixed.nodes()[next.fixed];
    if (apartAsBalls(one, other, times_[next.time]) >= enough) continue;
    bool dividesTime = one.isLeaf && other.isLeaf;
    if (dividesTime) {
      MetOnEdge found;
      const Time& time = times_[next.time];
      if (apart(moving.triangles()[one.first], fixed.triangles()[other.first], time, enough, found) >= enough) continue;
      found.distance = std::max(0.0, found.distance * (1.0 - kProjectionRounding) - error);
      if (found.distance < wanted) {
        met = found;
        return Answer::Near;
      }
      if (time.halvings == kShortestTime) return Answer::Open;
    } else {
      const double motion = motionOf(one, times_[next.time]);
      dividesTime = motion > std::max(one.radius, other.radius) && times_[next.time].halvings < kShortestTime;
    }
    if (dividesTime) {
      divide(next.time);
      open.push_back({next.moving, next.fixed, times_[next.time].secondHalf});
      open.push_back({next.moving, next.fixed, times_[next.time].firstHalf});
    } else if (other.isLeaf || (!one.isLeaf && one.radius >= other.radius)) {
      open.push_back({one.first, next.fixed, next.time});
      open.push_back({one.second, next.fixed, next.time});
    } else {
      open.push_back({next.moving, other.first, next.time});
      open.push_back({next.moving, other.second, next.time});
    }
  }
  return Answer::Apart;
}

}  // namespace glissade::check
