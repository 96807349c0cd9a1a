#pragma once

#include "engine/collision/kernel/lanes.h"

/// Implementation of LaneFunctions over a vector of eight floats `F` (`F::tiny()` is smaller than any squared area or
/// product of squared lengths in the computation, and keeps divisions defined). Each instruction set instantiates it
/// with its own type, so that no two files share a symbol.
namespace glissade::lanes {

/// Eight (or four) vectors over a vector `F` of numbers.
template <class F>
struct Vec3 {
  F x, y, z;

  static Vec3 load(const float (&rows)[3][kWidth]) { return {F::load(rows[0]), F::load(rows[1]), F::load(rows[2])}; }
  static Vec3 broadcast(const float (&rows)[3][kWidth], std::size_t lane) {
    return {F::all(rows[0][lane]), F::all(rows[1][lane]), F::all(rows[2][lane])};
  }
  void store(float (&rows)[3][kWidth]) const {
    x.store(rows[0]);
    y.store(rows[1]);
    z.store(rows[2]);
  }

  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator*(F s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend F dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Vec3 absolute(const Vec3& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
  friend Vec3 select(F mask, const Vec3& yes, const Vec3& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
  }
  friend F sumOfAbsolutes(const Vec3& a) { return abs(a.x) + abs(a.y) + abs(a.z); }
};

/// Upper bound on the error of a squared distance of triangles per squared length of its inputs (edges and gap),
/// including nearly parallel edges and slivers. There the point may be inaccurate, but the function is so flat that the
/// error is no larger than the rounding of its coefficients. The largest error in 6.4 million difficult pairs was
/// 2.3e-6.
inline constexpr float kSquaredDistanceError = 1.6e-5F;
/// Larger than any squared length, and finite when multiplied.
inline constexpr float kALot = 1e30F;
/// Squared sine below which two edges count as nearly parallel.
inline constexpr float kNearlyParallel = 1e-8F;
/// Factor that removes the rounding of a few products.
inline constexpr float kRoundedDown = 0.999999F;
inline constexpr float kRoundedUp = 1.000002F;

template <class F>
struct Arithmetic {
  using V = Vec3<F>;

  static V rotated(const FloatPose& X, const V& p) {
    const auto row = [&](int i) {
      return F::all(X.rotation[i][0]) * p.x + F::all(X.rotation[i][1]) * p.y + F::all(X.rotation[i][2]) * p.z;
    };
    return {row(0), row(1), row(2)};
  }

  static V transformed(const FloatPose& X, const V& p) {
    return rotated(X, p) + V{F::all(X.translation[0]), F::all(X.translation[1]), F::all(X.translation[2])};
  }

  static void placeBoxes(const BoxLanes& boxes, const FloatPose& X, BoxLanes& placed) {
    transformed(X, V::load(boxes.centre)).store(placed.centre);
    for (int k = 0; k < 3; ++k) {
      rotated(X, V::load(boxes.axis[k])).store(placed.axis[k]);
      F::load(boxes.half[k]).store(placed.half[k]);
    }
  }

  static void placeTriangles(const TriangleLanes& triangles, const FloatPose& X, TriangleLanes& placed) {
    for (std::size_t half = 0; half < 16; half += kWidth) {
      const V p = transformed(X, {F::load(triangles.coordinate[0] + half), F::load(triangles.coordinate[1] + half),
                                  F::load(triangles.coordinate[2] + half)});
      p.x.store(placed.coordinate[0] + half);
      p.y.store(placed.coordinate[1] + half);
      p.z.store(placed.coordinate[2] + half);
    }
  }

  /// Motion of a point (one in each lane) in a sweep relative to the pivot's motion.
  static V turned(const FloatSweep& X, const V& p) {
    const V arm = p - V{F::all(X.pivot[0]), F::all(X.pivot[1]), F::all(X.pivot[2])};
    const auto row = [&](int i) {
      return F::all(X.turn[i][0]) * arm.x + F::all(X.turn[i][1]) * arm.y + F::all(X.turn[i][2]) * arm.z;
    };
    return {row(0), row(1), row(2)};
  }

  static V wayOfPivot(const FloatSweep& X) { return {F::all(X.way[0]), F::all(X.way[1]), F::all(X.way[2])}; }

  /// Sweeps boxes. A point at distance r from the axis leaves its tangent by at most r angle^2 / 2.
  static void sweepBoxes(const BoxLanes& placed, const float* radius, const FloatSweep& X, SweepLanes& sweep) {
    const V turn = turned(X, V::load(placed.centre));
    const V way = turn + wayOfPivot(X);
    way.store(sweep.way);
    const F spread = F::all(kRoundedUp * X.angle) * F::load(radius);
    const F bend = F::all(kRoundedUp * 0.5F * X.angle) * (sqrt(dot(turn, turn)) + spread);
    bend.store(sweep.bend);
    (spread + bend).store(sweep.rest);
    (F::all(kRoundedUp) * sqrt(dot(way, way)) + spread + bend).store(sweep.length);
  }

  static void sweepTriangles(const TriangleLanes& placed, const FloatSweep& X, TriangleLanes& ways) {
    for (std::size_t half = 0; half < 16; half += kWidth) {
      const V way = turned(X, {F::load(placed.coordinate[0] + half), F::load(placed.coordinate[1] + half),
                               F::load(placed.coordinate[2] + half)}) +
                    wayOfPivot(X);
      way.x.store(ways.coordinate[0] + half);
      way.y.store(ways.coordinate[1] + half);
      way.z.store(ways.coordinate[2] + half);
    }
  }

  static F largest(const V& v) { return max(max(v.x, v.y), v.z); }

  /// Data of eight boxes against one box that all separating axes need.
  struct BoxPairs {
    V halfA, halfB;
    V gapA, gapB;  ///< vectors between the centres, along the axes of each box
    V axes[3];     ///< axes[k]: axis k of each of the eight boxes in the frame of the single box
    V absolute[3];

    BoxPairs(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane)
        : halfA(V::load(boxes.half)), halfB(V::broadcast(other.half, lane)) {
      const V gap = V::broadcast(other.centre, lane) - V::load(boxes.centre);
      const V b0 = V::broadcast(other.axis[0], lane);
      const V b1 = V::broadcast(other.axis[1], lane);
      const V b2 = V::broadcast(other.axis[2], lane);
      gapB = {dot(gap, b0), dot(gap, b1), dot(gap, b2)};
      const auto along = [&](int k) {
        const V axis = V::load(boxes.axis[k]);
        axes[k] = {dot(axis, b0), dot(axis, b1), dot(axis, b2)};
        absolute[k] = {abs(axes[k].x), abs(axes[k].y), abs(axes[k].z)};
        return dot(gap, axis);
      };
      gapA.x = along(0);
      gapA.y = along(1);
      gapA.z = along(2);
    }

    /// Separations along the axes of the eight; negative where they overlap.
    V separationA() const {
      return {abs(gapA.x) - halfA.x - dot(absolute[0], halfB), abs(gapA.y) - halfA.y - dot(absolute[1], halfB),
              abs(gapA.z) - halfA.z - dot(absolute[2], halfB)};
    }
    V separationB() const {
      const V reach = halfA.x * absolute[0] + halfA.y * absolute[1] + halfA.z * absolute[2];
      return {abs(gapB.x) - halfB.x - reach.x, abs(gapB.y) - halfB.y - reach.y, abs(gapB.z) - halfB.z - reach.z};
    }
    /// Lower bounds on squared distances along the products of axis k of the eight and the single box's axes:
    /// separations divided by the length of these axes, which is the sine of their angles.
    F squaredByEdges(int k, F slack) const {
      const F zero = F::all(0.0F);
      const V gap = separationByEdges(k);
      const auto squared = [&](F separation, F cosine) {
        const F left = max(separation - slack, zero);
        return left * left / (F::all(1.000001F) - cosine * cosine);
      };
      return max(max(squared(gap.x, axes[k].x), squared(gap.y, axes[k].y)), squared(gap.z, axes[k].z));
    }
    /// Bits of the pairs that a product of axis k of the eight and an axis of the single box separates. These axes are
    /// shorter than one, and so is the slack along them.
    unsigned separatedByEdges(int k, F limit) const { return bits(less(limit, largest(separationByEdges(k)))); }
    V separationByEdges(int k) const {
      const int k1 = (k + 1) % 3;
      const int k2 = (k + 2) % 3;
      const V gap = alongEdges(gapA, k);
      const F half1 = k == 0 ? halfA.y : k == 1 ? halfA.z : halfA.x;
      const F half2 = k == 0 ? halfA.z : k == 1 ? halfA.x : halfA.y;
      const auto separation = [&](F along, F a1, F a2, F r1, F h1, F r2, F h2) {
        return along - (half1 * a2 + half2 * a1 + h1 * r2 + h2 * r1);
      };
      const V& a1 = absolute[k1];
      const V& a2 = absolute[k2];
      const V& a0 = absolute[k];
      return {separation(gap.x, a1.x, a2.x, a0.y, halfB.y, a0.z, halfB.z),
              separation(gap.y, a1.y, a2.y, a0.z, halfB.z, a0.x, halfB.x),
              separation(gap.z, a1.z, a2.z, a0.x, halfB.x, a0.y, halfB.y)};
    }
    /// Length of a vector, given along the axes of the eight, along the products of their axis k and the single box's
    /// axes.
    V alongEdges(const V& v, int k) const {
      const F v1 = k == 0 ? v.y : k == 1 ? v.z : v.x;
      const F v2 = k == 0 ? v.z : k == 1 ? v.x : v.y;
      const V& c1 = axes[(k + 1) % 3];
      const V& c2 = axes[(k + 2) % 3];
      return {abs(v2 * c1.x - v1 * c2.x), abs(v2 * c1.y - v1 * c2.y), abs(v2 * c1.z - v1 * c2.z)};
    }
  };

  static unsigned boxesWithin(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, float slack, float reach,
                              float* separation) {
    const BoxPairs pairs(boxes, other, lane);
    const F limit = F::all(slack + reach);
    const F widest = max(largest(pairs.separationA()), largest(pairs.separationB()));
    widest.store(separation);
    unsigned separated = bits(less(limit, widest));
    for (int k = 0; k < 3 && separated != 0xFFU; ++k) separated |= pairs.separatedByEdges(k, limit);
    return ~separated & 0xFFU;
  }

  static unsigned boxesWithinSweep(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane,
                                   const SweepLanes& sweep, bool sweepOfBoxes, float slack, float reach) {
    const BoxPairs pairs(boxes, other, lane);
    const V way = sweepOfBoxes ? V::load(sweep.way) : V::broadcast(sweep.way, lane);
    const F limit = (sweepOfBoxes ? F::load(sweep.rest) : F::all(sweep.rest[lane])) + F::all(slack + reach);
    const auto along = [&](const V& axis) { return dot(way, axis); };
    const V wayA{along(V::load(boxes.axis[0])), along(V::load(boxes.axis[1])), along(V::load(boxes.axis[2]))};
    const V wayB{along(V::broadcast(other.axis[0], lane)), along(V::broadcast(other.axis[1], lane)),
                 along(V::broadcast(other.axis[2], lane))};
    unsigned separated = bits(
        less(limit, max(largest(pairs.separationA() - absolute(wayA)), largest(pairs.separationB() - absolute(wayB)))));
    for (int k = 0; k < 3 && separated != 0xFFU; ++k) {
      separated |= bits(less(limit, largest(pairs.separationByEdges(k) - pairs.alongEdges(wayA, k))));
    }
    return ~separated & 0xFFU;
  }

  /// Squared length of a separation along three perpendicular axes, where it is positive.
  static F squaredGap(const V& separation, F slack) {
    const F zero = F::all(0.0F);
    const V gap{max(separation.x - slack, zero), max(separation.y - slack, zero), max(separation.z - slack, zero)};
    return dot(gap, gap);
  }

  static void boxDistances(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, float slack,
                           float* squared) {
    const BoxPairs pairs(boxes, other, lane);
    const F s = F::all(slack);
    F bound = max(squaredGap(pairs.separationA(), s), squaredGap(pairs.separationB(), s));
    for (int k = 0; k < 3; ++k) bound = max(bound, pairs.squaredByEdges(k, s));
    (bound * F::all(kRoundedDown)).store(squared);
  }

  /// Pairs of triangles, one in each lane.
  struct TrianglePairs {
    V a[3], b[3];    ///< corners of both triangles
    V ea[3], eb[3];  ///< edges from corner i to corner i + 1

    /// Pairs the four triangles of `la` with triangle `first` of `lb`, and with the next one.
    static TrianglePairs ofLeaves(const TriangleLanes& la, const TriangleLanes& lb, std::size_t first) {
      TrianglePairs pairs;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t at = corner * kLeafTriangles;
        pairs.a[corner] = {F::twice(la.coordinate[0] + at), F::twice(la.coordinate[1] + at),
                           F::twice(la.coordinate[2] + at)};
        pairs.b[corner] = {F::halves(lb.coordinate[0] + at + first), F::halves(lb.coordinate[1] + at + first),
                           F::halves(lb.coordinate[2] + at + first)};
      }
      pairs.takeEdges();
      return pairs;
    }

    void takeEdges() {
      for (int i = 0; i < 3; ++i) {
        ea[i] = a[(i + 1) % 3] - a[i];
        eb[i] = b[(i + 1) % 3] - b[i];
      }
    }

    /// Intervals of both triangles on an axis, relative to the first corner of a.
    struct Extents {
      F lowA, highA;
      F b[3];

      /// The gap between a and the widened interval of b; negative where they overlap.
      F gap(F lowB, F highB) const { return max(lowB - highA, lowA - highB); }
    };
    Extents along(const V& axis) const {
      const F zero = F::all(0.0F);
      const F a1 = dot(ea[0], axis);
      const F a2 = a1 + dot(ea[1], axis);
      const F b0 = dot(b[0] - a[0], axis);
      const F b1 = b0 + dot(eb[0], axis);
      return {min(min(a1, a2), zero), max(max(a1, a2), zero), {b0, b1, b1 + dot(eb[1], axis)}};
    }

    F gapAlong(const V& axis) const {
      const Extents on = along(axis);
      return on.gap(min(min(on.b[0], on.b[1]), on.b[2]), max(max(on.b[0], on.b[1]), on.b[2]));
    }
    /// The gap between a and the interval of b that its corners sweep to both sides.
    F gapAlong(const V& axis, const V (&ways)[3]) const {
      const Extents on = along(axis);
      const F w0 = abs(dot(ways[0], axis));
      const F w1 = abs(dot(ways[1], axis));
      const F w2 = abs(dot(ways[2], axis));
      return on.gap(min(min(on.b[0] - w0, on.b[1] - w1), on.b[2] - w2),
                    max(max(on.b[0] + w0, on.b[1] + w1), on.b[2] + w2));
    }
    /// Bits of the pairs that this axis separates. Any axis is valid, whatever its own rounding.
    unsigned separatedBy(const V& axis, F slack) const {
      return bits(less(slack * sumOfAbsolutes(axis), gapAlong(axis)));
    }
  };

  /// Bits of the pairs that none of their axes separates; `apart`: computes the bits that an axis separates.
  template <class Apart>
  static unsigned unseparated(const TrianglePairs& pairs, const Apart& apart) {
    unsigned separated = apart(cross(pairs.ea[0], pairs.ea[1]));
    if (separated == 0xFFU) return 0;
    separated |= apart(cross(pairs.eb[0], pairs.eb[1]));
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (separated == 0xFFU) return 0;
        separated |= apart(cross(pairs.ea[i], pairs.eb[k]));
      }
    }
    return ~separated & 0xFFU;
  }

  static unsigned mayMeet(const TriangleLanes& la, const TriangleLanes& lb, std::size_t first, F slack) {
    const TrianglePairs pairs = TrianglePairs::ofLeaves(la, lb, first);
    return unseparated(pairs, [&](const V& axis) { return pairs.separatedBy(axis, slack); });
  }

  static unsigned trianglesMayMeet(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack) {
    const F s = F::all(slack);
    return mayMeet(a, b, 0, s) | (count > 2 ? mayMeet(a, b, 2, s) << kWidth : 0U);
  }

  static unsigned within(const TriangleLanes& la, const TriangleLanes& lb, std::size_t first, F slack, F reach) {
    const TrianglePairs pairs = TrianglePairs::ofLeaves(la, lb, first);
    return unseparated(pairs, [&](const V& axis) {
      return bits(less(slack * sumOfAbsolutes(axis) + reach * sqrt(dot(axis, axis)), pairs.gapAlong(axis)));
    });
  }

  static unsigned trianglesWithin(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack,
                                  float reach) {
    const F s = F::all(slack);
    const F r = F::all(kRoundedUp * reach);
    return within(a, b, 0, s, r) | (count > 2 ? within(a, b, 2, s, r) << kWidth : 0U);
  }

  /// Triangles `b` of the pairs move by `ways` to both sides, corner by corner.
  static unsigned mayMeetInSweep(const TriangleLanes& la, const TriangleLanes& lb, const TriangleLanes& lways,
                                 std::size_t first, F slack, F reach, bool byNearest) {
    const TrianglePairs pairs = TrianglePairs::ofLeaves(la, lb, first);
    V ways[3];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t at = corner * kLeafTriangles + first;
      ways[corner] = {F::halves(lways.coordinate[0] + at), F::halves(lways.coordinate[1] + at),
                      F::halves(lways.coordinate[2] + at)};
    }
    const auto apart = [&](const V& axis) {
      return bits(less(slack * sumOfAbsolutes(axis) + reach * sqrt(dot(axis, axis)), pairs.gapAlong(axis, ways)));
    };
    const unsigned left = unseparated(pairs, apart);
    return byNearest && left != 0 ? left & ~apart(shortestBetweenEdges(pairs)) : left;
  }

  static unsigned trianglesMayMeetInSweep(const TriangleLanes& a, const TriangleLanes& b, const TriangleLanes& ways,
                                          unsigned count, float slack, float reach, bool byNearest) {
    const F s = F::all(slack);
    const F r = F::all(reach);
    return mayMeetInSweep(a, b, ways, 0, s, r, byNearest) |
           (count > 2 ? mayMeetInSweep(a, b, ways, 2, s, r, byNearest) << kWidth : 0U);
  }

  static F clamped(F value) { return min(max(value, F::all(0.0F)), F::all(1.0F)); }

  /// An edge with the values that all computations share.
  struct Edge {
    V from, along;
    F squared, inverse;  ///< squared length, and its inverse

    Edge(const V& p, const V& u) : from(p), along(u), squared(dot(u, u)), inverse(inverseOf(squared)) {}
  };

  static F inverseOf(F positive) { return F::all(1.0F) / max(positive, F::tiny()); }

  /// Two segments p + s u and r + t v, by Ericson 2005, 5.1.9, without branches.
  struct Segments {
    const Edge& first;
    const Edge& second;
    V w;
    F b, d, e;

    Segments(const Edge& first_, const Edge& second_)
        : first(first_),
          second(second_),
          w(first.from - second.from),
          b(dot(first.along, second.along)),
          d(dot(first.along, w)),
          e(dot(second.along, w)) {}

    F determinant() const { return first.squared * second.squared - b * b; }
    V gapFrom(F s0) const {
      const F t = clamped((b * s0 + e) * second.inverse);
      const F s = clamped((b * t - d) * first.inverse);
      return w + s * first.along - t * second.along;
    }
    F squaredFrom(F s0) const {
      const V gap = gapFrom(s0);
      return dot(gap, gap);
    }
    V shortest() const { return gapFrom(clamped((b * e - second.squared * d) / max(determinant(), F::tiny()))); }
    F squared() const {
      const V gap = shortest();
      return dot(gap, gap);
    }
    /// The squared distance. Where segments are nearly parallel the ends of the first one are tried, too.
    F squaredRefined() const {
      const F found = squared();
      if (bits(less(F::all(kNearlyParallel) * first.squared * second.squared, determinant())) == F::kAllBits) {
        return found;
      }
      return min(found, min(squaredFrom(F::all(0.0F)), squaredFrom(F::all(1.0F))));
    }
  };

  /// Shortest vector from triangle a of each pair to b, between the nearest points of their edges.
  static V shortestBetweenEdges(const TrianglePairs& pairs) {
    F best = F::all(kALot);
    V shortest = pairs.b[0] - pairs.a[0];
    for (int i = 0; i < 3; ++i) {
      const Edge a(pairs.a[i], pairs.ea[i]);
      for (int k = 0; k < 3; ++k) {
        const V gap = Segments(a, Edge(pairs.b[k], pairs.eb[k])).shortest();
        const F squared = dot(gap, gap);
        shortest = select(less(squared, best), gap, shortest);
        best = min(best, squared);
      }
    }
    return shortest;
  }

  /// Interior of a triangle: the points whose products with the inward normals of its three edges are positive.
  struct Face {
    V corners[3];
    V normal;
    V inward[3];
    F inverseArea;
    F faceless;  ///< kALot where the triangle has no area

    Face(const V (&c)[3], const V (&edges)[3]) : corners{c[0], c[1], c[2]}, normal(cross(edges[0], edges[1])) {
      for (int i = 0; i < 3; ++i) inward[i] = cross(normal, edges[i]);
      const F area = dot(normal, normal);
      inverseArea = inverseOf(area);
      faceless = select(less(F::tiny(), area), F::all(0.0F), F::all(kALot));
    }
    /// Squared distance of p if its foot lies on the face, else kALot.
    F squaredFrom(const V& p) const {
      const V arm = p - corners[0];
      const F least = min(min(dot(inward[0], arm), dot(inward[1], p - corners[1])), dot(inward[2], arm));
      const F height = dot(normal, arm);
      return select(less(least, F::all(0.0F)), F::all(kALot), height * height * inverseArea + faceless);
    }
  };

  /// Squared distances, and the squared lengths to which their errors are proportional.
  struct SquaredDistances {
    F squared;
    F scale;
  };

  template <bool kRefined>
  static SquaredDistances squaredDistances(const TrianglePairs& pairs) {
    const Face faceA(pairs.a, pairs.ea);
    const Face faceB(pairs.b, pairs.eb);
    const Edge edgesA[3]{{pairs.a[0], pairs.ea[0]}, {pairs.a[1], pairs.ea[1]}, {pairs.a[2], pairs.ea[2]}};
    const Edge edgesB[3]{{pairs.b[0], pairs.eb[0]}, {pairs.b[1], pairs.eb[1]}, {pairs.b[2], pairs.eb[2]}};
    F best = F::all(kALot);
    for (int i = 0; i < 3; ++i) {
      best = min(best, min(faceB.squaredFrom(pairs.a[i]), faceA.squaredFrom(pairs.b[i])));
      for (int k = 0; k < 3; ++k) {
        const Segments segments(edgesA[i], edgesB[k]);
        best = min(best, kRefined ? segments.squaredRefined() : segments.squared());
      }
    }
    const V gap = pairs.b[0] - pairs.a[0];
    return {best, dot(gap, gap) + edgesA[0].squared + edgesA[2].squared + edgesB[0].squared + edgesB[2].squared};
  }

  static void distances(const TriangleLanes& la, const TriangleLanes& lb, std::size_t first, F slack, float* squared,
                        float* estimate) {
    const auto [found, scale] = squaredDistances<false>(TrianglePairs::ofLeaves(la, lb, first));
    const F zero = F::all(0.0F);
    const F error = F::all(kSquaredDistanceError) * scale;
    const F least = max(sqrt(max(found - error, zero)) - slack, zero);
    (least * least * F::all(kRoundedDown)).store(squared);
    const F most = sqrt(found + error) + slack;
    (most * most).store(estimate);
  }

  static void triangleDistances(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack,
                                float* squared, float* estimate) {
    distances(a, b, 0, F::all(slack), squared, estimate);
    if (count > 2) distances(a, b, 2, F::all(slack), squared + kWidth, estimate + kWidth);
  }
};

/// Squared distances in double precision; `D` holds four.
template <class D>
void exactDistances(const TrianglePairLanes& lanes, double* squared) {
  typename Arithmetic<D>::TrianglePairs pairs;
  for (int corner = 0; corner < 3; ++corner) {
    pairs.a[corner] = {D::load(lanes.a[corner][0]), D::load(lanes.a[corner][1]), D::load(lanes.a[corner][2])};
    pairs.b[corner] = {D::load(lanes.b[corner][0]), D::load(lanes.b[corner][1]), D::load(lanes.b[corner][2])};
  }
  pairs.takeEdges();
  Arithmetic<D>::template squaredDistances<true>(pairs).squared.store(squared);
}

template <class F, class D>
constexpr LaneFunctions table(std::string_view name) {
  using A = Arithmetic<F>;
  return {name,
          A::placeBoxes,
          A::placeTriangles,
          A::boxesWithin,
          A::sweepBoxes,
          A::boxesWithinSweep,
          A::sweepTriangles,
          A::boxDistances,
          A::trianglesMayMeet,
          A::trianglesWithin,
          A::trianglesMayMeetInSweep,
          A::triangleDistances,
          exactDistances<D>};
}

}  // namespace glissade::lanes
