#include "engine/files/end_conflicts.h"

#include <algorithm>

#include "engine/files/scenario_fits.h"
#include "engine/fits/contact_report.h"
#include "engine/geometry/intersection_curve.h"

namespace glissade {
namespace {

/// Most segments of a curve. More would not be readable in the window.
constexpr std::size_t kMostCutSegments = 20'000;

bool isAllowed(const LoadedScenario& scenario, std::size_t obstacle) {
  const auto& allowed = scenario.fits.allowed;
  return std::any_of(allowed.begin(), allowed.end(), [&](const Fit& fit) { return fit.obstacle == obstacle; });
}

EndConflict conflictOf(const Contact& contact, std::size_t obstacle) {
  EndConflict conflict;
  conflict.obstacle = obstacle;
  conflict.distance = contact.gap;
  if (contact.overlap > 0.0) conflict.overlap = contact.overlap;
  return conflict;
}

/// Conflicts of the whole object, measured on its mesh.
std::vector<EndConflict> measuredConflicts(const LoadedScenario& scenario, const Pose& q, double required,
                                           const StopToken& stop) {
  std::vector<ContactBody> bodies = contactBodiesOf(objectAndOthers(scenario));
  const std::size_t object = bodies.size() - 1;
  bodies[object].X_WB = q;
  ContactLimits limits;
  limits.clearanceUpTo = required;
  limits.only = object;
  std::vector<EndConflict> conflicts;
  for (const Contact& contact : findContacts(bodies, limits, stop).contacts) {
    if (contact.gap < required && !isAllowed(scenario, contact.a)) conflicts.push_back(conflictOf(contact, contact.a));
  }
  return conflicts;
}

/// Adds the obstacle that the planner itself reports. It may differ, because the planner's object may be thinned
/// against an obstacle that it fits. Removes all conflicts where the planner reports none.
void addJudged(const LoadedScenario& scenario, const Pose& q, double required, std::vector<EndConflict>& conflicts) {
  const auto query = scenario.problem.world->makeQuery();
  EndConflict judged;
  if (const auto body = query->collidingBody(q)) {
    judged.obstacle = static_cast<std::size_t>(*body);
  } else {
    const NearestObstacle nearest = query->nearestObstacle(q);
    if (nearest.body < 0 || nearest.distance >= required) {
      conflicts.clear();
      return;
    }
    judged.obstacle = static_cast<std::size_t>(nearest.body);
    judged.distance = nearest.distance;
  }
  const bool known = std::any_of(conflicts.begin(), conflicts.end(),
                                 [&](const EndConflict& other) { return other.obstacle == judged.obstacle; });
  if (!known) conflicts.push_back(judged);
}

std::optional<EndConflicts> conflictsAt(const LoadedScenario& scenario, const Pose& q, bool atStart, double required,
                                        const StopToken& stop) {
  EndConflicts found{atStart, q, measuredConflicts(scenario, q, required, stop)};
  addJudged(scenario, q, required, found.conflicts);
  if (found.conflicts.empty()) return std::nullopt;
  std::stable_sort(found.conflicts.begin(), found.conflicts.end(), [](const EndConflict& a, const EndConflict& b) {
    return a.overlap.value_or(-a.distance) > b.overlap.value_or(-b.distance);
  });
  for (EndConflict& conflict : found.conflicts) {
    const RigidBody& body = scenario.obstacles[conflict.obstacle];
    conflict.cut = intersectionCurve(*scenario.object.mesh, q, *body.mesh, body.X_WB, kMostCutSegments);
  }
  return found;
}

}  // namespace

std::optional<EndConflicts> findEndConflicts(const LoadedScenario& scenario, double required, const StopToken& stop) {
  if (auto start = conflictsAt(scenario, scenario.problem.start, true, required, stop)) return start;
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  return goal != nullptr ? conflictsAt(scenario, *goal, false, required, stop) : std::nullopt;
}

}  // namespace glissade
