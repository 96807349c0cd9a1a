#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

/// The vector arithmetic of the collision kernel, as plain data and functions of it. Each instruction set has its own
/// file with its own compiler flags, so that nothing here may depend on the flags of a file (no Eigen, no FCL, no
/// templates of the standard library in those files). Every lane does the same operations in the same order on every
/// instruction set (no fused multiply-add), so that all give the same bits.
namespace glissade::lanes {

inline constexpr std::uint32_t kWidth = 8;          ///< number of boxes tested at once
inline constexpr std::uint32_t kLeafTriangles = 4;  ///< number of triangles of a leaf; two leaves are two passes

/// A transformation x -> R x + t.
struct FloatPose {
  float rotation[3][3];
  float translation[3];
};

/// Up to eight oriented boxes: the points p with |axis_k . (p - centre)| <= half_k.
struct alignas(32) BoxLanes {
  float centre[3][kWidth];
  float axis[3][3][kWidth];  ///< indices: axis, coordinate, box
  float half[3][kWidth];
};

/// Up to four triangles: one row for each coordinate, and in it corner * 4 + triangle; the last four places are
/// padding.
struct alignas(32) TriangleLanes {
  float coordinate[3][16];
};

/// A short turn about a moving pivot, to first order: a point p moves by `turn (p - pivot) + way` to one side and as
/// far to the other. The values are rounded; `angle` (radians) bounds the turn.
struct FloatSweep {
  float turn[3][3];
  float pivot[3];
  float way[3];
  float angle;
};

/// Motion of eight placed boxes in a sweep: the centre moves by `way` to both sides. The motion of every other point of
/// the box differs by at most `rest`, which includes the deviation of its circle from the tangent; `bend` is that
/// deviation alone. `length` is that of the way plus the rest.
struct alignas(32) SweepLanes {
  float way[3][kWidth];
  float rest[kWidth];
  float bend[kWidth];
  float length[kWidth];
};

/// Four pairs of triangles in double precision; indices: corner, coordinate, pair.
struct alignas(32) TrianglePairLanes {
  double a[3][3][4];
  double b[3][3][4];
};

/// Functions of an instruction set. Both boxes or leaves of a call are in the same frame. `slack` bounds the rounding
/// of every length in the call (metres); answers are conservative by it.
struct LaneFunctions {
  std::string_view name;
  void (*placeBoxes)(const BoxLanes& boxes, const FloatPose& X, BoxLanes& placed);
  void (*placeTriangles)(const TriangleLanes& triangles, const FloatPose& X, TriangleLanes& placed);
  /// Bit i is clear only if box i and box `lane` of `other` are certainly farther apart than `reach` on one of their 15
  /// separating axes. separation[i] is the largest along the axes of the two boxes; it is negative where they overlap.
  unsigned (*boxesWithin)(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, float slack, float reach,
                          float* separation);
  void (*sweepBoxes)(const BoxLanes& placed, const float* radius, const FloatSweep& X, SweepLanes& sweep);
  /// boxesWithin() for moving boxes: bit i is clear only if they are farther apart than `reach` on the whole motion.
  /// `sweep` is that of `boxes` or (its box `lane`) of `other`.
  unsigned (*boxesWithinSweep)(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, const SweepLanes& sweep,
                               bool sweepOfBoxes, float slack, float reach);
  void (*sweepTriangles)(const TriangleLanes& placed, const FloatSweep& X, TriangleLanes& ways);
  /// squared[i] is a lower bound of the squared distance between box i and box `lane` of `other`.
  void (*boxDistances)(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, float slack, float* squared);
  /// Bit 4 k + i is clear only if triangle i of `a` and k of `b` certainly do not meet. Here and below only the first
  /// `count` triangles of `b` are tested; other bits and places are undefined.
  unsigned (*trianglesMayMeet)(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack);
  /// Bit 4 k + i is clear only if they certainly do not meet and are farther apart than `reach`.
  unsigned (*trianglesWithin)(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack, float reach);
  /// trianglesMayMeet() for triangles `b` that move by `ways` to both sides and have to keep `reach`. `byNearest`: the
  /// axis between the nearest points of their edges is tried, too. Only this axis separates corners and edges that are
  /// near each other.
  unsigned (*trianglesMayMeetInSweep)(const TriangleLanes& a, const TriangleLanes& b, const TriangleLanes& ways,
                                      unsigned count, float slack, float reach, bool byNearest);
  /// squared[4 k + i] is a lower bound of the squared distance between triangle i of `a` and k of `b`; estimate[4 k +
  /// i] is an upper bound, unless a triangle is a sliver.
  void (*triangleDistances)(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack, float* squared,
                            float* estimate);
  /// Squared distances, equal to those of triangleDistance.
  void (*exactDistances)(const TrianglePairLanes& pairs, double* squared);
};

/// Implementations that this machine can run, the simplest first.
std::vector<const LaneFunctions*> available();
/// The fastest of these implementations.
const LaneFunctions& best();

}  // namespace glissade::lanes
