#include "engine/planning/interactive/way_sampler.h"

#include <algorithm>

#include "engine/planning/automatic/tube_sampler.h"

namespace glissade {
namespace {

/// Radius of the disc on a tangent plane, in deviations of the tube.
constexpr double kDisc = 4.0;
/// Share of the draws that lie ahead of the hand.
constexpr double kAheadShare = 0.1;
/// Share of a member's nodes at which the sampler looks for contact.
constexpr double kLookedAt = 0.02;

}  // namespace

WaySampler::WaySampler(const Problem& problem, std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
                       std::shared_ptr<const WayBoard> board, bool slides)
    : own_(std::move(own)),
      stream_(seed, "hand's way"),
      contactSampler_(seed),
      ownContact_(seed),
      board_(std::move(board)),
      bounds_(problem.bounds),
      radius_(problem.world->objectRadius()),
      slides_(slides) {}

Pose WaySampler::draw(const Box3& tree) {
  const ShownWay* way = board_->current().get();
  author_ = Author::Computer;
  const double share = way == nullptr || way->points.empty() ? 0.0 : way->shareOf(slides_);
  if (share <= 0.0 || stream_.uniform() >= share) return own_->draw(tree);
  if (ownContactSamplesLeft_ > 0) {
    --ownContactSamplesLeft_;
    return inside(ownContact_.sample());
  }
  author_ = Author::Operator;
  return way->push && stream_.uniform() < kAheadShare ? ahead(*way) : fromTube(*way);
}

void WaySampler::grew(const Pose& q, CollisionQuery& query) {
  const ShownWay* way = board_->current().get();
  if (way == nullptr || way->shareOf(slides_) <= 0.0 || ownContactSamplesLeft_ > 0 || stream_.uniform() >= kLookedAt)
    return;
  OperatorSample node;
  node.q_device = q;
  node.nearest = query.nearestObstacle(q);
  if (node.nearest.distance <= 0.0 || node.nearest.distance >= way->contact.distance) return;
  ownContact_.enter(node, way->contact.gap, kDisc * way->spread);
  ownContactSamplesLeft_ = way->contact.samples;
}

Pose WaySampler::ahead(const ShownWay& way) {
  const Pose q = way.push->motion.at(1.0 + stream_.uniform() * (way.push->end - 1.0));
  return perturbed(q, way.spread * stream_.uniform(), radius_, bounds_, stream_);
}

Pose WaySampler::inside(Pose q) const {
  q.position = q.position.cwiseMax(bounds_.min()).cwiseMin(bounds_.max());
  return q;
}

Pose WaySampler::fromTube(const ShownWay& way) {
  const auto index = static_cast<std::size_t>(stream_.uniform() * static_cast<double>(way.points.size()));
  const ShownWay::Point& point = way.points[std::min(index, way.points.size() - 1)];
  const ShownWay::ContactRule& contact = way.contact;
  const bool near = point.nearest.distance > 0.0 && point.nearest.distance < contact.distance;
  if (near && stream_.uniform() * (contact.samples + 1) < contact.samples) {
    OperatorSample touching;
    touching.q_device = point.q;
    touching.nearest = point.nearest;
    author_ = Author::Contact;
    contactSampler_.enter(touching, contact.gap, kDisc * way.spread);
    return inside(contactSampler_.sample());
  }
  Pose q = point.q;
  if (point.follows && index > 0) q = interpolate(way.points[index - 1].q, q, stream_.uniform());
  return perturbed(q, way.spread * stream_.uniform(), radius_, bounds_, stream_);
}

}  // namespace glissade
