#include "engine/check/evidence.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/base/tolerances.h"
#include "engine/check/overlap.h"

namespace glissade::check {
namespace {

constexpr double kTouchingSurfaces = 3e-6;  ///< metres: what fitting and rounding leave
constexpr double kClashShare = 0.2;         ///< of the local thickness

MeasuredSide emptySide(const PlacedBody& body, Overlap overlap) {
  const std::size_t count = body.regions.count;
  return {std::move(overlap), std::vector<bool>(count, false), std::vector<double>(count, 0.0),
          std::vector<double>(count, 0.0)};
}

/// A touch of the region with these deflections says nothing that is not known of it.
bool isKnown(const MeasuredSide& side, std::uint32_t region, double own, double others) {
  return side.touches[region] && side.own[region] >= own && side.others[region] >= others;
}

void touch(MeasuredSide& side, std::uint32_t region, double own, double others) {
  side.touches[region] = true;
  side.own[region] = std::max(side.own[region], own);
  side.others[region] = std::max(side.others[region], others);
}

/// Metres: a face that the other surface is below faces it over so much.
double depthBelow(const MeasuredSide& side, std::uint32_t region) {
  return std::min(kClashOverlap, std::max(0.0, side.overlap.depths[region]));
}

void findTouching(const PlacedBody& one, const PlacedBody& other, MeasuredPair& measured, const StopToken& stop) {
  const double off = one.spacing + other.spacing + kTouchingSurfaces;
  const double deepest =
      std::min(kClashOverlap, std::max({0.0, measured.one.overlap.deepest, measured.other.overlap.deepest}));
  one.tree.visitPairs(other.tree, touchingReach(one, other) + deepest, [&](std::uint32_t i, std::uint32_t k) {
    if (one.normals[i].dot(other.normals[k]) > kFacing) return !stop.stopRequested();
    const double ofOne = one.deflections[i];
    const double ofOther = other.deflections[k];
    const std::uint32_t regionOfOne = one.regions.of[i];
    const std::uint32_t regionOfOther = other.regions.of[k];
    if (isKnown(measured.one, regionOfOne, ofOne, ofOther) && isKnown(measured.other, regionOfOther, ofOther, ofOne)) {
      return true;
    }
    const double near = ofOne + ofOther + off;
    const Triangle& a = one.tree.triangles()[i];
    const Triangle& b = other.tree.triangles()[k];
    const double apart = trianglesMeet(a, b) ? 0.0 : std::sqrt(triangleDistance(a, b).squared);
    if (apart <= near + depthBelow(measured.one, regionOfOne)) touch(measured.one, regionOfOne, ofOne, ofOther);
    if (apart <= near + depthBelow(measured.other, regionOfOther)) touch(measured.other, regionOfOther, ofOther, ofOne);
    return !stop.stopRequested();
  });
}

bool addsSagitta(const PairWord* word) {
  return word != nullptr && (word->kind == "thread" || word->kind == "cylindrical" || word->kind == "press");
}

/// The largest sagitta of the facets of a side that are in the fit; 0 where the file states its faces.
double sagittaInFit(const MeasuredBody& side) {
  if (!side.body.mesh.faces.empty()) return 0.0;
  double most = 0.0;
  for (std::uint32_t r = 0; r < side.body.regions.count; ++r) {
    if (side.measured.touches[r] || side.measured.overlap.depths[r] > 0.0)
      most = std::max(most, side.body.regions.sagitta[r]);
  }
  return most;
}

/// The sagittas of the faces that a person calls cylinders: of bodies whose files state no faces.
double sagittaByPerson(const MeasuredBody& side, double ofOther, std::uint32_t region) {
  if (side.body.regions.sagitta[region] <= 0.0) return 0.0;
  return ofOther + (side.body.mesh.faces.empty() ? side.body.regions.sagitta[region] : 0.0);
}

/// A facet of a curved surface that is in the fit may be taken thinner by as much as the one next to it: they share an
/// edge. Facets that are not in the fit stay whole: they may be under a lip.
std::vector<double> withNextFacets(const FaceRegions& regions, const std::vector<double>& sums) {
  std::vector<double> most = sums;
  for (std::size_t r = 0; r < regions.next.size(); ++r) {
    if (sums[r] <= 0.0) continue;
    for (const std::uint32_t next : regions.next[r]) most[r] = std::max(most[r], sums[next]);
  }
  return most;
}

AllowanceBound boundOf(const MeasuredBody& side, const MeasuredBody& other, double spacing, double margin,
                       const PairWord* word) {
  const FaceRegions& regions = side.body.regions;
  AllowanceBound bound;
  std::vector<double> sums(regions.count, 0.0);
  const double ofOther = addsSagitta(word) ? sagittaInFit(other) : 0.0;
  for (std::uint32_t r = 0; r < regions.count; ++r) {
    const double overlap = side.measured.overlap.depths[r];
    if (overlap <= 0.0 && !side.measured.touches[r]) continue;
    Evidence evidence{overlap, side.measured.own[r] + side.measured.others[r], spacing, margin, 0.0};
    if (addsSagitta(word)) evidence.byPerson = sagittaByPerson(side, ofOther, r);
    if (word != nullptr && word->allowance) evidence = {0.0, 0.0, 0.0, 0.0, *word->allowance};
    bound.inFit = true;
    sums[r] = evidence.sum();
    if (sums[r] <= bound.most) continue;
    bound.most = sums[r];
    bound.largest = evidence;
  }
  if (side.body.mesh.faces.empty()) sums = withNextFacets(regions, sums);
  for (const std::uint32_t region : regions.of) bound.atMost.push_back(sums[region]);
  return bound;
}

/// Nothing is taken from a body whose faces the other one is below by so much, metres.
void refuseClash(AllowanceBound& bound, double overlap) {
  if (!bound.inFit) return;
  std::ostringstream text;
  text.precision(3);
  text << "they overlap by " << overlap * 1e3 << " mm, which is a clash that nobody accepted";
  bound.refused = text.str();
  bound.clash = overlap;
  bound.most = 0.0;
  std::fill(bound.atMost.begin(), bound.atMost.end(), 0.0);
}

bool isClash(double overlap, double thickness, const FitWords& fits, const PairWord* word) {
  if (overlap <= kClashOverlap && overlap <= kClashShare * thickness) return false;
  const bool said = word != nullptr && (word->allowance || (!word->kind.empty() && word->kind != "clash"));
  return !said && !fits.accepts(word, overlap);
}

}  // namespace

void addBend(const std::vector<bool>& hook, double bend, const PlacedBody& body, double spacing,
             AllowanceBound& bound) {
  const double margin = assembledMargin(std::max(body.radius, body.halfDiagonal));
  const Evidence evidence{0.0, 0.0, spacing, margin, bend};
  bool any = false;
  for (std::size_t t = 0; t < bound.atMost.size(); ++t) {
    if (!hook[body.regions.of[t]]) continue;
    bound.atMost[t] = std::max(bound.atMost[t], evidence.sum());
    any = true;
  }
  if (!any) return;
  bound.share = kHookShare;
  bound.inFit = true;
  if (evidence.sum() <= bound.most) return;
  bound.most = evidence.sum();
  bound.largest = evidence;
}

double assembledMargin(double radius) {
  constexpr double kLeastMargin = 1e-6;
  constexpr double kClearances = 4.0;
  return std::max(kLeastMargin, kClearances * tolerance::kRequiredClearance * radius);
}

double touchingReach(const PlacedBody& one, const PlacedBody& other) {
  return one.spacing + other.spacing + kTouchingSurfaces + one.largestDeflection + other.largestDeflection;
}

MeasuredPair measurePair(const PlacedBody& one, const PlacedBody& other, const StopToken& stop) {
  MeasuredPair measured{emptySide(one, overlapIn(one, other, stop)), emptySide(other, overlapIn(other, one, stop))};
  findTouching(one, other, measured, stop);
  return measured;
}

PairBounds boundsOf(const MeasuredBody& one, const MeasuredBody& other, const FitWords& fits, const PairWord* word) {
  const double spacing = one.body.spacing + other.body.spacing;
  // A body that gives way has no reference point to turn about: its own size counts, or that of the one that moves.
  const double sizeOfOther = std::max(one.body.radius, other.body.halfDiagonal);
  PairBounds bounds{boundOf(one, other, spacing, assembledMargin(one.body.radius), word),
                    boundOf(other, one, spacing, assembledMargin(sizeOfOther), word)};
  // Either body may give way by what the other one is below its own faces: a belt that is deep in a pulley is a clash
  // for the pulley's faces, however little the pulley's surface is in the belt.
  // Where only the one surface is inside the other body, that counts for both.
  const double a = one.measured.overlap.deepest;
  const double b = other.measured.overlap.deepest;
  const double thickness = std::max(one.measured.overlap.thickness, other.measured.overlap.thickness);
  const double ofOne = a > 0.0 ? a : b;
  const double ofOther = b > 0.0 ? b : a;
  if (isClash(ofOne, thickness, fits, word)) refuseClash(bounds.one, ofOne);
  if (isClash(ofOther, thickness, fits, word)) refuseClash(bounds.other, ofOther);
  return bounds;
}

double PairBounds::clash() const {
  if (refused().empty()) return 0.0;
  if (one.clash <= 0.0 || other.clash <= 0.0) return std::max(one.clash, other.clash);
  return std::min(one.clash, other.clash);
}

std::string PairBounds::refused() const {
  if (one.most > 0.0 || other.most > 0.0) return {};
  return one.refused.empty() ? other.refused : one.refused;
}

AllowanceBound united(const AllowanceBound& a, const AllowanceBound& b) {
  AllowanceBound both = a.most >= b.most ? a : b;
  for (std::size_t t = 0; t < both.atMost.size(); ++t) both.atMost[t] = std::max(a.atMost[t], b.atMost[t]);
  both.inFit = a.inFit || b.inFit;
  both.share = std::max(a.share, b.share);
  if (a.clash > 0.0 || b.clash > 0.0) refuseClash(both, std::max(a.clash, b.clash));
  return both;
}

const SnapWord* FitWords::snapOf(const std::string& a, const std::string& b) const {
  const auto found = std::find_if(snaps.begin(), snaps.end(), [&](const SnapWord& word) {
    return (word.hook == a && word.edge == b) || (word.hook == b && word.edge == a);
  });
  return found == snaps.end() ? nullptr : &*found;
}

std::string FitWords::partingOf(const std::string& a, const std::string& b) const {
  if (partings.anyPair) return "a person uses no joints";
  const std::pair<std::string, std::string> pair = std::minmax(a, b);
  if (std::find(partings.pairs.begin(), partings.pairs.end(), pair) != partings.pairs.end()) {
    return "a person has dissolved their joint, or has it pressed out";
  }
  const PairWord* word = about(a, b);
  if (word == nullptr || word->isThread()) return {};
  if (!word->kind.empty()) return "a person calls the pair '" + word->kind + "'";
  return word->accepted ? "a person accepts their clash" : "";
}

const PairWord* FitWords::about(const std::string& a, const std::string& b) const {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const PairWord& word) {
    return (word.a == a && word.b == b) || (word.a == b && word.b == a);
  });
  return found == pairs.end() ? nullptr : &*found;
}

}  // namespace glissade::check
