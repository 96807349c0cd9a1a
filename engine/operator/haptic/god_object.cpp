#include "engine/operator/haptic/god_object.h"

#include <algorithm>
#include <array>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

/// The gap kept at contact is that of contact samples; half of it is for moving on in.
constexpr double kKept = 0.5;
/// Contacts learnt farther away than this, times the object's radius, say nothing here any more.
constexpr double kContactMemory = 0.03;
/// Contacts are one with a smaller angle than this between their planes (cosine), at points of the object
/// nearer than this, times its radius. A face on a face has several: with one, it would tip over.
constexpr double kSamePlane = 0.995;
constexpr double kSamePoint = 0.1;
constexpr std::size_t kMostContacts = 8;
constexpr int kSweeps = 20;
/// Longest step along contacts, in gaps: the sweeps leave a small share of it, which must be small against
/// the gap.
constexpr double kLongestStep = 20.0;
/// Share of a missing gap that is given back in one step.
constexpr double kRecovery = 0.2;

}  // namespace

GodObject::GodObject(double objectRadius) : radius_(objectRadius) {}

void GodObject::place(const Pose& q) {
  q_ = q;
  known_ = false;
  contacts_.clear();
}

void GodObject::learn(const Surroundings& surroundings) {
  if (known_ ? surroundings.q == surroundings_.q : surroundings.q != q_) return;
  surroundings_ = surroundings;
  known_ = true;
  const NearestObstacle& nearest = surroundings.nearest;
  if (nearest.body < 0 || nearest.distance <= 0.0) return;
  const Contact contact{surroundings.q, nearest.p_WPo, nearest.normal_W(), inverse(surroundings.q) * nearest.p_WPn};
  const auto same = [&](const Contact& other) {
    return other.normal_W.dot(contact.normal_W) > kSamePlane &&
           (other.p_BPn - contact.p_BPn).norm() < kSamePoint * radius_;
  };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), same), contacts_.end());
  if (contacts_.size() == kMostContacts) contacts_.erase(contacts_.begin());
  contacts_.push_back(contact);
}

/// No point of the object moves farther between a and b.
double GodObject::reach(const Pose& a, const Pose& b) const {
  return (a.position - b.position).norm() + radius_ * angleBetween(a.orientation, b.orientation);
}

double GodObject::gap(const Contact& contact) const { return contact.normal_W.dot(q_ * contact.p_BPn - contact.p_WPo); }

void GodObject::forgetFarContacts() {
  const auto far = [&](const Contact& contact) { return reach(contact.learntAt, q_) > kContactMemory * radius_; };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), far), contacts_.end());
}

/// The nearest step to the requested one that keeps the gap at every contact: projected Gauss-Seidel.
GodObject::Step GodObject::alongContacts(const Step& requested) const {
  Step step = requested;
  std::array<double, kMostContacts> pushed{};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Contact& contact = contacts_[i];
      const Vector3 lever = (q_.orientation * contact.p_BPn).cross(contact.normal_W) / radius_;
      const double room = gap(contact) - tolerance::kContactGap * radius_;
      const double least = room < 0.0 ? -kRecovery * room : -room;
      const double lacking = least - contact.normal_W.dot(step.translation) - lever.dot(step.rotation);
      const double push = std::max(0.0, pushed[i] + lacking / (1.0 + lever.squaredNorm()));
      step.translation += (push - pushed[i]) * contact.normal_W;
      step.rotation += (push - pushed[i]) * lever;
      pushed[i] = push;
    }
  }
  return step;
}

GodObject::Step GodObject::stepTo(const Pose& X_WD) const {
  const double longest = kLongestStep * tolerance::kContactGap * radius_;
  const double share = std::min(1.0, longest / std::max(longest, reach(q_, X_WD)));
  return {share * (X_WD.position - q_.position), share * radius_ * rotationVector(q_.orientation, X_WD.orientation)};
}

Pose GodObject::moved(const Step& step) const {
  return {q_.position + step.translation, (fromRotationVector(step.rotation / radius_) * q_.orientation).normalized()};
}

const Pose& GodObject::follow(const Pose& X_WD) {
  if (!known_) return q_;
  if (surroundings_.clearance <= 0.0) return q_ = X_WD;
  forgetFarContacts();
  const Pose target = contacts_.empty() ? X_WD : moved(alongContacts(stepTo(X_WD)));
  // The ball is convex: with both its ends in it, a straight motion is free.
  const double clearance = surroundings_.clearance;
  const double ball = clearance - kKept * std::min(tolerance::kContactGap * radius_, clearance);
  const double left = ball - reach(surroundings_.q, q_);
  const double length = reach(q_, target);
  if (length <= 0.0 || left <= 0.0) return q_;
  return q_ = length <= left ? target : interpolate(q_, target, left / length);
}

NearestObstacle GodObject::nearest() const {
  NearestObstacle moved = surroundings_.nearest;
  if (!known_ || moved.body < 0 || moved.distance <= 0.0) return moved;
  const Vector3 normal_W = moved.normal_W();
  const Vector3 p_WPn = q_ * (inverse(surroundings_.q) * moved.p_WPn);
  moved.distance = std::max(normal_W.dot(p_WPn - moved.p_WPo), kKept * tolerance::kContactGap * radius_);
  moved.p_WPn = p_WPn;
  moved.p_WPo = p_WPn - moved.distance * normal_W;
  return moved;
}

}  // namespace glissade
