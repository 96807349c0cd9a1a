#include "tests/oracle/exact_judge.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace glissade::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Largest cosine of half the angle at which the sense of a turn is decided by rounding.
constexpr double kOpenSense = 1e-14;

double cosineOfHalfTheTurn(const Placement& a, const Placement& b) {
  double cosine = 0.0;
  for (std::size_t i = 0; i < 4; ++i) cosine += a.orientation[i] * b.orientation[i];
  return cosine;
}

Kernel::Point_3 exact(const Point& p) { return {p[0], p[1], p[2]}; }

struct Box {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};

  void add(const Point& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  bool meets(const Box& other) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (high[i] < other.low[i] || other.high[i] < low[i]) return false;
    }
    return true;
  }
  bool contains(const Point& p) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] < low[i] || high[i] < p[i]) return false;
    }
    return true;
  }
};

Box boxOf(const Triangle& triangle) {
  Box box;
  for (const Point& p : triangle) box.add(p);
  return box;
}

bool trianglesMeet(const Triangle& a, const Triangle& b) {
  return CGAL::do_intersect(Kernel::Triangle_3(exact(a[0]), exact(a[1]), exact(a[2])),
                            Kernel::Triangle_3(exact(b[0]), exact(b[1]), exact(b[2])));
}

/// +1 or -1 if the segment crosses the triangle's inside, 0 if it misses the triangle, nothing if it touches the
/// border, begins on the triangle, or ends in its plane. A segment that begins elsewhere in the plane does not meet the
/// plane again; coincident walls put many corners into the planes of distant triangles.
std::optional<int> crossing(const Point& from, const Point& to, const Triangle& t) {
  const auto p = exact(from), q = exact(to), a = exact(t[0]), b = exact(t[1]), c = exact(t[2]);
  const auto sideOfFrom = CGAL::orientation(a, b, c, p);
  const auto sideOfTo = CGAL::orientation(a, b, c, q);
  if (sideOfTo == CGAL::COPLANAR) return std::nullopt;
  if (sideOfFrom == CGAL::COPLANAR) {
    return Kernel::Triangle_3(a, b, c).has_on(p) ? std::nullopt : std::optional(0);
  }
  if (sideOfFrom == sideOfTo) return 0;
  const auto ab = CGAL::orientation(p, q, a, b);
  const auto bc = CGAL::orientation(p, q, b, c);
  const auto ca = CGAL::orientation(p, q, c, a);
  const bool within = (ab != CGAL::NEGATIVE && bc != CGAL::NEGATIVE && ca != CGAL::NEGATIVE) ||
                      (ab != CGAL::POSITIVE && bc != CGAL::POSITIVE && ca != CGAL::POSITIVE);
  if (!within) return 0;
  if (ab == CGAL::COPLANAR || bc == CGAL::COPLANAR || ca == CGAL::COPLANAR) return std::nullopt;
  return sideOfFrom == CGAL::NEGATIVE ? 1 : -1;
}

double pointSegment(const Point& p, const Point& a, const Point& b) {
  const Point edge = b - a;
  const double squared = dot(edge, edge);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, edge) / squared, 0.0, 1.0) : 0.0;
  return length(p - (a + t * edge));
}

double pointTriangle(const Point& p, const Triangle& t) {
  const Point normal = cross(t[1] - t[0], t[2] - t[0]);
  bool above = length(normal) > 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& a = t[i];
    const Point& b = t[(i + 1) % 3];
    above = above && dot(cross(normal, b - a), p - a) >= 0.0;
    nearest = std::min(nearest, pointSegment(p, a, b));
  }
  return above ? std::abs(dot(normal, p - t[0])) / length(normal) : nearest;
}

/// One corner of every connected part of the surface; corners with equal coordinates are identical.
std::vector<Point> partPoints(const Triangles& triangles) {
  std::map<Point, std::size_t> index;
  std::vector<std::size_t> parent;
  const auto rootOf = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Triangle& triangle : triangles) {
    for (const Point& p : triangle) {
      if (index.try_emplace(p, parent.size()).second) parent.push_back(parent.size());
    }
    for (const Point& p : triangle) parent[rootOf(index[p])] = rootOf(index[triangle[0]]);
  }
  std::vector<Point> points;
  for (const auto& [p, i] : index) {
    if (rootOf(i) == i) points.push_back(p);
  }
  return points;
}

}  // namespace

struct ExactJudge::Solid {
  Triangles triangles;
  std::vector<Box> boxes;
  std::vector<Point> parts;
  Box box;

  Solid(Triangles all, std::vector<Point> pointOfEachPart)
      : triangles(std::move(all)), parts(std::move(pointOfEachPart)) {
    for (const Triangle& triangle : triangles) {
      boxes.push_back(boxOf(triangle));
      for (const Point& p : triangle) box.add(p);
    }
  }

  /// True if the winding number of the surface about the point is not 0. Undefined on the surface.
  bool contains(const Point& p) const {
    if (!box.contains(p)) return false;
    const double size = length(box.high - box.low);
    for (int attempt = 0; attempt < 64; ++attempt) {
      const double around = 0.7 + 2.39996 * attempt;
      const double height = -0.95 + 1.9 * attempt / 63.0;
      const Point far = p + (3.0 * size) * Point{std::cos(around), std::sin(around), height};
      if (const auto winding = crossings(p, far)) return *winding != 0;
    }
    return true;
  }

  std::optional<int> crossings(const Point& p, const Point& far) const {
    int sum = 0;
    for (const Triangle& triangle : triangles) {
      const auto one = crossing(p, far, triangle);
      if (!one) return std::nullopt;
      sum += *one;
    }
    return sum;
  }

  double surfaceDistance(const Point& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : triangles) nearest = std::min(nearest, pointTriangle(p, triangle));
    return nearest;
  }

  double deepestOf(const Solid& other) const {
    double deepest = 0.0;
    for (const Triangle& triangle : other.triangles) {
      for (const Point& p : triangle) {
        if (contains(p)) deepest = std::max(deepest, surfaceDistance(p));
      }
    }
    return deepest;
  }

  bool surfaceMeets(const Solid& other) const {
    if (!box.meets(other.box)) return false;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (!boxes[i].meets(other.box)) continue;
      for (std::size_t k = 0; k < other.triangles.size(); ++k) {
        if (boxes[i].meets(other.boxes[k]) && trianglesMeet(triangles[i], other.triangles[k])) return true;
      }
    }
    return false;
  }

  bool containsAPartOf(const Solid& other) const {
    return std::any_of(other.parts.begin(), other.parts.end(), [&](const Point& p) { return contains(p); });
  }
};

ExactJudge::ExactJudge(Scene scene) : scene_(std::move(scene)), parts_(partPoints(scene_.object)) {
  for (const Triangles& body : scene_.bodies) bodies_.emplace_back(body, partPoints(body));
  for (const Triangle& triangle : scene_.object) {
    for (const Point& p : triangle) radius_ = std::max(radius_, length(p));
  }
}

ExactJudge::~ExactJudge() = default;

ExactJudge::Solid ExactJudge::objectAt(const Placement& pose) const {
  std::vector<Point> parts;
  for (const Point& p : parts_) parts.push_back(placed(pose, p));
  return {placed(pose, scene_.object), std::move(parts)};
}

bool ExactJudge::penetrates(const Placement& pose) const {
  const Solid object = objectAt(pose);
  return std::any_of(bodies_.begin(), bodies_.end(), [&](const Solid& body) {
    return body.surfaceMeets(object) || body.containsAPartOf(object) || object.containsAPartOf(body);
  });
}

double ExactJudge::depthAt(const Placement& pose) const {
  const Solid object = objectAt(pose);
  double deepest = 0.0;
  for (const Solid& body : bodies_) deepest = std::max({deepest, body.deepestOf(object), object.deepestOf(body)});
  return deepest;
}

void ExactJudge::judge(const std::vector<Placement>& path, double step, int mostSamples, Verdict& verdict) const {
  for (std::size_t edge = 0; edge + 1 < path.size(); ++edge) {
    const Placement& a = path[edge];
    const Placement& b = path[edge + 1];
    const double cosine = cosineOfHalfTheTurn(a, b);
    const double way = length(b.position - a.position) + 2.0 * std::acos(std::min(1.0, std::abs(cosine))) * radius_;
    const int samples = std::clamp(static_cast<int>(std::min(1e6, way / (step * radius_))) + 1, 4, mostSamples);
    Verdict found = judgeEdge(a, b, samples);
    if (found.penetrating > 0 && std::abs(cosine) < kOpenSense) {
      Placement other = b;
      for (double& component : other.orientation) component = -component;
      const Verdict otherSense = judgeEdge(a, other, samples);
      if (otherSense.penetrating < found.penetrating) found = otherSense;
    }
    verdict.poses += found.poses;
    verdict.penetrating += found.penetrating;
    verdict.depth = std::max(verdict.depth, found.depth);
  }
}

Verdict ExactJudge::judgeEdge(const Placement& a, const Placement& b, int samples) const {
  Verdict verdict;
  for (int i = 0; i <= samples; ++i) {
    const Placement pose = between(a, b, static_cast<double>(i) / samples);
    ++verdict.poses;
    if (!penetrates(pose)) continue;
    ++verdict.penetrating;
    verdict.depth = std::max(verdict.depth, depthAt(pose));
  }
  return verdict;
}

}  // namespace glissade::oracle
