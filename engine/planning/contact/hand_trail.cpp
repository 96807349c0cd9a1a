#include "engine/planning/contact/hand_trail.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

/// Distance from the last node at which a trail gets its next node, in radii of the object. It is more where the hand
/// moves farther at once.
constexpr double kPiece = 0.1;

}  // namespace

/// The arguments of follow(), for its parts.
struct HandTrail::Growth {
  const Box3& bounds;
  RoadmapGraph& roadmap;
  CollisionQuery& query;
  PlannerHost& host;

  const Pose& at(Node node) const { return roadmap.nodes()[node].q; }
  bool isProved(const Pose& from, const Pose& to) const {
    const double required = host.parameters()[ParameterId::RequiredClearance];
    return bounds.contains(to.position) &&
           query.checkMotion(from, to, required, SeekViolation::Any, host.stopToken()).status ==
               CertificateStatus::Certified;
  }
};

void HandTrail::follow(const OperatorSample& device, RoadmapGraph& roadmap, CollisionQuery& query, PlannerHost& host) {
  const Pose& q = device.q_device;
  if (seen_ == q) return;
  seen_ = q;
  hasMoved_ = hasMoved_ || q != problem_.start;
  if (!hasMoved_) return;
  Growth growth{problem_.bounds, roadmap, query, host};
  continues_ = (continues_ && goOn(q, growth)) || begin(q, growth);
}

/// Goes on by a straight motion from the last node, or from the pose of the hand after it.
bool HandTrail::goOn(const Pose& q, Growth& growth) {
  const Pose& from = growth.at(current_.end);
  const bool isShort = problem_.metric().distance(from, q) <= kPiece * problem_.world->objectRadius();
  if (isShort && growth.isProved(from, q)) {
    beyond_ = q;
    return true;
  }
  if (!beyond_) {
    if (isShort || !growth.isProved(from, q)) return false;
    add(q, growth);
    return true;
  }
  add(*std::exchange(beyond_, std::nullopt), growth);
  return goOn(q, growth);
}

/// Begins at q: at the nearest node of a tree from which the motion is proved, else with a tree of its own. No trail
/// begins where the object lacks the required clearance, or where it would repeat a node.
bool HandTrail::begin(const Pose& q, Growth& growth) {
  if (!growth.isProved(q, q)) return false;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto component : growth.roadmap.components()) {
    const auto near = growth.roadmap.nearest(component, q);
    nearest = std::min(nearest, near.distance);
    if (near.distance > 0.0 && !growth.isProved(growth.at(near.index), q)) continue;
    goTo(near.index, growth);
    if (near.distance > 0.0) add(q, growth);
    return true;
  }
  if (nearest < tolerance::kDuplicate * problem_.world->objectRadius()) return false;
  goTo(growth.roadmap.addRoot({q, Author::Operator, TreeSide::Hand}), growth);
  return true;
}

/// Goes on at a node. In the same tree the stretch is the same.
void HandTrail::goTo(Node node, Growth& growth) {
  if (longest_ && growth.roadmap.connected(node, current_.beginning)) {
    current_.end = node;
  } else {
    current_ = {node, node, 0.0};
  }
  if (!longest_) longest_ = current_;
}

void HandTrail::add(const Pose& q, Growth& growth) {
  RoadmapGraph& roadmap = growth.roadmap;
  current_.length += problem_.metric().distance(growth.at(current_.end), q);
  current_.end = roadmap.addChild(current_.end, {q, Author::Operator, roadmap.nodes()[current_.end].side});
  if (current_.length >= longest_->length) longest_ = current_;
  std::vector<Node> others;  // joining ends components, so that they are listed before
  for (const auto component : roadmap.components()) others.push_back(roadmap.nearest(component, q).index);
  for (const Node other : others) {
    if (!roadmap.connected(other, current_.end) && growth.isProved(growth.at(other), q)) {
      roadmap.join(other, current_.end);
    }
  }
}

}  // namespace glissade
