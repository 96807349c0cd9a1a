#include "engine/fits/rolling_bearings.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr double kSphereShare = 0.02;
constexpr std::size_t kFewestBalls = 3;
constexpr std::size_t kFewestRollers = 5;
/// Largest distance of the rings' middles along the axis, in lengths of the rings.
constexpr double kSameMiddle = 0.3;
constexpr double kSameAxisApart = 0.05;  ///< in radii
constexpr double kSlack = 1.01;

/// The centre of a ball; nothing if the body is no ball.
std::optional<Vector3> ballMiddle(const RigidBody& body) {
  const Box3 box = boundingBox(*body.mesh);
  const double radius = 0.5 * box.sizes().maxCoeff();
  if (box.sizes().minCoeff() < 2.0 * radius * (1.0 - kSphereShare)) return std::nullopt;
  for (const Vector3& vertex : body.mesh->vertices) {
    if (std::abs((vertex - box.center()).norm() - radius) > kSphereShare * radius) return std::nullopt;
  }
  return body.X_WB * box.center();
}

struct RollingElement {
  std::size_t body = 0;
  Vector3 middle = Vector3::Zero();
  bool isBall = false;
  double radius = 0.0;
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
    if (const auto middle = ballMiddle(shapes_.body(body))) {
      rolling_.push_back({body, *middle, true, 0.5 * shapes_.box(body).sizes().maxCoeff()});
      return;
    }
    const TurnedShape* shape = shapes_.turned(body);
    if (shape == nullptr) return;
    if (shape->kind == TurnedKind::Ring) rings_.push_back(body);
    if (shape->kind == TurnedKind::Rod) rolling_.push_back({body, middleOf(body), false, shape->shaft});
  }

  Vector3 middleOf(std::size_t body) const {
    const TurnedShape& shape = *shapes_.turned(body);
    const AxisLine axis = shapes_.axisOf(body);
    return axis.point + 0.5 * (shape.low + shape.high) * axis.direction;
  }

  /// True if the rings are coaxial, beside each other, and one is inside the other.
  bool areRaces(std::size_t inner, std::size_t outer) const {
    const TurnedShape& in = *shapes_.turned(inner);
    const TurnedShape& out = *shapes_.turned(outer);
    if (!(in.outer < out.outer && in.hole < out.hole)) return false;
    const AxisLine axis = shapes_.axisOf(inner);
    if (!isSameAxis(axis, shapes_.axisOf(outer), kSameAxisApart * out.outer)) return false;
    return std::abs(axis.heightOf(middleOf(outer)) - axis.heightOf(middleOf(inner))) < kSameMiddle * out.length();
  }

  std::optional<Joint> unitOf(std::size_t inner, std::size_t outer) const {
    if (!areRaces(inner, outer)) return std::nullopt;
    const AxisLine axis = shapes_.axisOf(inner);
    const TurnedShape& in = *shapes_.turned(inner);
    const TurnedShape& out = *shapes_.turned(outer);
    const double middle = axis.heightOf(middleOf(outer));
    Joint unit;
    unit.kind = JointKind::Unit;
    unit.body = std::min(inner, outer);
    unit.others = {std::max(inner, outer)};
    std::size_t balls = 0;
    std::size_t rollers = 0;
    for (const RollingElement& one : rolling_) {
      const double radius = axis.distanceOf(one.middle);
      const bool isBetween =
          radius > in.hole && radius < out.outer && std::abs(axis.heightOf(one.middle) - middle) < 0.5 * out.length();
      if (!isBetween) continue;
      unit.others.push_back(one.body);
      ++(one.isBall ? balls : rollers);
    }
    if (balls < kFewestBalls && rollers < kFewestRollers) return std::nullopt;
    for (const std::size_t ring : rings_) {
      if (ring != inner && ring != outer && isWithin(ring, axis, in, out, middle)) unit.others.push_back(ring);
    }
    std::sort(unit.others.begin(), unit.others.end());
    unit.point = axis.point;
    unit.direction = axis.direction;
    const CatalogueText rings = balls > 0 ? GLISSADE_TEXT("two rings with %1 balls between them")
                                          : GLISSADE_TEXT("two rings with %1 rollers between them");
    unit.evidence.push_back({rings, {balls + rollers}});
    return unit;
  }

  /// True for cages and shields between the rings.
  bool isWithin(std::size_t ring, const AxisLine& axis, const TurnedShape& in, const TurnedShape& out,
                double middle) const {
    const TurnedShape& shape = *shapes_.turned(ring);
    return shape.hole * kSlack >= in.hole && shape.outer <= kSlack * out.outer && shape.hole > 0.0 &&
           isSameAxis(axis, shapes_.axisOf(ring), kSameAxisApart * out.outer) && shape.outer < out.outer * kSlack &&
           shape.hole > in.hole && std::abs(axis.heightOf(middleOf(ring)) - middle) <= 0.5 * out.length() &&
           shape.length() <= kSlack * out.length();
  }

  const ProductShapes& shapes_;
  const StopToken& stop_;
  std::vector<std::size_t> rings_;
  std::vector<RollingElement> rolling_;
};

}  // namespace

Joints findRollingBearings(const ProductShapes& shapes, const StopToken& stop) {
  return RollingBearingFinder(shapes, stop).find();
}

}  // namespace glissade
