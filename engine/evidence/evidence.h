#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/stop_token.h"
#include "engine/evidence/face_patches.h"
#include "engine/evidence/overlap.h"
#include "engine/evidence/pair_words.h"
#include "engine/evidence/placed_body.h"
#include "engine/evidence/thinning.h"

namespace glissade::evidence {

/// The evidence for thinning a body at one face against another body, metres.
struct Evidence {
  double overlap = 0.0;     ///< depth of the other surface below the face
  double deflection = 0.0;  ///< deviation of the triangles of both from their surfaces there, by the files
  double spacing = 0.0;     ///< spacing of the coordinates of both
  double margin = 0.0;      ///< margin that remains between them
  double byPerson = 0.0;    ///< allowance of a person

  double sum() const { return overlap + deflection + spacing + margin + byPerson; }
};

/// "they overlap by 1.2 mm, which is a clash that nobody accepted".
Message clashRefused(double depth);

/// The largest allowance of a body against another one where the product is assembled. It uses no result of a planner.
struct AllowanceBound {
  Evidence largest;              ///< evidence of the face with the largest sum
  double most = 0.0;             ///< largest allowance, metres; 0: none
  std::vector<double> atMost{};  ///< allowance of each triangle of the mesh, metres
  /// Mesh of the body with finer triangles at the borders of patches (FacePatches); null: the body's own mesh.
  MeshPtr mesh{};
  std::vector<std::uint32_t> parents{};  ///< triangle of the body for each triangle of `mesh`; empty: the same
  bool isClash = false;            ///< nothing is allowed, because the overlap is a clash that nobody has accepted
  bool inFit = false;              ///< the bodies touch or overlap
  double share = kThicknessShare;  ///< share of the thickness below a face that the face may lose
};

/// The largest allowance on each of the `count` triangles of the body.
std::vector<double> mostOfTriangles(const AllowanceBound& bound, std::size_t count);

/// The bounds of both bodies of a pair.
struct PairBounds {
  AllowanceBound one;
  AllowanceBound other;
  /// Depth of the overlap, metres, rounded up to whole micrometres: how deep the surface of one body is in the other,
  /// the lesser of the two. All commands state it, and a person accepts it. 0: no overlap.
  double depth = 0.0;
  /// True if the bodies overlap by more than the deviations of the files plus the excess of a shaft over its hole, and
  /// no person says what the pair is. It is then no fit, no thread and no press fit.
  bool isPlainOverlap = false;
  bool isRefused = false;  ///< their overlap is a clash that nobody has accepted, and neither body is thinned

  /// The reason why neither body is thinned; empty if one is, or there is no clash.
  Message refused() const { return isRefused ? clashRefused(depth) : Message(); }
};

/// Measurements of the faces of one body against another body.
struct MeasuredSide {
  Overlap overlap;
  std::vector<bool> touches;   ///< one entry for each region
  std::vector<double> own;     ///< deflection of the face near the other body, metres
  std::vector<double> others;  ///< deflection of the other body near the face, metres
  /// Patches that the other surface is below; nothing if it is nowhere deeper than margin and spacing.
  std::optional<FacePatches> patches{};
  std::vector<double> patchDepths{};  ///< depth of each patch, metres
  MeshPtr mesh{};                     ///< mesh divided into the triangles of the patches, in the frame of the body
  double localDepth = 0.0;            ///< margin and spacing, metres
};

struct MeasuredPair {
  MeasuredSide one;
  MeasuredSide other;
};

/// Metres: bodies that are farther apart do not touch, whatever the deviations of files and coordinates.
double touchingReach(const PlacedBody& one, const PlacedBody& other);

/// Compares the pair face by face (FaceRegions). A face is in the fit if the other surface is below it, or faces it
/// within the deviations of files and coordinates plus three micrometres. An overlap is local (FacePatches): each patch
/// of a face has a depth.
MeasuredPair measurePair(const PlacedBody& one, const PlacedBody& other, const StopToken& stop);

/// One body of a pair, with its measurements.
struct MeasuredBody {
  const PlacedBody& body;
  const MeasuredSide& measured;
};

/// The allowances that the evidence gives. Overlaps of more than a millimetre or a fifth of the local thickness are
/// clashes, and allow nothing unless a person accepts them.
PairBounds boundsOf(const MeasuredBody& one, const MeasuredBody& other, const FitWords& fits, const PairWord* word);

/// Adds to the allowance of a body with a hook the bend that a person permits, at the faces of the hook only. `hook`:
/// one entry for each region. `spacing`: of the coordinates of both bodies, metres.
void addBend(const std::vector<bool>& hook, double bend, const PlacedBody& body, double spacing, AllowanceBound& bound);

/// The margin between bodies that touch where the product is assembled: a micrometre, or four times the clearance that
/// a path has to keep for a body of this radius if that is more.
double assembledMargin(double radius);

/// The larger of two bounds, triangle by triangle, for a product that is assembled in two configurations.
PairBounds united(const PairBounds& a, const PairBounds& b);

}  // namespace glissade::evidence
