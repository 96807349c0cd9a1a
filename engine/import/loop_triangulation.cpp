#include "engine/import/loop_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace glissade {
namespace {

double areaOf(const PlaneLoop& loop, const std::vector<PlanePoint>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += doubleArea(points[loop[0]], points[loop[i]], points[loop[i + 1]]);
  return sum;
}

bool isBetween(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  return doubleArea(a, b, p) == 0.0 && (p - a).dot(p - b) <= 0.0;
}

/// True if the segments have a point in common; segments with a common end do not count.
bool cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  if (a == c || a == d || b == c || b == d) return false;
  if (doubleArea(a, b, c) * doubleArea(a, b, d) < 0.0 && doubleArea(c, d, a) * doubleArea(c, d, b) < 0.0) return true;
  return isBetween(c, a, b) || isBetween(d, a, b) || isBetween(a, c, d) || isBetween(b, c, d);
}

/// Joins holes to the outer loop, each by a side that is used in both directions.
class HoleBridges {
 public:
  HoleBridges(const std::vector<PlanePoint>& points, std::vector<PlaneLoop> loops)
      : points_(points), holes_(std::move(loops)) {
    const auto largest = std::max_element(holes_.begin(), holes_.end(), [&](const PlaneLoop& a, const PlaneLoop& b) {
      return std::abs(areaOf(a, points_)) < std::abs(areaOf(b, points_));
    });
    outer_ = *largest;
    holes_.erase(largest);
    // Holes farther to the right are joined first, so that they do not hide the outer loop from other holes.
    std::stable_sort(holes_.begin(), holes_.end(), [&](const PlaneLoop& a, const PlaneLoop& b) {
      return points_[a[rightmostOf(a)]].x() > points_[b[rightmostOf(b)]].x();
    });
  }

  struct Joined {
    PlaneLoop loop;
    std::size_t forced = 0;  ///< number of bridges that cross a loop
  };

  std::optional<Joined> join() && {
    if (!(areaOf(outer_, points_) > 0.0)) return std::nullopt;
    for (std::size_t i = 0; i < holes_.size(); ++i) {
      if (areaOf(holes_[i], points_) > 0.0) return std::nullopt;
      joinHole(i);
    }
    return Joined{std::move(outer_), forced_};
  }

 private:
  std::size_t rightmostOf(const PlaneLoop& loop) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
      if (points_[loop[i]].x() > points_[loop[best]].x()) best = i;
    }
    return best;
  }

  /// Indices of a loop's points, sorted by a number.
  template <class Function>
  static std::vector<std::size_t> sorted(const PlaneLoop& loop, const Function& numberOf) {
    std::vector<std::size_t> order(loop.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return numberOf(loop[a]) < numberOf(loop[b]); });
    return order;
  }

  /// Joins the hole at the first of its points, from the right, that sees the outer loop; if loops cross, there may be
  /// none.
  void joinHole(std::size_t index) {
    const std::vector<std::size_t> starts =
        sorted(holes_[index], [&](std::uint32_t point) { return -points_[point].x(); });
    for (std::size_t i = 0; i < std::min(kMostStarts, starts.size()); ++i) {
      const std::size_t start = starts[i];
      const PlanePoint& from = points_[holes_[index][start]];
      const std::vector<std::size_t> ends = nearestFirst(from);
      const auto seen = std::find_if(ends.begin(), ends.end(), [&](std::size_t at) { return sees(at, from, index); });
      if (seen == ends.end()) continue;
      addBridge(holes_[index], start, *seen);
      return;
    }
    ++forced_;
    addBridge(holes_[index], starts.front(), nearestFirst(points_[holes_[index][starts.front()]]).front());
  }

  /// Points of the outer loop, the nearest first.
  std::vector<std::size_t> nearestFirst(const PlanePoint& from) const {
    return sorted(outer_, [&](std::uint32_t point) { return (points_[point] - from).squaredNorm(); });
  }

  void addBridge(const PlaneLoop& hole, std::size_t start, std::size_t end) {
    PlaneLoop bridge{hole.begin() + static_cast<std::ptrdiff_t>(start), hole.end()};
    bridge.insert(bridge.end(), hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(start) + 1);
    bridge.push_back(outer_[end]);
    outer_.insert(outer_.begin() + static_cast<std::ptrdiff_t>(end) + 1, bridge.begin(), bridge.end());
  }

  bool sees(std::size_t at, const PlanePoint& from, std::size_t hole) const {
    const PlanePoint& to = points_[outer_[at]];
    if (!isInside(at, from) || crosses(outer_, from, to)) return false;
    for (std::size_t i = hole; i < holes_.size(); ++i) {
      if (crosses(holes_[i], from, to)) return false;
    }
    return true;
  }

  /// True if the point is within the corner of the outer loop.
  bool isInside(std::size_t at, const PlanePoint& p) const {
    const PlanePoint& before = points_[outer_[(at + outer_.size() - 1) % outer_.size()]];
    const PlanePoint& corner = points_[outer_[at]];
    const PlanePoint& after = points_[outer_[(at + 1) % outer_.size()]];
    if (doubleArea(before, corner, after) >= 0.0)
      return doubleArea(corner, p, before) > 0.0 && doubleArea(p, corner, after) > 0.0;
    return !(doubleArea(corner, p, after) >= 0.0 && doubleArea(p, corner, before) >= 0.0);
  }

  bool crosses(const PlaneLoop& loop, const PlanePoint& from, const PlanePoint& to) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (cross(from, to, points_[loop[i]], points_[loop[(i + 1) % loop.size()]])) return true;
    }
    return false;
  }

  const std::vector<PlanePoint>& points_;
  PlaneLoop outer_;
  std::vector<PlaneLoop> holes_;  ///< holes that are not joined yet come last
  std::size_t forced_ = 0;

  static constexpr std::size_t kMostStarts = 50;  ///< a search over all points takes too long
};

/// Triangulates a loop by cutting off ears.
class EarCutting {
 public:
  EarCutting(const std::vector<PlanePoint>& points, PlaneLoop loop) : points_(points), left_(std::move(loop)) {}

  /// Nothing if loops cross in so many places that the search takes too long.
  std::optional<LoopTriangles> run() && {
    constexpr double kMostTests = 2e9;  // tests of a corner against an ear
    const double tests = static_cast<double>(left_.size()) * static_cast<double>(left_.size());
    while (left_.size() > 3) {
      cut(nextEar());
      if (static_cast<double>(result_.forced) * tests > kMostTests) return std::nullopt;
    }
    if (doubleArea(at(0), at(1), at(2)) < 0.0) ++result_.forced;
    cut(1);
    return std::move(result_);
  }

 private:
  const PlanePoint& at(std::size_t i) const { return points_[left_[i % left_.size()]]; }

  std::size_t nextEar() {
    std::optional<std::size_t> flat;
    std::size_t shortest = 0;
    double length = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const std::size_t ear = (next_ + i) % left_.size();
      const PlanePoint& before = at(ear + left_.size() - 1);
      const PlanePoint& after = at(ear + 1);
      const double size = doubleArea(before, at(ear), after);
      if (size > 0.0 && isEmpty(ear)) return ear;
      if (size == 0.0 && !flat) flat = ear;
      if (size > 0.0 && (after - before).norm() < length) {
        length = (after - before).norm();
        shortest = ear;
      }
    }
    if (flat) return *flat;
    ++result_.forced;
    return shortest;
  }

  /// True if no other corner is in the ear; corners that coincide with one of its corners do not count.
  bool isEmpty(std::size_t ear) const {
    const PlanePoint& a = at(ear + left_.size() - 1);
    const PlanePoint& b = at(ear);
    const PlanePoint& c = at(ear + 1);
    for (std::size_t i = ear + 2; i < ear + left_.size() - 1; ++i) {
      const PlanePoint& p = at(i);
      if (p == a || p == b || p == c) continue;
      if (doubleArea(a, b, p) >= 0.0 && doubleArea(b, c, p) >= 0.0 && doubleArea(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  void cut(std::size_t ear) {
    const std::size_t count = left_.size();
    result_.triangles.push_back({left_[(ear + count - 1) % count], left_[ear], left_[(ear + 1) % count]});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear % count));
    next_ = ear;
  }

  const std::vector<PlanePoint>& points_;
  PlaneLoop left_;        ///< remaining corners, in order
  std::size_t next_ = 0;  ///< first corner of the next search
  LoopTriangles result_;
};

}  // namespace

std::optional<LoopTriangles> triangulateLoops(const std::vector<PlanePoint>& points, std::vector<PlaneLoop> loops) {
  constexpr std::size_t kMostPoints = 10'000;
  if (loops.empty() || points.size() > kMostPoints) return std::nullopt;
  if (std::any_of(loops.begin(), loops.end(), [](const PlaneLoop& loop) { return loop.size() < 3; })) {
    return std::nullopt;
  }
  auto joined = HoleBridges(points, std::move(loops)).join();
  if (!joined) return std::nullopt;
  auto result = EarCutting(points, std::move(joined->loop)).run();
  if (result) result->forced += joined->forced;
  return result;
}

}  // namespace glissade
