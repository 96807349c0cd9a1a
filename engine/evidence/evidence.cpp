#include "engine/evidence/evidence.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/tolerances.h"
#include "engine/evidence/overlap.h"
#include "engine/evidence/pulled_thread.h"

namespace glissade::evidence {
namespace {

constexpr double kTouchingSurfaces = 3e-6;  ///< metres: tolerance for fitting and rounding
constexpr double kClashShare = 0.2;         ///< share of the local thickness

MeasuredSide emptySide(const PlacedBody& body, Overlap overlap) {
  const std::size_t count = body.regions.count;
  return {std::move(overlap), std::vector<bool>(count, false), std::vector<double>(count, 0.0),
          std::vector<double>(count, 0.0)};
}

/// True if a touch of the region with these deflections adds nothing.
bool isKnown(const MeasuredSide& side, std::uint32_t region, double own, double others) {
  return side.touches[region] && side.own[region] >= own && side.others[region] >= others;
}

void touch(MeasuredSide& side, std::uint32_t region, double own, double others) {
  side.touches[region] = true;
  side.own[region] = std::max(side.own[region], own);
  side.others[region] = std::max(side.others[region], others);
}

/// Metres: how far the other surface may be below the face and still face it.
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

/// Limit, metres, of an overlap that deviations of the files explain: it counts for the whole region.
double countsEverywhere(const PlacedBody& body, const MeasuredSide& side, std::uint32_t region) {
  const double sagitta = body.mesh.faces.empty() ? body.regions.sagitta[region] : 0.0;
  return side.localDepth + side.own[region] + side.others[region] + sagitta;
}

/// Neighbouring facets of a curved surface without stated faces share the largest of their depths.
std::vector<double> depthsOfPatches(const PlacedBody& body, const MeasuredSide& side) {
  std::vector<double> depths = side.overlap.depths;
  for (std::size_t r = 0; r < body.regions.next.size() && body.mesh.faces.empty(); ++r) {
    for (const std::uint32_t next : body.regions.next[r]) depths[r] = std::max(depths[r], side.overlap.depths[next]);
  }
  for (std::uint32_t r = 0; r < depths.size(); ++r) {
    if (depths[r] <= countsEverywhere(body, side, r)) depths[r] = 0.0;
  }
  return depths;
}

/// The depth of each patch, if a region has several.
std::vector<double> measuredPatches(const PlacedBody& body, const PlacedBody& other, const MeasuredSide& side,
                                    const StopToken& stop) {
  PlacedBody fine(Body{"", "", side.mesh, Pose::identity()}, Pose::identity());
  const auto count = static_cast<std::uint32_t>(side.patches->regions.size());
  for (std::size_t t = 0; t < side.patches->triangles.size(); ++t) {
    const std::uint32_t patch = side.patches->patches[t];
    const std::uint32_t region = body.regions.of[side.patches->parents[t]];
    fine.regions.of[t] = patch == FacePatches::kNone ? count + region : patch;
  }
  fine.regions.count = count + body.regions.count;
  return overlapIn(fine, other, stop).depths;
}

void findPatches(const PlacedBody& body, const PlacedBody& other, MeasuredSide& side, const StopToken& stop) {
  side.localDepth = body.spacing + other.spacing + assembledMargin(std::max(body.radius, body.halfDiagonal));
  if (body.regions.count == 0) return;
  const std::vector<double> depths = depthsOfPatches(body, side);
  double above = kTouchingSurfaces + body.spacing + other.spacing + body.largestDeflection + other.largestDeflection;
  if (body.mesh.faces.empty()) above += *std::max_element(body.regions.sagitta.begin(), body.regions.sagitta.end());
  side.patches = facePatchesOf({body, other, depths, above}, stop);
  if (!side.patches) return;
  side.mesh = std::make_shared<const TriangleMesh>(side.patches->divided(body.mesh));
  side.patchDepths.assign(side.patches->regions.size(), 0.0);
  bool isSingle = true;
  std::vector<std::uint32_t> patchOf(body.regions.count, FacePatches::kNone);
  for (std::size_t t = 0; t < side.patches->triangles.size(); ++t) {
    const std::uint32_t patch = side.patches->patches[t];
    if (patch == FacePatches::kNone) continue;
    const std::uint32_t region = body.regions.of[side.patches->parents[t]];
    side.patchDepths[patch] = std::max(side.patchDepths[patch], depths[region]);
    isSingle = isSingle && (patchOf[region] == FacePatches::kNone || patchOf[region] == patch);
    patchOf[region] = patch;
  }
  if (isSingle) return;
  const std::vector<double> measured = measuredPatches(body, other, side, stop);
  for (std::size_t i = 0; i < side.patchDepths.size(); ++i) {
    side.patchDepths[i] = std::min(side.patchDepths[i], measured[i]);
  }
}

bool addsSagitta(const PairWord* word) {
  return word != nullptr && (word->kind == "thread" || word->kind == "cylindrical" || word->kind == "press");
}

/// The largest sagitta of the side's facets that are in the fit; 0 if the file states its faces.
double sagittaInFit(const MeasuredBody& side) {
  if (!side.body.mesh.faces.empty()) return 0.0;
  double most = 0.0;
  for (std::uint32_t r = 0; r < side.body.regions.count; ++r) {
    if (side.measured.touches[r] || side.measured.overlap.depths[r] > 0.0)
      most = std::max(most, side.body.regions.sagitta[r]);
  }
  return most;
}

/// The sagittas of the region and of the other body, if a person calls the pair cylindrical and the files state no
/// faces.
double sagittaByPerson(const MeasuredBody& side, double ofOther, std::uint32_t region) {
  if (side.body.regions.sagitta[region] <= 0.0) return 0.0;
  return ofOther + (side.body.mesh.faces.empty() ? side.body.regions.sagitta[region] : 0.0);
}

/// A facet of a curved surface that is in the fit may be thinned as much as its neighbour, because they share an edge.
/// Facets that are not in the fit stay whole: they may be under a lip.
std::vector<double> withNextFacets(const FaceRegions& regions, const std::vector<double>& sums) {
  std::vector<double> most = sums;
  for (std::size_t r = 0; r < regions.next.size(); ++r) {
    if (sums[r] <= 0.0) continue;
    for (const std::uint32_t next : regions.next[r]) most[r] = std::max(most[r], sums[next]);
  }
  return most;
}

/// The overlap that counts for the whole region: only one that needs no patch.
double overlapOfRegion(const MeasuredBody& side, std::uint32_t region) {
  const double overlap = side.measured.overlap.depths[region];
  return overlap > countsEverywhere(side.body, side.measured, region) ? 0.0 : overlap;
}

/// Each triangle gets the allowance of its region, and a triangle of a patch that of the patch.
void setAtMost(const MeasuredSide& side, const FaceRegions& regions, const std::vector<double>& ofRegions,
               const std::vector<double>& ofPatches, AllowanceBound& bound) {
  if (!side.patches) {
    for (const std::uint32_t region : regions.of) bound.atMost.push_back(ofRegions[region]);
    return;
  }
  const std::vector<std::uint32_t>& parents = side.patches->parents;
  if (!side.patches->newVertices.empty()) {
    bound.mesh = side.mesh;
    bound.parents = parents;
  }
  for (std::size_t t = 0; t < parents.size(); ++t) {
    const std::uint32_t patch = side.patches->patches[t];
    const double ofRegion = ofRegions[regions.of[parents[t]]];
    bound.atMost.push_back(patch == FacePatches::kNone ? ofRegion : std::max(ofRegion, ofPatches[patch]));
  }
}

AllowanceBound boundOf(const MeasuredBody& side, const MeasuredBody& other, double spacing, double margin,
                       const PairWord* word) {
  const FaceRegions& regions = side.body.regions;
  AllowanceBound bound;
  std::vector<double> sums(regions.count, 0.0);
  std::vector<Evidence> ofRegions(regions.count, Evidence{0.0, 0.0, spacing, margin, 0.0});
  const auto take = [&bound](const Evidence& evidence) {
    if (evidence.sum() > bound.most) {
      bound.most = evidence.sum();
      bound.largest = evidence;
    }
    return evidence.sum();
  };
  const double ofOther = addsSagitta(word) ? sagittaInFit(other) : 0.0;
  for (std::uint32_t r = 0; r < regions.count; ++r) {
    const double overlap = side.measured.overlap.depths[r];
    if (overlap <= 0.0 && !side.measured.touches[r]) continue;
    Evidence evidence{overlapOfRegion(side, r), side.measured.own[r] + side.measured.others[r], spacing, margin, 0.0};
    if (addsSagitta(word)) evidence.byPerson = sagittaByPerson(side, ofOther, r);
    if (word != nullptr && word->allowance) evidence = {0.0, 0.0, 0.0, 0.0, *word->allowance};
    bound.inFit = true;
    sums[r] = take(evidence);
    ofRegions[r] = evidence;
  }
  if (side.body.mesh.faces.empty()) sums = withNextFacets(regions, sums);
  std::vector<double> ofPatches;
  for (std::size_t i = 0; i < side.measured.patchDepths.size(); ++i) {
    Evidence evidence = ofRegions[side.measured.patches->regions[i]];
    if (word == nullptr || !word->allowance) evidence.overlap = side.measured.patchDepths[i];
    ofPatches.push_back(take(evidence));
  }
  setAtMost(side.measured, regions, sums, ofPatches, bound);
  return bound;
}

std::vector<double> leastOfTriangles(const AllowanceBound& bound) {
  if (bound.parents.empty()) return bound.atMost;
  std::map<std::uint32_t, double> least;
  for (std::size_t t = 0; t < bound.parents.size(); ++t) {
    const auto [known, isNew] = least.try_emplace(bound.parents[t], bound.atMost[t]);
    if (!isNew) known->second = std::min(known->second, bound.atMost[t]);
  }
  std::vector<double> all;
  for (const auto& [triangle, each] : least) all.push_back(each);
  return all;
}

/// Removes the allowance of a body whose faces the other body is too far below.
void refuseClash(AllowanceBound& bound) {
  bound.isClash = true;
  bound.most = 0.0;
  std::fill(bound.atMost.begin(), bound.atMost.end(), 0.0);
}

/// Rounds up to whole micrometres; an excess by the rounding of coordinates adds none.
double inMicrometresUp(double metres) {
  constexpr double kRounding = 1e-3;
  return std::max(0.0, std::ceil(metres * 1e6 - kRounding)) * 1e-6;
}

/// True if an overlap of this depth in a pair of this thickness is a clash, whatever a person accepts.
bool isClash(double overlap, double thickness, const PairWord* word) {
  if (overlap <= kClashOverlap && overlap <= kClashShare * thickness) return false;
  return word == nullptr || (!word->allowance && (word->kind.empty() || word->kind == "clash"));
}

}  // namespace

void addBend(const std::vector<bool>& hook, double bend, const PlacedBody& body, double spacing,
             AllowanceBound& bound) {
  const double margin = assembledMargin(std::max(body.radius, body.halfDiagonal));
  const Evidence evidence{0.0, 0.0, spacing, margin, bend};
  bool any = false;
  for (std::size_t t = 0; t < bound.atMost.size(); ++t) {
    if (!hook[body.regions.of[bound.parents.empty() ? t : bound.parents[t]]]) continue;
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
  findPatches(one, other, measured.one, stop);
  findPatches(other, one, measured.other, stop);
  return measured;
}

std::vector<double> mostOfTriangles(const AllowanceBound& bound, std::size_t count) {
  if (bound.parents.empty()) return bound.atMost;
  std::vector<double> most(count, 0.0);
  for (std::size_t t = 0; t < bound.parents.size(); ++t) {
    most[bound.parents[t]] = std::max(most[bound.parents[t]], bound.atMost[t]);
  }
  return most;
}

PairBounds boundsOf(const MeasuredBody& one, const MeasuredBody& other, const FitWords& fits, const PairWord* word) {
  const double spacing = one.body.spacing + other.body.spacing;
  // A body at rest has no reference point to turn about: its size counts, or the size of the moving body if that is
  // larger.
  const double sizeOfOther = std::max(one.body.radius, other.body.halfDiagonal);
  PairBounds bounds{boundOf(one, other, spacing, assembledMargin(one.body.radius), word),
                    boundOf(other, one, spacing, assembledMargin(sizeOfOther), word)};
  // Each body may be thinned by the depth of the other body below its faces: a belt deep in a pulley is a clash for the
  // pulley's faces, however little the pulley's surface is in the belt. If only one surface is inside the other body,
  // its depth counts for both.
  const double a = one.measured.overlap.deepest;
  const double b = other.measured.overlap.deepest;
  const double ofOne = a > 0.0 ? a : b;
  const double ofOther = b > 0.0 ? b : a;
  const double off =
      kTouchingSurfaces + spacing + std::max(bounds.one.largest.deflection, bounds.other.largest.deflection);
  const RoundOverlap round = roundOverlap(one.body, other.body);
  // A shaft in a hole is as thick as its diameter, wherever the deepest point is. A thread is no clash.
  const bool isRound = std::max(ofOne, ofOther) <= touchingReach(one.body, other.body) + round.depth;
  const double thickness =
      std::max({one.measured.overlap.thickness, other.measured.overlap.thickness, isRound ? 2.0 * round.radius : 0.0});
  const bool isThread = isRound && isCoreOfThread(round.radius, round.depth);
  if (isThread) bounds.one.share = bounds.other.share = kThreadShare;
  bounds.depth = inMicrometresUp(std::min(ofOne, ofOther));
  const auto isRefused = [&](double overlap) {
    return !isThread && isClash(overlap, thickness, word) && !fits.accepts(word, overlap, bounds.depth);
  };
  if (isRefused(ofOne)) refuseClash(bounds.one);
  if (isRefused(ofOther)) refuseClash(bounds.other);
  const bool isStated = word != nullptr && (word->allowance || !word->kind.empty() || word->accepted);
  bounds.isPlainOverlap = !isStated && !isThread && bounds.depth > off + round.depth;
  bounds.isRefused = bounds.one.most <= 0.0 && bounds.other.most <= 0.0 &&
                     (bounds.one.isClash || bounds.other.isClash) && !fits.accepts(word, bounds.depth);
  return bounds;
}

Message clashRefused(double depth) {
  return {GLISSADE_TEXT("they overlap by %1, a clash that is not accepted"), {Depth{depth}}};
}

AllowanceBound larger(const AllowanceBound& a, const AllowanceBound& b) {
  const AllowanceBound& less = a.most >= b.most ? b : a;
  AllowanceBound both = a.most >= b.most ? a : b;
  // If the meshes differ, the least allowance on a triangle of the body counts for the whole triangle.
  const std::vector<double> least = leastOfTriangles(less);
  for (std::size_t t = 0; t < both.atMost.size(); ++t) {
    const double other = less.mesh == both.mesh ? less.atMost[t] : least[both.parents.empty() ? t : both.parents[t]];
    both.atMost[t] = std::max(both.atMost[t], other);
  }
  both.inFit = a.inFit || b.inFit;
  both.share = std::max(a.share, b.share);
  if (a.isClash || b.isClash) refuseClash(both);
  return both;
}

PairBounds united(const PairBounds& a, const PairBounds& b) {
  PairBounds both{larger(a.one, b.one), larger(a.other, b.other), std::max(a.depth, b.depth)};
  both.isPlainOverlap = a.isPlainOverlap || b.isPlainOverlap;
  both.isRefused = (a.isRefused || b.isRefused) && both.one.most <= 0.0 && both.other.most <= 0.0;
  return both;
}

}  // namespace glissade::evidence
