#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

/// The arithmetic of the collision kernel that runs on vector units, as plain data and functions of
/// it: nothing here may depend on how a file is compiled, because each instruction set has a file of
/// its own with flags of its own (no Eigen, no FCL, no templates of the standard library in those).
/// Every lane does the same operations in the same order on every instruction set
/// (no fused multiply-add), so that all of them give the same bits.
namespace glissade::lanes {

inline constexpr std::uint32_t kWidth = 8;          ///< boxes tested at once
inline constexpr std::uint32_t kLeafTriangles = 4;  ///< triangles of a leaf; two leaves are two passes

/// x -> R x + t.
struct FloatPose {
  float rotation[3][3];
  float translation[3];
};

/// Up to eight oriented boxes: the points p with |axis_k . (p - centre)| <= half_k.
struct alignas(32) BoxLanes {
  float centre[3][kWidth];
  float axis[3][3][kWidth];  ///< which axis, which coordinate
  float half[3][kWidth];
};

/// Up to four triangles: one row a coordinate, and in it corner * 4 + triangle; the last four places
/// are padding.
struct alignas(32) TriangleLanes {
  float coordinate[3][16];
};

/// A short turn about a moving pivot, at first order: a point p goes `turn (p - pivot) + way` to one side
/// and as far to the other. Rounded; `angle` (radians) bounds the turn.
struct FloatSweep {
  float turn[3][3];
  float pivot[3];
  float way[3];
  float angle;
};

/// How eight placed boxes go in a sweep: the centre `way` to both sides, every other point of the box
/// like it up to `rest`, the circles' bend included; of that, `bend` alone. `length` is that of the way
/// and the rest.
struct alignas(32) SweepLanes {
  float way[3][kWidth];
  float rest[kWidth];
  float bend[kWidth];
  float length[kWidth];
};

/// Four pairs of triangles in double precision: corner, coordinate, pair.
struct alignas(32) TrianglePairLanes {
  double a[3][3][4];
  double b[3][3][4];
};

/// Both boxes or leaves given to one call are in the same frame. `slack` bounds the rounding of
/// every length the call computes (metres); answers err to the safe side by it.
struct LaneFunctions {
  std::string_view name;
  void (*placeBoxes)(const BoxLanes& boxes, const FloatPose& X, BoxLanes& placed);
  void (*placeTriangles)(const TriangleLanes& triangles, const FloatPose& X, TriangleLanes& placed);
  /// Bit i is clear only if box i and box `lane` of `other` are certainly farther apart than `reach`
  /// on one of their 15 separating axes. separation[i] is the widest along the axes of the two boxes, the
  /// more negative the deeper they overlap.
  unsigned (*boxesWithin)(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, float slack, float reach,
                          float* separation);
  void (*sweepBoxes)(const BoxLanes& placed, const float* radius, const FloatSweep& X, SweepLanes& sweep);
  /// The same of boxes that move: bit i is clear only if they are farther apart than `reach` all the way.
  /// `sweep` is of `boxes` or (its box `lane`) of `other`.
  unsigned (*boxesWithinSweep)(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, const SweepLanes& sweep,
                               bool sweepOfBoxes, float slack, float reach);
  void (*sweepTriangles)(const TriangleLanes& placed, const FloatSweep& X, TriangleLanes& ways);
  /// squared[i]: at most the squared distance between box i and box `lane` of `other`.
  void (*boxDistances)(const BoxLanes& boxes, const BoxLanes& other, std::size_t lane, float slack, float* squared);
  /// Bit 4 k + i is clear only if triangle i of `a` and k of `b` certainly do not meet.
  /// Here and below only the first `count` triangles of `b` are looked at; bits and places of others
  /// say nothing.
  unsigned (*trianglesMayMeet)(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack);
  /// Bit 4 k + i is clear only if they certainly do not meet and are farther apart than `reach`.
  unsigned (*trianglesWithin)(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack, float reach);
  /// The same of triangles `b` that go `ways` to both sides, which have to keep `reach`. `byNearest`: the axis between
  /// the nearest points of their edges is tried, too; corners and edges that are near each other are kept apart by no
  /// other.
  unsigned (*trianglesMayMeetInSweep)(const TriangleLanes& a, const TriangleLanes& b, const TriangleLanes& ways,
                                      unsigned count, float slack, float reach, bool byNearest);
  /// squared[4 k + i]: at most the squared distance between triangle i of `a` and k of `b`;
  /// estimate[4 k + i]: at least that, unless a triangle is a sliver.
  void (*triangleDistances)(const TriangleLanes& a, const TriangleLanes& b, unsigned count, float slack, float* squared,
                            float* estimate);
  /// Squared distances, as triangleDistance finds them.
  void (*exactDistances)(const TrianglePairLanes& pairs, double* squared);
};

/// Those that this machine can run, the plainest first.
std::vector<const LaneFunctions*> available();
/// The fastest of them.
const LaneFunctions& best();

}  // namespace glissade::lanes
