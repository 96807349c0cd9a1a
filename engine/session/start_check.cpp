#include "engine/session/start_check.h"

#include <string>

#include "engine/base/number_text.h"
#include "engine/planning/goal_roots.h"

namespace glissade {
namespace {

/// Texts about the start or the goal.
struct EndTexts {
  CatalogueText name;
  CatalogueText isOutside;
  CatalogueText isForbidden;
  CatalogueText collides;
  CatalogueText isNear;
};

constexpr EndTexts kStart{GLISSADE_TEXT("start"), GLISSADE_TEXT("Enlarge the workspace or move the start inside."),
                          GLISSADE_TEXT("Allow the place again, or move the start out of it."),
                          GLISSADE_TEXT("Move the start to a position clear of all bodies."),
                          GLISSADE_TEXT("Move the start away or lower the required clearance.")};
constexpr EndTexts kGoal{GLISSADE_TEXT("goal"), GLISSADE_TEXT("Enlarge the workspace or move the goal inside."),
                         GLISSADE_TEXT("Allow the place again, or move the goal out of it."),
                         GLISSADE_TEXT("Move the goal to a position clear of all bodies."),
                         GLISSADE_TEXT("Move the goal away or lower the required clearance.")};

/// Describes the forbidden place that the reference point meets at a configuration, or at a milestone.
Message forbiddenAt(const Problem& problem, const Pose& q, bool isMilestone) {
  const ForbiddenRegionsPtr regions = problem.world->forbidden();
  const ForbiddenPlaces& places = regions->places();
  for (std::size_t place = 0; place < places.size(); ++place) {
    if (!regions->isInside(place, q.position)) continue;
    const std::string& name = places[place].name;
    if (isMilestone) return {GLISSADE_TEXT("the milestone is inside of '%1', which is forbidden"), {name}};
    return {GLISSADE_TEXT("the reference point is inside of '%1', which is forbidden"), {name}};
  }
  const std::string& name = places[*regions->holding(q.position)].name;
  if (isMilestone) {
    return {
        GLISSADE_TEXT("the milestone lies on the boundary of '%1', which is forbidden, or within the margin of %2 m"),
        {name, regions->margin()}};
  }
  return {GLISSADE_TEXT(
              "the reference point lies on the boundary of '%1', which is forbidden, or within the margin of %2 m"),
          {name, regions->margin()}};
}

Outcome checkConfiguration(const Problem& problem, CollisionQuery& query, const Pose& q, const EndTexts& end,
                           double requiredClearance) {
  const auto& obstacles = problem.world->obstacles();
  if (!isValid(q)) {
    return Diagnostic{ErrorKind::MalformedInput, "", end.name, GLISSADE_TEXT("is not a valid configuration"),
                      GLISSADE_TEXT("Give finite numbers and a unit quaternion.")};
  }
  if (!problem.bounds.contains(q.position)) {
    return Diagnostic{ErrorKind::MalformedInput, "", end.name, GLISSADE_TEXT("lies outside the workspace bounds"),
                      end.isOutside};
  }
  if (const auto body = query.collidingBody(q); body == kForbiddenPlace) {
    return Diagnostic{ErrorKind::NoPath, "", end.name, forbiddenAt(problem, q, false), end.isForbidden};
  } else if (body) {
    return Diagnostic{
        ErrorKind::InCollision,
        "",
        end.name,
        {GLISSADE_TEXT("the object penetrates '%1'"), {obstacles[static_cast<std::size_t>(*body)].shown()}},
        end.collides};
  }
  const NearestObstacle nearest = query.nearestObstacle(q);
  if (nearest.distance < requiredClearance) {
    return Diagnostic{ErrorKind::InCollision,
                      "",
                      end.name,
                      {GLISSADE_TEXT("the object is %1 m from '%2', nearer than the required clearance of %3 m"),
                       {shortText(nearest.distance), obstacles[static_cast<std::size_t>(nearest.body)].shown(),
                        shortText(requiredClearance)}},
                      end.isNear};
  }
  return Done{};
}

}  // namespace

Outcome checkMilestone(const Problem& problem, CollisionQuery& query, const Pose& q) {
  if (!problem.bounds.contains(q.position)) {
    return Diagnostic{ErrorKind::MalformedInput, "", "", GLISSADE_TEXT("the milestone lies outside the workspace"),
                      GLISSADE_TEXT("Put it inside, enlarge the workspace, or remove it.")};
  }
  const auto body = query.collidingBody(q);
  if (!body) return Done{};
  const Message reason = *body == kForbiddenPlace
                             ? forbiddenAt(problem, q, true)
                             : Message(GLISSADE_TEXT("the milestone is in collision with '%1'"),
                                       {problem.world->obstacles()[static_cast<std::size_t>(*body)].shown()});
  return Diagnostic{ErrorKind::NoPath, "", "", reason, GLISSADE_TEXT("Put it where the object is free, or remove it.")};
}

Outcome checkMilestones(const Problem& problem) {
  if (!problem.scene.edits || problem.scene.edits->milestones.empty()) return Done{};
  const auto query = problem.world->makeQuery();
  const auto& milestones = problem.scene.edits->milestones;
  for (std::size_t i = 0; i < milestones.size(); ++i) {
    const Outcome sound = checkMilestone(problem, *query, milestones[i].q);
    if (sound) continue;
    Diagnostic why = sound.error();
    why.location = "/milestones/" + std::to_string(i);
    return why;
  }
  return Done{};
}

Outcome checkStart(const Problem& problem, double requiredClearance) {
  if (problem.bounds.isEmpty()) {
    return Diagnostic{ErrorKind::MalformedInput, "", GLISSADE_TEXT("workspace"), GLISSADE_TEXT("is empty"),
                      GLISSADE_TEXT("Give a minimum below the maximum.")};
  }
  const auto query = problem.world->makeQuery();
  Outcome start = checkConfiguration(problem, *query, problem.start, kStart, requiredClearance);
  if (!start) return start;
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) {
    return checkConfiguration(problem, *query, *goal, kGoal, requiredClearance);
  }
  if (goalRoots(problem, *query).empty()) {
    return Diagnostic{
        ErrorKind::MalformedInput, "", kGoal.name,
        GLISSADE_TEXT(
            "the goal 'removed' cannot be reached: the workspace has no room outside the box around the obstacles"),
        GLISSADE_TEXT("Enlarge the workspace by the size of the object on one side at least.")};
  }
  return Done{};
}

}  // namespace glissade
