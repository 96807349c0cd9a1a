#include "engine/sequence/direction_rule.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/geometry/convex_distance.h"
#include "engine/sequence/demanded_steps.h"

namespace glissade {
namespace {

/// Share of the body's size. A shorter displacement does not count as a motion.
constexpr double kStandsStill = 1e-6;

}  // namespace

DirectionRule::DirectionRule(const Pose& start, std::vector<DirectedBody> bodies) : start_(start) {
  for (DirectedBody& body : bodies) {
    Directed each;
    const Box3 box = boundingBox(*body.mesh);
    each.middle_G = body.X_GB * box.center();
    each.reach = 0.5 * box.diagonal().norm();
    for (const RigidBody& other : body.beside) each.boxes.push_back(boundingBox(*other.mesh, other.X_WB));
    each.body = std::move(body);
    bodies_.push_back(std::move(each));
  }
}

bool DirectionRule::mayBeAt(const Pose& X_WG) const {
  return std::none_of(bodies_.begin(), bodies_.end(),
                      [&](const Directed& each) { return wayIsForbidden(each, X_WG) && !isClear(each, X_WG); });
}

bool DirectionRule::mayMove(const Pose& from, const Pose& to) const {
  const double pieces =
      std::max(1.0, std::ceil(angleBetween(from.orientation, to.orientation) / tolerance::kMotionPiece));
  Pose begin = from;
  for (double piece = 1.0; piece <= pieces; piece += 1.0) {
    const Pose end = piece < pieces ? interpolate(from, to, piece / pieces) : to;
    for (const Directed& each : bodies_) {
      const bool wrong = isForbidden(each, end * each.middle_G - begin * each.middle_G) || wayIsForbidden(each, end);
      // A part that touches nothing does not begin in a forbidden direction either.
      if (wrong && (isAtStart(each, begin) || !isClear(each, begin))) return false;
    }
    begin = end;
  }
  return mayBeAt(to);
}

bool DirectionRule::isForbidden(const Directed& each, const Vector3& way) {
  return way.norm() > kStandsStill * each.reach && glissade::isForbidden(way, each.body.directions);
}

bool DirectionRule::isAtStart(const Directed& each, const Pose& X_WG) const {
  return (X_WG * each.middle_G - start_ * each.middle_G).norm() <= kStandsStill * each.reach;
}

bool DirectionRule::wayIsForbidden(const Directed& each, const Pose& X_WG) const {
  return isForbidden(each, X_WG * each.middle_G - start_ * each.middle_G);
}

bool DirectionRule::isClear(const Directed& each, const Pose& X_WG) {
  const Pose X_WB = X_WG * each.body.X_GB;
  const Vector3 middle = X_WG * each.middle_G;
  for (std::size_t i = 0; i < each.boxes.size(); ++i) {
    if (each.boxes[i].exteriorDistance(middle) > each.reach + each.body.apart) continue;
    const RigidBody& other = each.body.beside[i];
    if (!hullsApart(*each.body.mesh, X_WB, *other.mesh, other.X_WB, each.body.apart)) return false;
  }
  return true;
}

}  // namespace glissade
