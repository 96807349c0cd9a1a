#include "engine/planning/clearance_profile.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// The sampled places on a way: configurations and even steps between them.
struct Places {
  std::vector<Pose> poses;
  std::vector<double> arrivals;  ///< metric length before each place
};

Places placesOn(const std::vector<Pose>& way, const Se3Metric& metric, std::size_t count) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += metric.distance(way[i - 1], way[i]);
  const double step = length / static_cast<double>(std::max<std::size_t>(count, 1));
  Places places;
  double before = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 0) {
      const double edge = metric.distance(way[i - 1], way[i]);
      const auto steps = step > 0.0 ? static_cast<std::size_t>(std::ceil(edge / step)) : std::size_t{1};
      for (std::size_t k = 1; k < steps; ++k) {
        const double at = static_cast<double>(k) / static_cast<double>(steps);
        places.poses.push_back(interpolate(way[i - 1], way[i], at));
        places.arrivals.push_back(before + at * edge);
      }
      before += edge;
    }
    places.poses.push_back(way[i]);
    places.arrivals.push_back(before);
  }
  return places;
}

}  // namespace

std::optional<std::size_t> ClearanceProfile::tightest() const {
  if (samples.empty()) return std::nullopt;
  const auto least = std::min_element(
      samples.begin(), samples.end(),
      [](const ClearanceSample& a, const ClearanceSample& b) { return a.nearest.distance < b.nearest.distance; });
  return static_cast<std::size_t>(least - samples.begin());
}

ClearanceProfile clearanceProfile(CollisionQuery& query, const std::vector<Pose>& way, const Se3Metric& metric,
                                  std::size_t count, const WorkWatch& watch) {
  const Places places = placesOn(way, metric, count);
  const double length = places.arrivals.empty() ? 0.0 : places.arrivals.back();
  ClearanceProfile profile;
  for (std::size_t i = 0; i < places.poses.size(); ++i) {
    if (watch.stop.stopRequested()) {
      profile.complete = false;
      break;
    }
    const double share = length > 0.0 ? places.arrivals[i] / length : 0.0;
    profile.samples.push_back({share, places.poses[i], query.nearestObstacle(places.poses[i])});
    watch.report(static_cast<double>(i + 1) / static_cast<double>(places.poses.size()));
  }
  return profile;
}

}  // namespace glissade
