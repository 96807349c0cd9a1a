#include "engine/planning/contact/hand_trail.h"

#include <utility>
#include <vector>

namespace glissade {
namespace {

/// Longest straight piece of a trail, in radii of the object.
constexpr double kLongestPiece = 0.1;

}  // namespace

/// What one call of follow() works on.
struct HandTrail::Growth {
  RoadmapGraph& roadmap;
  CollisionQuery& query;
  PlannerHost& host;

  const Pose& at(Node node) const { return roadmap.nodes()[node].q; }
  bool isProved(const Pose& from, const Pose& to) const {
    const double required = host.parameters()[ParameterId::RequiredClearance];
    return query.checkMotion(from, to, required, SeekViolation::Any, host.stopToken()).status ==
           CertificateStatus::Certified;
  }
};

void HandTrail::follow(const OperatorSample& device, RoadmapGraph& roadmap, CollisionQuery& query, PlannerHost& host) {
  const Pose& q = device.q_device;
  if (seen_ == q) return;
  const bool isFirst = !seen_;
  seen_ = q;
  Growth growth{roadmap, query, host};
  if (isFirst && q == problem_.start) return;  // the hand has not moved
  if (!problem_.bounds.contains(q.position) || device.nearest.distance <= 0.0) {
    if (beyond_) add(*std::exchange(beyond_, std::nullopt), growth);
    continues_ = false;
  } else if (!continues_ || !goOn(q, growth)) {
    begin(q, growth);
  }
}

/// Goes on by a straight motion from the last node, or from the pose of the hand after it.
bool HandTrail::goOn(const Pose& q, Growth& growth) {
  const Pose& from = growth.at(*end_);
  const bool isShort = problem_.metric().distance(from, q) <= kLongestPiece * problem_.world->objectRadius();
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

/// Begins a trail at q: at a tree, where the motion from its nearest node is proved, else on its own.
void HandTrail::begin(const Pose& q, Growth& growth) {
  continues_ = true;
  beyond_.reset();
  for (const auto component : growth.roadmap.components()) {
    const auto near = growth.roadmap.nearest(component, q);
    if (near.distance > 0.0 && !growth.isProved(growth.at(near.index), q)) continue;
    end_ = beginning_ = near.index;
    if (near.distance > 0.0) add(q, growth);
    return;
  }
  end_ = beginning_ = growth.roadmap.addRoot({q, Author::Operator, TreeSide::Hand});
}

void HandTrail::add(const Pose& q, Growth& growth) {
  RoadmapGraph& roadmap = growth.roadmap;
  end_ = roadmap.addChild(*end_, {q, Author::Operator, roadmap.nodes()[*end_].side});
  std::vector<Node> others;  // joining ends components, so that they are listed before
  for (const auto component : roadmap.components()) others.push_back(roadmap.nearest(component, q).index);
  const double step = growth.host.parameters()[ParameterId::GrowthStep];
  for (const Node other : others) {
    if (roadmap.connected(other, *end_)) continue;
    if (freeFraction(growth.query, growth.at(other), q, step, growth.host.stopToken()) >= 1.0) {
      roadmap.join(other, *end_);
    }
  }
}

}  // namespace glissade
