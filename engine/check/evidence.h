#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/face_patches.h"
#include "engine/check/overlap.h"
#include "engine/check/placed_body.h"
#include "engine/check/product.h"
#include "engine/check/thinning.h"

namespace glissade::check {

/// What can be said for taking a body thinner at one face against another body, metres.
struct Evidence {
  double overlap = 0.0;     ///< how deep the other surface is below the face
  double deflection = 0.0;  ///< that the triangles of both are off their surfaces there, as the files state it
  double spacing = 0.0;     ///< of the coordinates of both
  double margin = 0.0;      ///< that remains between them
  double byPerson = 0.0;    ///< that a person allows

  double sum() const { return overlap + deflection + spacing + margin + byPerson; }
};

/// "they overlap by 1.2 mm, which is a clash that nobody accepted"
std::string clashRefused(double depth);

/// How much thinner a body may be taken against another one where the product is assembled. Nothing is taken from what
/// planners found.
struct AllowanceBound {
  Evidence largest;              ///< of the face with the largest sum
  double most = 0.0;             ///< metres; 0: nothing is allowed
  std::vector<double> atMost{};  ///< of each triangle of the mesh
  /// The body's, with finer triangles at the borders of patches (FacePatches); null: the body's own.
  MeshPtr mesh{};
  std::vector<std::uint32_t> parents{};  ///< triangle of the body, of each of the mesh; none: they are the body's own
  bool isClash = false;                  ///< nothing is allowed, because the overlap is a clash that nobody accepted
  bool inFit = false;                    ///< they touch or overlap
  double share = kThicknessShare;        ///< of the thickness below it that a face may lose
};

/// The most that is allowed somewhere on each of the `count` triangles of the body.
std::vector<double> mostOfTriangles(const AllowanceBound& bound, std::size_t count);

/// Of both bodies of a pair.
struct PairBounds {
  AllowanceBound one;
  AllowanceBound other;
  /// The one depth of the overlap that all commands state and that a person accepts, metres, in whole micrometres,
  /// rounded up: how deep the surface of the one is in the other, in the body where that is less. 0: no overlap.
  double depth = 0.0;
  /// They overlap by more than the files may be off and than a shaft of the one is too thick for a hole of the other,
  /// and no person says what the pair is: neither a fit nor a thread nor a press fit.
  bool isPlainOverlap = false;
  bool isRefused = false;  ///< their overlap is a clash that nobody accepted, and nothing is taken from either

  /// Why nothing is taken from either of them: a clash; empty: something is, or nothing is wrong.
  std::string refused() const { return isRefused ? clashRefused(depth) : std::string(); }
};

/// What was measured of the faces of one body against another one.
struct MeasuredSide {
  Overlap overlap;
  std::vector<bool> touches;   ///< of each region
  std::vector<double> own;     ///< deflection of the face near the other body, metres
  std::vector<double> others;  ///< deflection of the other body near the face, metres
  /// Patches that the other surface is below; nothing if it is nowhere deeper than margin and spacing.
  std::optional<FacePatches> patches{};
  std::vector<double> patchDepths{};  ///< metres, of each patch
  MeshPtr mesh{};                     ///< divided into the triangles of the patches, in the frame of the body
  double localDepth = 0.0;            ///< metres: margin and spacing
};

struct MeasuredPair {
  MeasuredSide one;
  MeasuredSide other;
};

/// Metres: bodies that are farther from each other do not touch, whatever files and coordinates are off.
double touchingReach(const PlacedBody& one, const PlacedBody& other);

/// Compares the pair, face by face (FaceRegions). A face is in the fit where the other surface is below it, or faces it
/// and is not farther from it than files, coordinates and three micrometres may be off. An overlap counts where it is
/// (FacePatches): for each patch of a face its own depth.
MeasuredPair measurePair(const PlacedBody& one, const PlacedBody& other, const StopToken& stop);

/// One body of a pair, and what was measured of it.
struct MeasuredBody {
  const PlacedBody& body;
  const MeasuredSide& measured;
};

/// What the evidence gives. Overlaps of more than a millimetre or a fifth of the local thickness are clashes, and
/// nothing is allowed for them unless a person accepts them.
PairBounds boundsOf(const MeasuredBody& one, const MeasuredBody& other, const FitWords& fits, const PairWord* word);

/// Adds to what may be taken from the body with a hook that a person lets it bend: at the faces of the hook, and
/// nowhere else. `hook`: of each region. `spacing`: of the coordinates of both, metres.
void addBend(const std::vector<bool>& hook, double bend, const PlacedBody& body, double spacing, AllowanceBound& bound);

/// What remains between bodies that touch where the product is assembled: a micrometre, or four of the clearances that
/// a path has to keep for a body of this radius, if that is more.
double assembledMargin(double radius);

/// The larger of two bounds, triangle by triangle: of a product that is assembled in two configurations.
PairBounds united(const PairBounds& a, const PairBounds& b);

}  // namespace glissade::check
