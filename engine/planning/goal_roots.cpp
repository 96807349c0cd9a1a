#include "engine/planning/goal_roots.h"

#include <algorithm>

namespace glissade {
namespace {

/// The start moved along an axis until the object's ball is clear of the obstacles' box.
Pose movedOut(const Problem& problem, int axis, double sign) {
  const Box3& box = problem.world->obstaclesBox();
  const double margin = problem.world->objectRadius();
  Pose q = problem.start;
  q.position[axis] = sign > 0 ? std::max(q.position[axis], box.max()[axis] + margin)
                              : std::min(q.position[axis], box.min()[axis] - margin);
  return q;
}

}  // namespace

std::vector<Pose> goalRoots(const Problem& problem, CollisionQuery& query) {
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) return {*goal};
  if (problem.world->obstaclesBox().isEmpty()) return {problem.start};
  std::vector<Pose> roots;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Pose q = movedOut(problem, axis, sign);
      if (problem.bounds.contains(q.position) && !query.collides(q)) roots.push_back(q);
    }
  }
  const auto wayLength = [&](const Pose& q) { return (q.position - problem.start.position).norm(); };
  std::stable_sort(roots.begin(), roots.end(),
                   [&](const Pose& a, const Pose& b) { return wayLength(a) < wayLength(b); });
  return roots;
}

}  // namespace glissade
