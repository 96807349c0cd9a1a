#include "engine/planning/interactive/shown_configuration.h"

#include <array>

#include "engine/planning/automatic/retraction.h"
#include "engine/planning/automatic/tube_sampler.h"

namespace glissade {
namespace {

/// Depths of erosion, in radii of the object. The smallest comes first, because it moves edges least.
constexpr std::array<double, 3> kDepths{0.02, 0.06, 0.14};
/// Clearances that the eroded object has to keep, in depths. Its edges have moved by more than its faces.
constexpr std::array<double, 2> kDemands{1.05, 1.6};
/// Standard deviation of the random move in the last attempt, for each direction, in radii of the object.
constexpr double kAround = 0.15;

}  // namespace

ShownConfiguration::ShownConfiguration(const Problem& problem, std::shared_ptr<ErodedWorlds> worlds, std::uint64_t seed,
                                       int attempts)
    : world_(problem.world),
      bounds_(problem.bounds),
      metric_(problem.metric()),
      worlds_(std::move(worlds)),
      stream_(seed, "shown configuration"),
      attempts_(attempts),
      query_(problem.world->makeQuery()),
      eroded_(kDepths.size()) {}

std::optional<ShownConfiguration::ClearConfiguration> ShownConfiguration::clearConfiguration(const Pose& q,
                                                                                             double clearance) {
  const auto found = clearPose(q, clearance);
  if (!found) return std::nullopt;
  return ClearConfiguration{*found, query_->nearestObstacle(*found), metric_.distance(q, *found)};
}

std::optional<Pose> ShownConfiguration::clearPose(const Pose& q, double clearance) {
  if (!query_->collides(q)) return q;
  auto found = retractedFrom(q, q, clearance);
  for (int attempt = 1; !found && attempt <= attempts_; ++attempt) {
    const double deviation = kAround * metric_.radius() * attempt / attempts_;
    found = retractedFrom(perturbed(q, deviation, metric_.radius(), bounds_, stream_), q, clearance);
  }
  return found;
}

std::optional<Pose> ShownConfiguration::retractedFrom(const Pose& q, const Pose& shown, double clearance) {
  const double radius = metric_.radius();
  const auto holds = [&](const std::optional<Pose>& found) {
    return found && metric_.distance(shown, *found) <= kMostMoved * radius && bounds_.contains(found->position) &&
           !query_->collides(*found);
  };
  for (std::size_t i = 0; i < kDepths.size(); ++i) {
    const double depth = kDepths[i] * radius;
    if (!eroded_[i]) eroded_[i] = worlds_->at(depth)->makeQuery();
    if (eroded_[i]->nearestObstacle(q).distance <= 0.0) continue;  // q is deeper than this erosion
    for (const double demand : kDemands) {
      const auto found = retracted(*eroded_[i], q, demand * depth + clearance, radius);
      if (!holds(found)) continue;
      const auto touching = retracted(*query_, *found, clearance, radius);
      return holds(touching) ? touching : found;
    }
  }
  return std::nullopt;
}

QueryCounts ShownConfiguration::counts() const {
  QueryCounts sum = query_->counts();
  for (const auto& query : eroded_) {
    if (query) sum += query->counts();
  }
  return sum;
}

}  // namespace glissade
