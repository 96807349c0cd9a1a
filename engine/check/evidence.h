#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/stop_token.h"
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

/// How much thinner a body may be taken against another one where the product is assembled. Nothing is taken from what
/// planners found.
struct AllowanceBound {
  Evidence largest;                ///< of the face with the largest sum
  double most = 0.0;               ///< metres; 0: nothing is allowed
  std::vector<double> atMost{};    ///< of each triangle of the body
  double clash = 0.0;              ///< metres: the overlap for which nothing is allowed; 0: it is no clash
  std::string refused{};           ///< why nothing is allowed, as "overlap by 1.2 mm, which is a clash"; may be empty
  bool inFit = false;              ///< they touch or overlap
  double share = kThicknessShare;  ///< of the thickness below it that a face may lose
};

/// Of both bodies of a pair.
struct PairBounds {
  AllowanceBound one;
  AllowanceBound other;

  /// Metres: the overlap that has to be accepted for one of them to give way; 0: none.
  double clash() const;
  /// Why nothing is taken from either of them: a clash; empty: something is, or nothing is wrong.
  std::string refused() const;
};

/// What was measured of the faces of one body against another one.
struct MeasuredSide {
  Overlap overlap;
  std::vector<bool> touches;   ///< of each region
  std::vector<double> own;     ///< deflection of the face near the other body, metres
  std::vector<double> others;  ///< deflection of the other body near the face, metres
};

struct MeasuredPair {
  MeasuredSide one;
  MeasuredSide other;
};

/// Metres: bodies that are farther from each other do not touch, whatever files and coordinates are off.
double touchingReach(const PlacedBody& one, const PlacedBody& other);

/// Compares the pair, face by face (FaceRegions). A face is in the fit where the other surface is below it, or faces it
/// and is not farther from it than files, coordinates and three micrometres may be off.
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
AllowanceBound united(const AllowanceBound& a, const AllowanceBound& b);

}  // namespace glissade::check
