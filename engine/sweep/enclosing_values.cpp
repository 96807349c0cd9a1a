#include "engine/sweep/enclosing_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/base/stop_token.h"
#include "engine/base/thread_team.h"
#include "engine/geometry/pose.h"
#include "engine/sweep/helper_threads.h"
#include "engine/sweep/kuhn_division.h"

namespace glissade {
namespace {

/// A ball that the body never enters.
struct FreeBall {
  Vector3 middle;
  double radius;
};

/// A tetrahedron with values at its corners, linear in between.
struct ValuedTetrahedron {
  std::array<Vector3, 4> corners;
  std::array<double, 4> values;
};

/// The value where the edge from a corner outside the ball to one inside enters the ball.
double valueAtEntry(const ValuedTetrahedron& tetrahedron, std::size_t outer, std::size_t inner, const FreeBall& ball) {
  const Vector3 edge = tetrahedron.corners[inner] - tetrahedron.corners[outer];
  const Vector3 from = tetrahedron.corners[outer] - ball.middle;
  const double a = edge.squaredNorm();
  const double b = from.dot(edge);
  const double c = from.squaredNorm() - ball.radius * ball.radius;
  const double share = std::clamp((-b - std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
  return tetrahedron.values[outer] + share * (tetrahedron.values[inner] - tetrahedron.values[outer]);
}

/// The largest value outside the ball, `limit` or more where it is more than the limit. What is above a level is
/// convex, with its corners on the edges of the tetrahedron. So the largest value is on an edge, too.
double largestOutside(const ValuedTetrahedron& tetrahedron, const FreeBall& ball, double limit) {
  std::array<bool, 4> within{};
  double largest = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    within[i] = (tetrahedron.corners[i] - ball.middle).squaredNorm() <= ball.radius * ball.radius;
    if (!within[i]) largest = std::max(largest, tetrahedron.values[i]);
  }
  if (largest >= limit) return largest;
  for (std::size_t inner = 0; inner < 4; ++inner) {
    for (std::size_t outer = 0; outer < 4; ++outer) {
      // Values grow towards the inside only where that corner's is the larger one, and matter where they are above.
      if (!within[inner] || within[outer] || tetrahedron.values[inner] <= largest) continue;
      largest = std::max(largest, valueAtEntry(tetrahedron, outer, inner, ball));
    }
  }
  return largest;
}

/// The least level, not below 0, above which all of the tetrahedron lies in one of the balls. The largest of the values
/// where there is no such level below that.
double certifiedLevel(const ValuedTetrahedron& tetrahedron, const std::vector<FreeBall>& balls) {
  double level = std::max(0.0, *std::max_element(tetrahedron.values.begin(), tetrahedron.values.end()));
  for (const FreeBall& ball : balls) {
    if (level <= 0.0) break;
    level = std::min(level, largestOutside(tetrahedron, ball, level));
  }
  return level;
}

/// The edges of Kuhn's division at the points of a lattice.
class KuhnEdges {
 public:
  explicit KuhnEdges(const Lattice& lattice) : lattice_(lattice) {
    for (std::size_t corner = 1; corner < edges_.size(); ++corner) {
      const std::array<int, 3> step{static_cast<int>(corner >> 2), static_cast<int>(corner >> 1 & 1),
                                    static_cast<int>(corner & 1)};
      edges_[corner] = {step, lattice.at(step[0], step[1], step[2]),
                        std::sqrt(static_cast<double>(step[0] + step[1] + step[2]))};
    }
  }

  /// Calls visit(neighbour, length) for the other ends of the edges at a point; the length in spacings.
  template <class Visit>
  void forEachNeighbour(std::size_t point, const Visit& visit) const {
    const auto at = lattice_.coordinates(point);
    bool isInner = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      isInner = isInner && at[axis] > 0 && at[axis] + 1 < lattice_.counts[axis];
    for (std::size_t corner = 1; corner < edges_.size(); ++corner) {
      const Edge& edge = edges_[corner];
      if (isInner || hasEnd(at, edge.step, 1)) visit(point + edge.stride, edge.length);
      if (isInner || hasEnd(at, edge.step, -1)) visit(point - edge.stride, edge.length);
    }
  }

 private:
  struct Edge {
    std::array<int, 3> step;
    std::size_t stride = 0;
    double length = 0.0;  ///< spacings
  };

  bool hasEnd(const std::array<int, 3>& at, const std::array<int, 3>& step, int sign) const {
    return lattice_.has({at[0] + sign * step[0], at[1] + sign * step[1], at[2] + sign * step[2]});
  }

  const Lattice& lattice_;
  std::array<Edge, 8> edges_{};  ///< by corner of a cell
};

/// The points, as true, that are connected with the first point of the lattice along edges that `joins` accepts:
/// joins(point, neighbour, length in spacings). Precondition: less than 2^32 points. Unfinished after a stop.
template <class Joins>
std::vector<bool> connectedWithTheRim(const Lattice& lattice, const StopToken& stop, const Joins& joins) {
  constexpr std::size_t kPointsBetweenLooks = 4096;
  std::vector<bool> connected(lattice.size(), false);
  const KuhnEdges edges(lattice);
  std::vector<std::uint32_t> open{0};
  connected[0] = true;
  for (std::size_t taken = 0; !open.empty(); ++taken) {
    if (taken % kPointsBetweenLooks == 0 && stop.stopRequested()) break;
    const std::size_t point = open.back();
    open.pop_back();
    edges.forEachNeighbour(point, [&](std::size_t next, double length) {
      if (connected[next] || !joins(point, next, length)) return;
      connected[next] = true;
      open.push_back(static_cast<std::uint32_t>(next));
    });
  }
  return connected;
}

/// Spacings: as far as balls reach, and the points from which they are taken.
constexpr int kNear = static_cast<int>(SweepClearances::kReach);

/// A step from a point of the lattice to another one.
struct Step {
  std::array<int, 3> by;
  double length;  ///< spacings
};

/// Steps to the points at most `reach` spacings from `about`, which is in spacings from the point where they begin.
std::vector<Step> stepsAround(const Vector3& about, double reach) {
  std::vector<Step> steps;
  for (int x = -kNear; x <= kNear + 1; ++x) {
    for (int y = -kNear; y <= kNear + 1; ++y) {
      for (int z = -kNear; z <= kNear + 1; ++z) {
        const Vector3 by(x, y, z);
        if ((by - about).norm() <= reach) steps.push_back({{x, y, z}, by.norm()});
      }
    }
  }
  return steps;
}

class Encloser {
 public:
  Encloser(const Lattice& lattice, const std::vector<float>& clearances, const WorkWatch& watch)
      : lattice_(lattice), clearances_(clearances), watch_(watch) {}

  EnclosingValues enclose() {
    EnclosingValues result;
    // The balls at both ends overlap: no surface passes between them.
    result.outside =
        connectedWithTheRim(lattice_, watch_.stop, [&](std::size_t point, std::size_t next, double length) {
          return static_cast<double>(clearances_[point]) + clearances_[next] > length * lattice_.spacing;
        });
    outside_ = &result.outside;
    values_ = clearances_;
    inPlanes(0, lattice_.counts[0], 1, [&](int x) { lowerInside(x); });
    lowering_.assign(lattice_.size(), 0.0F);
    // Cells of every other plane of cells have no points in common.
    for (const int first : {0, 1}) inPlanes(first, lattice_.counts[0] - 1, 2, [&](int x) { certifyCells(x); });
    for (std::size_t point = 0; point < values_.size(); ++point) values_[point] -= lowering_[point];
    fillCavities();
    result.values = std::move(values_);
    return result;
  }

 private:
  template <class Take>
  void inPlanes(int first, int end, int step, const Take& take) {
    ThreadTeam team(helperThreads());
    const int count = std::max(0, (end - first + step - 1) / step);
    team.run(static_cast<std::size_t>(count), [&](std::size_t plane) {
      if (!watch_.stop.stopRequested()) take(first + step * static_cast<int>(plane));
    });
  }

  template <class Visit>
  void forEachInPlane(int x, int less, const Visit& visit) const {
    for (int y = 0; y < lattice_.counts[1] - less; ++y) {
      for (int z = 0; z < lattice_.counts[2] - less; ++z) visit(std::array<int, 3>{x, y, z});
    }
  }

  /// Calls visit(point) for the outside points at these steps.
  template <class Visit>
  void forEachOutside(const std::array<int, 3>& from, const std::vector<Step>& steps, const Visit& visit) const {
    for (const Step& step : steps) {
      const std::array<int, 3> at{from[0] + step.by[0], from[1] + step.by[1], from[2] + step.by[2]};
      if (!lattice_.has(at)) continue;
      const std::size_t point = lattice_.at(at[0], at[1], at[2]);
      if ((*outside_)[point]) visit(step, point);
    }
  }

  /// Inside points get their depth below the balls of the outside ones.
  void lowerInside(int x) {
    forEachInPlane(x, 0, [&](const std::array<int, 3>& at) {
      const std::size_t point = lattice_.at(at[0], at[1], at[2]);
      if ((*outside_)[point]) return;
      double depth = SweepClearances::kReach * lattice_.spacing;
      if (isBesideOutside(point)) {
        forEachOutside(at, aroundPoint_, [&](const Step& step, std::size_t other) {
          depth = std::min(depth, step.length * lattice_.spacing - clearances_[other]);
        });
      }
      values_[point] = -static_cast<float>(std::max(0.0, depth));
    });
  }

  bool isBesideOutside(std::size_t point) const {
    bool beside = false;
    edges_.forEachNeighbour(point, [&](std::size_t next, double) { beside = beside || (*outside_)[next]; });
    return beside;
  }

  void certifyCells(int x) {
    std::vector<FreeBall> balls;
    forEachInPlane(x, 1, [&](const std::array<int, 3>& at) {
      if (!asksForBalls(at)) return;
      balls.clear();
      forEachOutside(at, aroundCell_, [&](const Step& step, std::size_t point) {
        balls.push_back({Vector3(step.by[0], step.by[1], step.by[2]), clearances_[point] / lattice_.spacing});
      });
      for (const TetrahedronCorners& corners : kKuhnTetrahedra) certify(at, corners, balls);
    });
  }

  /// Some corners are outside, and none has a ball that holds all of the cell.
  bool asksForBalls(const std::array<int, 3>& at) const {
    bool some = false;
    for (int corner = 0; corner < 8; ++corner) {
      const std::size_t point = lattice_.cornerAt(at, corner);
      if (!(*outside_)[point]) continue;
      if (clearances_[point] >= kCellDiagonal * lattice_.spacing) return false;
      some = true;
    }
    return some;
  }

  /// In spacings, from the first point of the cell.
  void certify(const std::array<int, 3>& at, const TetrahedronCorners& corners, const std::vector<FreeBall>& balls) {
    ValuedTetrahedron tetrahedron;
    for (std::size_t i = 0; i < 4; ++i) {
      tetrahedron.corners[i] = Vector3(corners[i] >> 2, corners[i] >> 1 & 1, corners[i] & 1);
      tetrahedron.values[i] = values_[lattice_.cornerAt(at, corners[i])] / lattice_.spacing;
    }
    const double level = certifiedLevel(tetrahedron, balls);
    if (level <= 0.0) return;
    const auto lowering = static_cast<float>((level + kRounding) * lattice_.spacing);
    for (const int corner : corners) {
      float& known = lowering_[lattice_.cornerAt(at, corner)];
      known = std::max(known, lowering);
    }
  }

  /// Points above the level that are not connected with the rim by others are enclosed.
  void fillCavities() {
    const std::vector<bool> open = connectedWithTheRim(
        lattice_, watch_.stop, [&](std::size_t, std::size_t next, double) { return values_[next] > 0.0F; });
    for (std::size_t point = 0; point < values_.size(); ++point) {
      if (!open[point]) values_[point] = std::min(values_[point], 0.0F);
    }
  }

  static constexpr double kCellDiagonal = 1.7320509;
  static constexpr double kRounding = 2e-6;  ///< spacings: more than values in single precision round to

  const Lattice& lattice_;
  const std::vector<float>& clearances_;
  const WorkWatch& watch_;
  const std::vector<bool>* outside_ = nullptr;
  KuhnEdges edges_{lattice_};
  std::vector<float> values_;
  std::vector<float> lowering_;
  std::vector<Step> aroundPoint_ = stepsAround(Vector3::Zero(), SweepClearances::kReach);
  std::vector<Step> aroundCell_ = stepsAround(Vector3::Constant(0.5), SweepClearances::kReach);
};

}  // namespace

EnclosingValues enclosingValues(const Lattice& lattice, const SweepClearances& clearances, const WorkWatch& watch) {
  return Encloser(lattice, clearances.values, watch).enclose();
}

}  // namespace glissade
