#include "engine/planning/automatic/contact_slide_sampler.h"

#include <algorithm>
#include <cmath>

#include "engine/planning/automatic/contact_faces.h"
#include "engine/planning/automatic/retraction.h"

namespace glissade {
namespace {

/// Surfaces farther than this are not gone up to, in radii of the object.
constexpr double kReach = 0.5;
constexpr double kLongestSlide = 2.0;
constexpr double kStride = 0.1;
constexpr int kBisections = 5;
constexpr std::size_t kSampledFaces = 12;
/// Two planes are two if their normals' cosine is below this.
constexpr double kSamePlane = 0.95;

}  // namespace

ContactSlideSampler::ContactSlideSampler(const Problem& problem, std::uint64_t seed, ErodedWorlds& worlds, double depth,
                                         double gap)
    : uniform_(problem, seed),
      stream_(seed, "contact slide"),
      bounds_(problem.bounds),
      radius_(problem.world->objectRadius()),
      depth_(depth),
      gap_(gap),
      query_(problem.world->makeQuery()),
      eroded_(worlds.at(depth)->makeQuery()),
      faces_B_(largestFaceNormals(problem.world->object(), kSampledFaces)) {}

Pose ContactSlideSampler::draw() {
  const Pose q = uniform_.draw();
  if (stream_.uniform() < 0.5) return q;
  auto contact = toSurface(q);
  if (!contact) return q;
  if (stream_.uniform() < 0.5) {
    const NearestObstacle nearest = query_->nearestObstacle(*contact);
    const Pose turned = aligned(*contact, nearest.normal_W());
    if (nearest.distance > 0.0) contact = toSurface(turned).value_or(*contact);
  }
  return stream_.uniform() < 0.5 ? slid(*contact) : *contact;
}

bool ContactSlideSampler::isFree(const Pose& q) { return bounds_.contains(q.position) && !query_->collides(q); }

std::optional<Pose> ContactSlideSampler::toSurface(const Pose& q) {
  const NearestObstacle nearest = query_->nearestObstacle(q);
  if (nearest.distance > kReach * radius_) return std::nullopt;
  std::optional<Pose> contact;
  if (nearest.distance > 0.0) {
    contact = q;
    contact->position -= (nearest.distance - gap_) * nearest.normal_W();
  } else {
    contact = retracted(*eroded_, q, depth_ + gap_, radius_);
  }
  return contact && isFree(*contact) ? contact : std::nullopt;
}

Pose ContactSlideSampler::aligned(const Pose& q, const Vector3& n_W) const {
  const Vector3 down_B = q.orientation.conjugate() * -n_W;
  const auto face = std::max_element(faces_B_.begin(), faces_B_.end(),
                                     [&](const Vector3& a, const Vector3& b) { return a.dot(down_B) < b.dot(down_B); });
  if (face == faces_B_.end()) return q;
  Pose result = q;
  result.orientation = (q.orientation * Quaternion::FromTwoVectors(*face, down_B)).normalized();
  return result;
}

Pose ContactSlideSampler::slid(const Pose& q) {
  const NearestObstacle first = query_->nearestObstacle(q);
  if (first.distance <= 0.0 || first.body < 0) return q;
  const Vector3 n1 = first.normal_W();
  const Pose onPlane = walked(q, tangentTo(n1), stream_.uniform(0.0, kLongestSlide * radius_));
  const Vector3 n2 = query_->nearestObstacle(onPlane).normal_W();
  if (n2.isZero(0.0) || std::abs(n1.dot(n2)) > kSamePlane) return onPlane;
  const double way = stream_.uniform(-kLongestSlide, kLongestSlide) * radius_;
  return walked(onPlane, (way < 0.0 ? -1.0 : 1.0) * n1.cross(n2).normalized(), std::abs(way));
}

/// As far as it is free, sampled: what is drawn need not be reachable on this way.
Pose ContactSlideSampler::walked(const Pose& from, const Vector3& direction, double length) {
  const auto at = [&](double s) { return Pose{from.position + s * direction, from.orientation}; };
  double free = 0.0;
  double blocked = length;
  while (free < length) {
    const double next = std::min(length, free + kStride * radius_);
    if (!isFree(at(next))) {
      blocked = next;
      break;
    }
    free = next;
  }
  for (int i = 0; i < kBisections && free < blocked && free < length; ++i) {
    const double middle = 0.5 * (free + blocked);
    (isFree(at(middle)) ? free : blocked) = middle;
  }
  return at(free);
}

Vector3 ContactSlideSampler::tangentTo(const Vector3& n_W) {
  const Vector3 any(stream_.normal(), stream_.normal(), stream_.normal());
  return (any - any.dot(n_W) * n_W).stableNormalized();
}

}  // namespace glissade
