#include "engine/planning/path_spacing.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Metric length of the steps between two drawn poses.
double stepOf(double length, const PathSpacing& spacing) {
  const double least = length / (kMostPathPoses + 1);
  if (spacing.by == PathSpacing::By::Distance) return std::max(least, spacing.distance);
  return std::max(least, length / (std::max(0, spacing.number) + 1));
}

}  // namespace

std::vector<Pose> posesAlong(const std::vector<Pose>& way, const Se3Metric& metric, const PathSpacing& spacing) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += metric.distance(way[i - 1], way[i]);
  if (spacing.by == PathSpacing::By::None || !(length > 0.0)) return {};
  const double step = stepOf(length, spacing);
  // A pose nearer to the end than this would coincide with the goal.
  const double end = length - 1e-6 * step;
  std::vector<Pose> poses;
  double passed = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double edge = metric.distance(way[i - 1], way[i]);
    for (double at = step * static_cast<double>(poses.size() + 1); at < end && at <= passed + edge;
         at = step * static_cast<double>(poses.size() + 1)) {
      poses.push_back(interpolate(way[i - 1], way[i], edge > 0.0 ? (at - passed) / edge : 1.0));
    }
    passed += edge;
  }
  return poses;
}

}  // namespace glissade
