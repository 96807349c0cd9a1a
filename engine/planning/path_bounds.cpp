#include "engine/planning/path_bounds.h"

#include <algorithm>

namespace glissade {

std::optional<std::size_t> firstOutside(const std::vector<PathPoint>& points, const Problem& problem) {
  constexpr double kRounding = 1e-6;  // tolerance, in radii of the object
  Box3 bounds = problem.bounds;
  bounds.extend(problem.start.position);
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) bounds.extend(goal->position);
  const Vector3 margin = Vector3::Constant(kRounding * problem.world->objectRadius());
  const Box3 allowed(bounds.min() - margin, bounds.max() + margin);
  const auto outside = std::find_if(points.begin(), points.end(),
                                    [&](const PathPoint& point) { return !allowed.contains(point.q.position); });
  if (outside == points.end()) return std::nullopt;
  return static_cast<std::size_t>(outside - points.begin());
}

}  // namespace glissade
