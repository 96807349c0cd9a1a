#include "engine/fits/rolling_bearings.h"

#include <algorithm>

#include "engine/evidence/rolling_bearing.h"

namespace glissade {
namespace {

/// A body that rolls in a bearing.
struct RollingBody {
  std::size_t body = 0;
  evidence::RollingElement element;
};

class RollingBearingFinder {
 public:
  RollingBearingFinder(const ProductShapes& shapes, const StopToken& stop) : shapes_(shapes), stop_(stop) {
    for (std::size_t i = 0; i < shapes.size() && !stop_.stopRequested(); ++i) addPart(i);
  }

  Joints find() const {
    Joints units;
    std::vector<bool> isTaken(shapes_.size(), false);
    for (const std::size_t inner : rings_) {
      for (const std::size_t outer : rings_) {
        if (inner == outer || isTaken[inner] || isTaken[outer] || stop_.stopRequested()) continue;
        auto unit = unitOf(inner, outer);
        if (!unit) continue;
        isTaken[unit->body] = true;
        for (const std::size_t other : unit->others) isTaken[other] = true;
        units.push_back(std::move(*unit));
      }
    }
    return units;
  }

 private:
  void addPart(std::size_t body) {
    const RigidBody& rigid = shapes_.body(body);
    if (const auto middle = evidence::ballMiddle(*rigid.mesh)) {
      rolling_.push_back({body, {rigid.X_WB * *middle, true}});
      return;
    }
    const TurnedShape* shape = shapes_.turned(body);
    if (shape == nullptr) return;
    if (shape->kind == TurnedKind::Ring) rings_.push_back(body);
    if (shape->kind == TurnedKind::Rod) rolling_.push_back({body, {ringOf(body).middle(), false}});
  }

  /// The shape of a ring or a rod about its axis.
  evidence::BearingRing ringOf(std::size_t body) const {
    const TurnedShape& shape = *shapes_.turned(body);
    const AxisLine axis = shapes_.axisOf(body);
    return {axis.point, axis.direction, shape.hole, shape.outer, shape.low, shape.high};
  }

  std::optional<Joint> unitOf(std::size_t inner, std::size_t outer) const {
    const evidence::BearingRing in = ringOf(inner);
    const evidence::BearingRing out = ringOf(outer);
    if (!areRaces(in, out)) return std::nullopt;
    Joint unit;
    unit.kind = JointKind::Unit;
    unit.body = std::min(inner, outer);
    unit.others = {std::max(inner, outer)};
    std::size_t balls = 0;
    std::size_t rollers = 0;
    for (const RollingBody& one : rolling_) {
      if (!isBetween(one.element, in, out)) continue;
      unit.others.push_back(one.body);
      ++(one.element.isBall ? balls : rollers);
    }
    if (!evidence::areOfBearing(balls, rollers)) return std::nullopt;
    for (const std::size_t ring : rings_) {
      if (ring != inner && ring != outer && isCageOf(ringOf(ring), in, out)) unit.others.push_back(ring);
    }
    std::sort(unit.others.begin(), unit.others.end());
    unit.point = in.point;
    unit.direction = in.axis;
    const CatalogueText rings = balls > 0 ? GLISSADE_TEXT("two rings with %1 balls between them")
                                          : GLISSADE_TEXT("two rings with %1 rollers between them");
    unit.evidence.push_back({rings, {balls + rollers}});
    return unit;
  }

  const ProductShapes& shapes_;
  const StopToken& stop_;
  std::vector<std::size_t> rings_;
  std::vector<RollingBody> rolling_;
};

}  // namespace

Joints findRollingBearings(const ProductShapes& shapes, const StopToken& stop) {
  return RollingBearingFinder(shapes, stop).find();
}

}  // namespace glissade
