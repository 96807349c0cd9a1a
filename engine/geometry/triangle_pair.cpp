#include "engine/geometry/triangle_pair.h"

#include <algorithm>
#include <limits>

#include "engine/geometry/exact_predicates.h"

namespace glissade {
namespace {

using Signs = std::array<int, 3>;

bool onOneSide(const Signs& signs) { return signs[0] != 0 && signs[0] == signs[1] && signs[0] == signs[2]; }

/// True if c lies within the box of a and b; all three are on one line in the projection.
bool between(const Vector3& a, const Vector3& b, const Vector3& c, int dropped) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != dropped && (c[axis] < std::min(a[axis], b[axis]) || c[axis] > std::max(a[axis], b[axis]))) return false;
  }
  return true;
}

bool segmentsMeet2d(const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& s, int dropped) {
  const int pr = orientation2d(p, q, r, dropped);
  const int ps = orientation2d(p, q, s, dropped);
  const int rp = orientation2d(r, s, p, dropped);
  const int rq = orientation2d(r, s, q, dropped);
  if (pr * ps < 0 && rp * rq < 0) return true;
  return (pr == 0 && between(p, q, r, dropped)) || (ps == 0 && between(p, q, s, dropped)) ||
         (rp == 0 && between(r, s, p, dropped)) || (rq == 0 && between(r, s, q, dropped));
}

bool segmentMeetsTriangle2d(const Vector3& p, const Vector3& q, const Triangle& t, int dropped) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segmentsMeet2d(p, q, t[i], t[(i + 1) % 3], dropped)) return true;
  }
  return onOneSide({orientation2d(t[0], t[1], p, dropped), orientation2d(t[1], t[2], p, dropped),
                    orientation2d(t[2], t[0], p, dropped)});
}

/// Figures in one plane meet if and only if they do in all three projections, because at least one projection is
/// injective on the plane.
template <class Test>
bool inEveryProjection(const Test& test) {
  return test(0) && test(1) && test(2);
}

bool isDegenerate(const Triangle& t) {
  return inEveryProjection([&](int dropped) { return orientation2d(t[0], t[1], t[2], dropped) == 0; });
}

bool segmentsMeet(const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& s) {
  return orientation3d(p, q, r, s) == 0 &&
         inEveryProjection([&](int dropped) { return segmentsMeet2d(p, q, r, s, dropped); });
}

/// Precondition: both ends lie in the triangle's plane, or the triangle has none.
bool coplanarSegmentMeets(const Vector3& p, const Vector3& q, const Triangle& t) {
  if (!isDegenerate(t)) {
    return inEveryProjection([&](int dropped) { return segmentMeetsTriangle2d(p, q, t, dropped); });
  }
  return segmentsMeet(p, q, t[0], t[1]) || segmentsMeet(p, q, t[1], t[2]) || segmentsMeet(p, q, t[2], t[0]);
}

/// True if an edge of a triangle whose corners lie on these sides of t's plane meets t.
bool anEdgeMeets(const Triangle& edges, const Signs& sides, const Triangle& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    const Vector3& p = edges[i];
    const Vector3& q = edges[k];
    if (sides[i] * sides[k] > 0) continue;
    if (sides[i] == 0 && sides[k] == 0) {
      if (coplanarSegmentMeets(p, q, t)) return true;
      continue;
    }
    const int first = orientation3d(p, q, t[0], t[1]);
    const int second = orientation3d(p, q, t[1], t[2]);
    if (first * second < 0) continue;
    const int third = orientation3d(p, q, t[2], t[0]);
    if (first * third >= 0 && second * third >= 0) return true;
  }
  return false;
}

Signs sidesOf(const Triangle& plane, const Triangle& corners) {
  return {orientation3d(plane[0], plane[1], plane[2], corners[0]),
          orientation3d(plane[0], plane[1], plane[2], corners[1]),
          orientation3d(plane[0], plane[1], plane[2], corners[2])};
}

void keepNearer(TriangleDistance& best, const Vector3& onA, const Vector3& onB) {
  const double squared = (onA - onB).squaredNorm();
  if (squared < best.squared) best = {squared, onA, onB};
}

/// The ratio clamped to [0, 1]; 0 where the division is undefined (a point for a segment).
double unitRatio(double numerator, double denominator) {
  return denominator > 0.0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
}

/// Nearest points of segments by Ericson 2005, 5.1.9. Where the segments are nearly parallel, so that the solution is
/// inaccurate, the ends of the first are tried, too.
void nearestOfSegments(const Vector3& p, const Vector3& u, const Vector3& r, const Vector3& v, TriangleDistance& best) {
  constexpr double kNearlyParallel = 1e-8;  // squared sine of the angle
  const Vector3 w = p - r;
  const double a = u.squaredNorm();
  const double b = u.dot(v);
  const double c = v.squaredNorm();
  const double d = u.dot(w);
  const double e = v.dot(w);
  const auto tryAt = [&](double s) {
    const double t = unitRatio(b * s + e, c);
    s = unitRatio(b * t - d, a);
    keepNearer(best, p + s * u, r + t * v);
  };
  const double determinant = a * c - b * b;
  tryAt(unitRatio(b * e - c * d, determinant));
  if (determinant > kNearlyParallel * a * c) return;
  tryAt(0.0);
  tryAt(1.0);
}

/// The foot of the perpendicular from p, if it lies on the face.
bool footOnFace(const Vector3& p, const Triangle& t, Vector3& foot) {
  const Vector3 e0 = t[1] - t[0];
  const Vector3 e2 = t[2] - t[0];
  const Vector3 n = e0.cross(e2);
  const Vector3 w = p - t[0];
  const double area = n.squaredNorm();
  if (area <= 0.0 || n.dot(e0.cross(w)) < 0.0 || n.dot(w.cross(e2)) < 0.0 ||
      n.dot((t[2] - t[1]).cross(p - t[1])) < 0.0) {
    return false;
  }
  foot = p - (n.dot(w) / area) * n;
  return true;
}

}  // namespace

bool trianglesMeet(const Triangle& a, const Triangle& b) {
  const Signs sidesOfB = sidesOf(a, b);
  if (onOneSide(sidesOfB)) return false;
  const Signs sidesOfA = sidesOf(b, a);
  if (onOneSide(sidesOfA)) return false;
  return anEdgeMeets(b, sidesOfB, a) || anEdgeMeets(a, sidesOfA, b);
}

TriangleDistance triangleDistance(const Triangle& a, const Triangle& b) {
  TriangleDistance best;
  best.squared = std::numeric_limits<double>::infinity();
  Vector3 foot;
  for (std::size_t i = 0; i < 3; ++i) {
    if (footOnFace(a[i], b, foot)) keepNearer(best, a[i], foot);
    if (footOnFace(b[i], a, foot)) keepNearer(best, foot, b[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      nearestOfSegments(a[i], a[(i + 1) % 3] - a[i], b[k], b[(k + 1) % 3] - b[k], best);
    }
  }
  return best;
}

double squaredSegmentDistance(const Vector3& p, const Vector3& q, const Triangle& triangle) {
  TriangleDistance best;
  best.squared = std::numeric_limits<double>::infinity();
  Vector3 foot;
  const auto tryFootOf = [&](const Vector3& point) {
    if (footOnFace(point, triangle, foot)) keepNearer(best, point, foot);
  };
  tryFootOf(p);
  tryFootOf(q);
  const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double heightOfP = normal.dot(p - triangle[0]);
  const double heightOfQ = normal.dot(q - triangle[0]);
  if (heightOfP * heightOfQ < 0.0) tryFootOf(p + heightOfP / (heightOfP - heightOfQ) * (q - p));
  for (std::size_t k = 0; k < 3; ++k) {
    nearestOfSegments(p, q - p, triangle[k], triangle[(k + 1) % 3] - triangle[k], best);
  }
  return best.squared;
}

}  // namespace glissade
