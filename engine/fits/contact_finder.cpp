#include "engine/fits/contact_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "engine/evidence/pulled_thread.h"
#include "engine/fits/region_pair.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {
namespace {

using Label = SurfaceRegions::Label;
using LabelKind = SurfaceRegions::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Fitted surfaces within this distance touch, metres: tolerance for fitting and rounding.
constexpr double kTouching = 3e-6;

/// Compares the near triangles of two bodies.
class PairExaminer {
 public:
  PairExaminer(const PreparedBody& a, const PreparedBody& b, const ContactLimits& limits)
      : a_(a), b_(b), limits_(limits), reach_(limits.clearanceUpTo + kTouching + a.deviation + b.deviation) {}

  std::optional<Contact> examine() {
    a_.tree.visitPairs(b_.tree, reach_, [&](std::uint32_t i, std::uint32_t k) {
      takePair(i, k);
      return true;
    });
    conclude();
    return contact_;
  }

 private:
  /// The two labels of a pair of triangles as one number.
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  static std::uint64_t numberOf(const Label& label) {
    return (static_cast<std::uint64_t>(label.kind) << 32U) | label.index;
  }

  /// Contact of nested cones, balls and tori.
  struct Nested {
    bool touches = false;
    double overlap = 0.0;  ///< the largest overlap
    double radius = 0.0;   ///< radius of the inner one at that overlap
    std::optional<ContactAxis> axis{};

    void take(const RegionPair& exact) {
      touches = touches || std::abs(exact.gap) <= kTouching;
      if (exact.gap > kTouching || (axis && -exact.gap <= overlap)) return;
      axis = exact.axis;
      if (-exact.gap <= std::max(kTouching, overlap)) return;
      overlap = -exact.gap;
      radius = exact.radius;
    }
  };

  struct Near {
    std::optional<RegionPair> exact;
    Label labelA;
    Label labelB;
    bool beside = false;     ///< the surfaces of `exact` are beside each other
    bool meet = false;       ///< triangles meet
    double gap = kInfinity;  ///< gap between triangles that do not meet
    double deviation = 0.0;  ///< deviation of both surfaces from their triangles
  };

  void takePair(std::uint32_t i, std::uint32_t k) {
    const Label& labelA = a_.regions.labels[i];
    const Label& labelB = b_.regions.labels[k];
    auto [at, isNew] = near_.try_emplace(Key{numberOf(labelA), numberOf(labelB)});
    Near& near = at->second;
    if (isNew) {
      near.exact = compareRegions(a_.regions, labelA, b_.regions, labelB);
      near.labelA = labelA;
      near.labelB = labelB;
      near.deviation = a_.deviationOf(labelA) + b_.deviationOf(labelB);
    }
    if (near.exact && near.exact->gap > reach_) return;
    const Triangle& triangleA = a_.tree.triangles()[i];
    const Triangle& triangleB = b_.tree.triangles()[k];
    if (near.exact && !near.beside) near.beside = areBeside(near, triangleA, triangleB);
    if (near.meet) return;
    if (trianglesMeet(triangleA, triangleB)) {
      near.meet = true;
    } else if (!near.exact) {
      near.gap = std::min(near.gap, std::sqrt(triangleDistance(triangleA, triangleB).squared));
    }
  }

  bool areBeside(const Near& near, const Triangle& triangleA, const Triangle& triangleB) const {
    if (near.exact->kind != RegionPair::Kind::Planes) return true;
    return std::abs(near.exact->gap) <= reach_ &&
           overlapInPlane(triangleA, triangleB, a_.regions.planes[near.labelA.index]);
  }

  void conclude() {
    summarize();
    findThreads();
    findNestedOverlaps();
    measureDepth();
    if (deepest_ > 0.0) {
      setOverlap(ContactKind::Overlap, deepest_, unsure_);
    } else if (nested_.overlap > std::max(kTouching, thickest_)) {
      thickness_ = 2.0 * nested_.radius;
      setOverlap(ContactKind::Overlap, nested_.overlap, 0.0);
    } else if (thickest_ > kTouching) {
      const double shaft = std::max(axis_->radiusA, axis_->radiusB);
      thickness_ = 2.0 * shaft;
      setOverlap(evidence::hasDepthOfThread(shaft, thickest_) ? ContactKind::Thread : ContactKind::Press, thickest_,
                 0.0);
    } else if (coaxialTouch_ || planarTouch_) {
      set(coaxialTouch_ ? ContactKind::Cylindrical : ContactKind::Planar, 0.0, 0.0);
    } else if (tangentTouch_ || nested_.touches || meetsExactly_ ||
               (freeGap_ <= freeUnsure_ + kTouching && !(exactGap_ > kTouching && fromExact_))) {
      set(ContactKind::Contact, 0.0, tangentTouch_ || nested_.touches ? 0.0 : freeUnsure_);
    } else {
      // If both methods found the same gap, the exact value counts.
      const bool same = fromExact_ && std::abs(exactGap_ - freeGap_) <= unsure_;
      const double gap = same ? exactGap_ : std::min(exactGap_, freeGap_);
      if (gap <= limits_.clearanceUpTo) set(ContactKind::Clearance, gap, gap == exactGap_ ? 0.0 : freeUnsure_);
    }
  }

  void summarize() {
    for (const auto& [key, near] : near_) {
      meet_ = meet_ || near.meet;
      meetsExactly_ = meetsExactly_ || (near.meet && near.deviation == 0.0);
      unsure_ = std::max(unsure_, near.deviation);
      if (!near.exact || !near.beside || isEmptyBetween(near)) continue;
      takeExact(*near.exact);
      if (near.exact->gap > kTouching) {
        apartA_.insert(numberOf(near.labelA));
        apartB_.insert(numberOf(near.labelB));
      }
      if (std::abs(near.exact->gap) > kTouching) continue;
      coincidentA_.insert(numberOf(near.labelA));
      coincidentB_.insert(numberOf(near.labelB));
    }
    for (const auto& [key, near] : near_) {
      if (near.exact) continue;
      // With coarse triangles, the rim of a hole seems to touch a shaft that does not fill it.
      const double gap = near.meet ? 0.0 : near.gap;
      if (gap - near.deviation >= freeGap_ - freeUnsure_) continue;
      freeGap_ = gap;
      freeUnsure_ = near.deviation;
      fromExact_ = isExplained(near);
    }
  }

  /// True if surfaces that were compared exactly explain the least gap of these triangles: a rim of a plane or a
  /// cylinder, or of a round surface with the exact gap. Triangles without deviation have the gap of their surfaces.
  bool isExplained(const Near& near) const {
    if (near.deviation == 0.0) return false;
    const auto isKnown = [](const Label& label) {
      return label.kind == LabelKind::Plane || label.kind == LabelKind::Cylinder;
    };
    if (near.labelA.kind == LabelKind::Free || near.labelB.kind == LabelKind::Free) return false;
    return (isKnown(near.labelA) && isKnown(near.labelB)) || apartA_.count(numberOf(near.labelA)) > 0 ||
           apartB_.count(numberOf(near.labelB)) > 0;
  }

  /// True if no body is between the radii of a shaft and its narrower hole: a surface that is inside out has no hole.
  bool isEmptyBetween(const Near& near) const {
    const RegionPair& exact = *near.exact;
    if (exact.gap >= -kTouching || a_.depth() == nullptr || b_.depth() == nullptr) return false;
    if (exact.kind == RegionPair::Kind::Nested) return !isFilledByBoth(near.labelA, near.labelB, exact.gap);
    return exact.kind == RegionPair::Kind::Coaxial && !isFilledByBoth(*exact.axis);
  }

  /// Finds shafts thicker than their coaxial holes, whose triangles need not be near each other.
  void findThreads() {
    if (!meet_ || a_.depth() == nullptr || b_.depth() == nullptr) return;
    for (std::uint32_t i = 0; i < a_.regions.cylinders.size(); ++i) {
      for (std::uint32_t k = 0; k < b_.regions.cylinders.size(); ++k) {
        const Label labelA{LabelKind::Cylinder, i};
        const Label labelB{LabelKind::Cylinder, k};
        const auto exact = compareRegions(a_.regions, labelA, b_.regions, labelB);
        if (!exact || exact->kind != RegionPair::Kind::Coaxial || exact->gap > -kTouching) continue;
        if (-exact->gap <= thickest_ || !isFilledByBoth(*exact->axis)) continue;
        takeExact(*exact);
        unsure_ = std::max(unsure_, a_.deviationOf(labelA) + b_.deviationOf(labelB));
      }
    }
  }

  /// Finds cones, balls and tori that are thicker than the surface around them; their triangles need not be near each
  /// other.
  void findNestedOverlaps() {
    if (!meet_ || a_.depth() == nullptr || b_.depth() == nullptr) return;
    for (std::uint32_t i = 0; i < a_.regions.rounds.size(); ++i) {
      for (std::uint32_t k = 0; k < b_.regions.rounds.size(); ++k) {
        const Label labelA{LabelKind::Round, i};
        const Label labelB{LabelKind::Round, k};
        const auto exact = compareRegions(a_.regions, labelA, b_.regions, labelB);
        if (!exact || exact->gap > -kTouching || -exact->gap <= nested_.overlap) continue;
        if (!isFilledByBoth(labelA, labelB, exact->gap)) continue;
        takeExact(*exact);
        unsure_ = std::max(unsure_, a_.deviationOf(labelA) + b_.deviationOf(labelB));
      }
    }
  }

  /// True if a point between the two nested surfaces is inside both bodies: below the inner one's triangles, near a
  /// corner, by half of the overlap.
  bool isFilledByBoth(const Label& labelA, const Label& labelB, double gap) const {
    constexpr double kTowardsMiddle = 0.1;
    const bool innerIsA = a_.regions.rounds[labelA.index].shaft;
    const PreparedBody& inner = innerIsA ? a_ : b_;
    const Label& label = innerIsA ? labelA : labelB;
    for (std::size_t t = 0; t < inner.regions.labels.size(); ++t) {
      if (inner.regions.labels[t] != label) continue;
      const Triangle& triangle = inner.tree.triangles()[t];
      const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
      const Vector3 inwards =
          0.5 * gap * (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).stableNormalized();
      for (const Vector3& corner : triangle) {
        const Vector3 on = corner + kTowardsMiddle * (middle - corner);
        for (const Vector3& p : {Vector3(on + inwards), Vector3(on - inwards)}) {
          if (a_.depth()->contains(p) && b_.depth()->contains(p)) return true;
        }
      }
    }
    return false;
  }

  /// True if a point between the two radii is inside both bodies.
  bool isFilledByBoth(const ContactAxis& axis) const {
    constexpr int kAngles = 12;
    const Vector3 u = axis.direction.unitOrthogonal();
    const Vector3 v = axis.direction.cross(u);
    for (int i = 0; i < kAngles; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.37) / kAngles;
      const Vector3 p = axis.point + 0.5 * (axis.radiusA + axis.radiusB) * (std::cos(angle) * u + std::sin(angle) * v);
      if (a_.depth()->contains(p) && b_.depth()->contains(p)) return true;
    }
    return false;
  }

  void takeExact(const RegionPair& exact) {
    const bool touches = std::abs(exact.gap) <= kTouching;
    if (exact.gap > kTouching) exactGap_ = std::min(exactGap_, exact.gap);
    switch (exact.kind) {
      case RegionPair::Kind::Planes: planarTouch_ = planarTouch_ || touches; break;
      case RegionPair::Kind::Tangent: tangentTouch_ = tangentTouch_ || touches; break;
      case RegionPair::Kind::Coaxial:
        coaxialTouch_ = coaxialTouch_ || touches;
        if (!axis_ || -exact.gap > thickest_) {
          axis_ = exact.axis;
          thickest_ = -exact.gap;
        }
        break;
      case RegionPair::Kind::Nested: nested_.take(exact); break;
    }
  }

  /// Measures the depth in the body in which the other is less deep, because thinning either one ends the overlap.
  /// Searches depths beyond those that fitted surfaces and tessellation explain.
  void measureDepth() {
    if (!meet_ && !a_.tree.box().intersects(b_.tree.box())) return;
    const SolidDepth* solidA = a_.depth();
    const SolidDepth* solidB = b_.depth();
    if (solidA == nullptr || solidB == nullptr) return;
    const double floor = unsure_ + std::max({0.0, thickest_, nested_.overlap}) + kTouching;
    const auto inA = depthInside(b_.tree, a_.tree, *solidA, floor, [&](std::uint32_t t) {
      return coincidentB_.count(numberOf(b_.regions.labels[t])) > 0;
    });
    if (meet_ && !inA) return;
    const auto inB = depthInside(a_.tree, b_.tree, *solidB, floor, [&](std::uint32_t t) {
      return coincidentA_.count(numberOf(a_.regions.labels[t])) > 0;
    });
    if (inA && inB) {
      deepest_ = std::min(inA->depth, inB->depth);
      thickness_ = std::max(solidA->thicknessBelow(a_.tree.triangles()[inA->triangle]),
                            solidB->thicknessBelow(b_.tree.triangles()[inB->triangle]));
    } else if (!meet_ && (inA || inB)) {
      deepest_ = inA ? inA->depth : inB->depth;  // one body is completely inside the other
    }
  }

  void setOverlap(ContactKind kind, double overlap, double uncertainty) {
    const bool isThread = kind == ContactKind::Thread && evidence::isCoreOfThread(0.5 * thickness_, overlap);
    const bool large = !isThread && (overlap > limits_.clashOverlap || overlap > limits_.clashThickness * thickness_);
    set(large ? ContactKind::Clash : kind, 0.0, uncertainty);
    contact_->overlap = overlap;
    contact_->thickness = std::isfinite(thickness_) ? thickness_ : 0.0;
  }

  void set(ContactKind kind, double gap, double uncertainty) {
    contact_.emplace();
    contact_->kind = kind;
    contact_->gap = gap;
    contact_->uncertainty = uncertainty;
    contact_->deviation = unsure_;
    const bool coaxial = kind == ContactKind::Cylindrical || kind == ContactKind::Thread || kind == ContactKind::Press;
    if (coaxial || (kind == ContactKind::Clash && thickest_ > kTouching)) {
      contact_->axis = axis_;
    } else if (nested_.touches || nested_.overlap > kTouching) {
      contact_->axis = nested_.axis;
    } else if (kind == ContactKind::Overlap || kind == ContactKind::Clash) {
      contact_->axis = axisBeside();
    }
  }

  /// The axis of a shaft that is in the wall of a hole, because the axes are parallel and beside each other, as of a
  /// screw that is placed so. The longest common part counts where there are several.
  std::optional<ContactAxis> axisBeside() const {
    constexpr double kParallel = 1e-4;
    constexpr double kMostBeside = 1e-3;
    std::optional<ContactAxis> longest;
    double length = 0.0;
    for (const CylinderRegion& own : a_.regions.cylinders) {
      for (const CylinderRegion& other : b_.regions.cylinders) {
        if (own.shaft == other.shaft) continue;
        const CylinderRegion& shaft = own.shaft ? own : other;
        const CylinderRegion& hole = own.shaft ? other : own;
        if (shaft.direction.cross(hole.direction).norm() > kParallel) continue;
        const Vector3 from = hole.point - shaft.point;
        const double beside = from.cross(shaft.direction).norm();
        if (beside + shaft.radius - hole.radius <= kTouching) continue;
        if (beside + std::abs(shaft.radius - hole.radius) > kMostBeside) continue;
        const double sense = shaft.direction.dot(hole.direction) < 0.0 ? -1.0 : 1.0;
        const double at = from.dot(shaft.direction);
        const auto [low, high] = std::minmax({at + sense * hole.low, at + sense * hole.high});
        const double common = std::min(high, shaft.high) - std::max(low, shaft.low);
        if (common <= length) continue;
        length = common;
        longest = ContactAxis{shaft.point, shaft.direction, own.radius, other.radius, own.shaft};
      }
    }
    return longest;
  }

  const PreparedBody& a_;
  const PreparedBody& b_;
  const ContactLimits& limits_;
  double reach_;
  std::map<Key, Near> near_;
  std::set<std::uint64_t> coincidentA_;  ///< labels of surfaces that coincide with one of the other body
  std::set<std::uint64_t> coincidentB_;
  bool meet_ = false;
  bool meetsExactly_ = false;  ///< planes meet: their triangles do not deviate from them
  bool planarTouch_ = false;
  bool coaxialTouch_ = false;
  bool tangentTouch_ = false;
  bool fromExact_ = false;  ///< the least gap of triangles is between fitted surfaces
  double exactGap_ = kInfinity;
  double freeGap_ = kInfinity;
  double freeUnsure_ = 0.0;
  double unsure_ = 0.0;
  std::set<std::uint64_t> apartA_;  ///< labels of surfaces that have an exact gap
  std::set<std::uint64_t> apartB_;
  Nested nested_;
  double thickest_ = -kInfinity;  ///< largest coaxial overlap; negative: gap
  std::optional<ContactAxis> axis_;
  double deepest_ = 0.0;
  double thickness_ = kInfinity;
  std::optional<Contact> contact_;
};

}  // namespace

PreparedBody::PreparedBody(TriangleMesh mesh_W, SurfaceRegions regions_W, double deflection_)
    : mesh(std::move(mesh_W)), tree(mesh), regions(std::move(regions_W)), deflection(deflection_) {
  const bool hasFree = std::any_of(regions.labels.begin(), regions.labels.end(),
                                   [](const Label& label) { return label.kind == LabelKind::Free; });
  if (hasFree) deviation = deflection;
  for (const CylinderRegion& cylinder : regions.cylinders) deviation = std::max(deviation, cylinder.sagitta);
  for (const RoundRegion& round : regions.rounds) deviation = std::max(deviation, round.sagitta);
}

const SolidDepth* PreparedBody::depth() const {
  std::call_once(isAsked_, [this] { solid_ = SolidDepth::of(mesh); });
  return solid_ ? &*solid_ : nullptr;
}

double PreparedBody::deviationOf(const Label& label) const {
  switch (label.kind) {
    case LabelKind::Plane: return 0.0;
    case LabelKind::Cylinder: return regions.cylinders[label.index].sagitta;
    case LabelKind::Round: return regions.rounds[label.index].sagitta;
    case LabelKind::Free: break;
  }
  return deflection;
}

std::optional<Contact> contactOf(const PreparedBody& a, const PreparedBody& b, const ContactLimits& limits) {
  return PairExaminer(a, b, limits).examine();
}

}  // namespace glissade
