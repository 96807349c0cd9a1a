#include "engine/planning/interactive/way_sampler.h"

#include <algorithm>

#include "engine/planning/automatic/tube_sampler.h"

namespace glissade {
namespace {

/// Radius of the disc on a tangent plane, in deviations of the tube.
constexpr double kDisc = 4.0;

}  // namespace

WaySampler::WaySampler(const Problem& problem, std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed,
                       std::shared_ptr<const WayBoard> board, double leastShare)
    : own_(std::move(own)),
      stream_(seed, "hand's way"),
      contactSampler_(seed),
      board_(std::move(board)),
      bounds_(problem.bounds),
      radius_(problem.world->objectRadius()),
      leastShare_(leastShare) {}

Pose WaySampler::draw() {
  const ShownWay* way = board_->current().get();
  const double share = way == nullptr || way->points.empty() ? 0.0 : std::max(way->share, leastShare_);
  if (share <= 0.0 || stream_.uniform() >= share) return own_->draw();
  return fromTube(*way);
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
    contactSampler_.enter(touching, contact.gap, kDisc * way.spread);
    Pose q = contactSampler_.sample();
    q.position = q.position.cwiseMax(bounds_.min()).cwiseMin(bounds_.max());
    return q;
  }
  Pose q = point.q;
  if (point.follows && index > 0) q = interpolate(way.points[index - 1].q, q, stream_.uniform());
  return perturbed(q, way.spread * stream_.uniform(), radius_, bounds_, stream_);
}

}  // namespace glissade
