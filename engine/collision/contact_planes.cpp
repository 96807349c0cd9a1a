#include "engine/collision/contact_planes.h"

#include <algorithm>
#include <array>

namespace glissade {
namespace {

/// Contacts are one contact if the angle between their planes is smaller than this (cosine), and their points on the
/// object are nearer than this share of its radius. A face on a face has several contacts; with a single one the object
/// would tilt.
constexpr double kSamePlane = 0.995;
constexpr double kSamePoint = 0.1;
constexpr std::size_t kMostContacts = 8;
constexpr int kSweeps = 20;
/// Share of a missing gap that is restored in one step.
constexpr double kRecovery = 0.2;

}  // namespace

Pose moved(const Pose& q, const SmallMotion& motion) {
  return {q.position + motion.translation, (fromRotationVector(motion.rotation) * q.orientation).normalized()};
}

double longestWay(const Pose& a, const Pose& b, double radius) {
  return (a.position - b.position).norm() + radius * angleBetween(a.orientation, b.orientation);
}

void ContactPlanes::learn(const Pose& q, const NearestObstacle& nearest) {
  if (nearest.body < 0 || nearest.distance <= 0.0) return;
  const Contact contact{q, nearest.p_WPo, nearest.normal_W(), inverse(q) * nearest.p_WPn};
  const auto same = [&](const Contact& other) {
    return other.normal_W.dot(contact.normal_W) > kSamePlane &&
           (other.p_BPn - contact.p_BPn).norm() < kSamePoint * rule_.radius;
  };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), same), contacts_.end());
  if (contacts_.size() == kMostContacts) contacts_.erase(contacts_.begin());
  contacts_.push_back(contact);
}

void ContactPlanes::forgetFarFrom(const Pose& q) {
  const auto far = [&](const Contact& contact) { return longestWay(contact.learntAt, q, rule_.radius) > rule_.memory; };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), far), contacts_.end());
}

SmallMotion ContactPlanes::along(const Pose& q, const SmallMotion& requested) const {
  const double turning = rule_.turning.value_or(1.0);
  SmallMotion step{requested.translation, Vector3::Zero()};
  if (rule_.turning) step.rotation = turning * requested.rotation;
  std::array<double, kMostContacts> pushed{};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Contact& contact = contacts_[i];
      Vector3 lever = Vector3::Zero();
      if (rule_.turning) lever = (q.orientation * contact.p_BPn).cross(contact.normal_W) / turning;
      const double gap = contact.normal_W.dot(q * contact.p_BPn - contact.p_WPo);
      const double room = gap - rule_.gap;
      const double least = room < 0.0 ? -kRecovery * room : -room;
      const double lacking = least - contact.normal_W.dot(step.translation) - lever.dot(step.rotation);
      const double push = std::max(0.0, pushed[i] + lacking / (1.0 + lever.squaredNorm()));
      step.translation += (push - pushed[i]) * contact.normal_W;
      step.rotation += (push - pushed[i]) * lever;
      pushed[i] = push;
    }
  }
  step.rotation /= turning;
  return step;
}

}  // namespace glissade
