#include "engine/session/start_check.h"

#include "engine/base/number_text.h"
#include "engine/planning/goal_roots.h"

namespace glissade {
namespace {

/// Describes the forbidden place that the reference point meets at a configuration, or at a milestone.
std::string forbiddenAt(const Problem& problem, const Pose& q, bool isMilestone) {
  const ForbiddenRegionsPtr regions = problem.world->forbidden();
  const ForbiddenPlaces& places = regions->places();
  for (std::size_t place = 0; place < places.size(); ++place) {
    if (!regions->isInside(place, q.position)) continue;
    const std::string& name = places[place].name;
    if (isMilestone) return "the milestone is inside of '" + name + "', which is forbidden";
    return "the reference point is inside of '" + name + "', which is forbidden";
  }
  const std::string& name = places[*regions->holding(q.position)].name;
  const std::string margin = toText(regions->margin());
  if (isMilestone) {
    return "the milestone lies on the boundary of '" + name + "', which is forbidden, or within the margin of " +
           margin + " m";
  }
  return "the reference point lies on the boundary of '" + name + "', which is forbidden, or within the margin of " +
         margin + " m";
}

Outcome checkConfiguration(const Problem& problem, CollisionQuery& query, const Pose& q, const std::string& which,
                           double requiredClearance) {
  const auto& obstacles = problem.world->obstacles();
  if (!isValid(q)) {
    return Diagnostic{ErrorKind::MalformedInput, "", which, "is not a valid configuration",
                      "Give finite numbers and a unit quaternion."};
  }
  if (!problem.bounds.contains(q.position)) {
    return Diagnostic{ErrorKind::MalformedInput, "", which, "lies outside the workspace bounds",
                      "Enlarge the workspace or move the " + which + " inside."};
  }
  if (const auto body = query.collidingBody(q); body == kForbiddenPlace) {
    return Diagnostic{ErrorKind::NoPath, "", which, forbiddenAt(problem, q, false),
                      "Allow the place again, or move the " + which + " out of it."};
  } else if (body) {
    return Diagnostic{ErrorKind::InCollision, "", which,
                      "the object penetrates '" + obstacles[static_cast<std::size_t>(*body)].shown() + "'",
                      "Move the " + which + " to a position clear of all bodies."};
  }
  const NearestObstacle nearest = query.nearestObstacle(q);
  if (nearest.distance < requiredClearance) {
    std::ostringstream reason;
    reason << "the object is " << nearest.distance << " m from '"
           << obstacles[static_cast<std::size_t>(nearest.body)].shown() << "', nearer than the required clearance of "
           << requiredClearance << " m";
    return Diagnostic{ErrorKind::InCollision, "", which, reason.str(),
                      "Move the " + which + " away or lower the required clearance."};
  }
  return Done{};
}

}  // namespace

Outcome checkMilestones(const Problem& problem) {
  if (!problem.scene.edits || problem.scene.edits->milestones.empty()) return Done{};
  const auto query = problem.world->makeQuery();
  const auto& milestones = problem.scene.edits->milestones;
  for (std::size_t i = 0; i < milestones.size(); ++i) {
    const auto body = query->collidingBody(milestones[i].q);
    if (!body) continue;
    const std::string reason = *body == kForbiddenPlace
                                   ? forbiddenAt(problem, milestones[i].q, true)
                                   : "the milestone is in collision with '" +
                                         problem.world->obstacles()[static_cast<std::size_t>(*body)].shown() + "'";
    return Diagnostic{ErrorKind::NoPath, "", "/milestones/" + std::to_string(i), reason,
                      "Put it where the object is free, or remove it."};
  }
  return Done{};
}

Outcome checkStart(const Problem& problem, double requiredClearance) {
  if (problem.bounds.isEmpty()) {
    return Diagnostic{ErrorKind::MalformedInput, "", "workspace", "is empty", "Give a minimum below the maximum."};
  }
  const auto query = problem.world->makeQuery();
  Outcome start = checkConfiguration(problem, *query, problem.start, "start", requiredClearance);
  if (!start) return start;
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) {
    return checkConfiguration(problem, *query, *goal, "goal", requiredClearance);
  }
  if (goalRoots(problem, *query).empty()) {
    return Diagnostic{
        ErrorKind::MalformedInput, "", "goal",
        "the goal 'out' cannot be reached: the workspace has no room outside the box around the obstacles",
        "Enlarge the workspace by the size of the object on one side at least."};
  }
  return Done{};
}

}  // namespace glissade
