#include "engine/sequence/demand_conflicts.h"

#include <algorithm>

#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

template <class Each>
bool has(const std::vector<Each>& list, const Each& each) {
  return std::find(list.begin(), list.end(), each) != list.end();
}

template <class Each>
std::vector<Each> onlyIn(const std::vector<Each>& after, const std::vector<Each>& before) {
  std::vector<Each> fresh;
  std::copy_if(after.begin(), after.end(), std::back_inserter(fresh),
               [&](const Each& each) { return !has(before, each); });
  return fresh;
}

template <class Each>
std::vector<Each> inBoth(const std::vector<Each>& after, const std::vector<Each>& before) {
  std::vector<Each> both;
  std::copy_if(after.begin(), after.end(), std::back_inserter(both),
               [&](const Each& each) { return has(before, each); });
  return both;
}

template <class Each>
void remove(const std::vector<Each>& these, std::vector<Each>& from) {
  std::erase_if(from, [&](const Each& each) { return has(these, each); });
}

}  // namespace

bool excludes(const ForbiddenDirection& direction, const DemandedMotion& motion) {
  return has(motion.bodies, direction.body) &&
         isForbidden(firstDirection(motion.path), {direction.direction.normalized()});
}

DemandConflict conflictBetween(const SequenceDemands& before, const SequenceDemands& after) {
  DemandConflict conflict;
  const auto freshWays = onlyIn(after.forbidden, before.forbidden);
  for (const DemandedMotion& motion : inBoth(after.motions, before.motions)) {
    const bool excluded = std::any_of(freshWays.begin(), freshWays.end(),
                                      [&](const ForbiddenDirection& each) { return excludes(each, motion); });
    if (excluded) conflict.motions.push_back(motion);
  }
  const auto freshMotions = onlyIn(after.motions, before.motions);
  for (const ForbiddenDirection& direction : inBoth(after.forbidden, before.forbidden)) {
    const bool excluded = std::any_of(freshMotions.begin(), freshMotions.end(),
                                      [&](const DemandedMotion& each) { return excludes(direction, each); });
    if (excluded) conflict.forbidden.push_back(direction);
  }
  const auto freshOrder = onlyIn(after.before, before.before);
  for (const auto& [first, then] : inBoth(after.before, before.before)) {
    if (has(freshOrder, std::pair(then, first))) conflict.before.emplace_back(first, then);
  }
  return conflict;
}

SequenceDemands withoutEarlier(const DemandConflict& conflict, SequenceDemands demands) {
  remove(conflict.motions, demands.motions);
  remove(conflict.forbidden, demands.forbidden);
  remove(conflict.before, demands.before);
  return demands;
}

Diagnostic inWords(const DemandConflict& conflict) {
  std::vector<Message> reasons;
  for (const DemandedMotion& each : conflict.motions) {
    reasons.push_back(
        {GLISSADE_TEXT("the locked motion of '%1' uses the direction that is to be ruled out"), {each.bodies.front()}});
  }
  for (const ForbiddenDirection& each : conflict.forbidden) {
    reasons.push_back({GLISSADE_TEXT("this motion uses a direction you ruled out for '%1'"), {each.body}});
  }
  for (const auto& [first, then] : conflict.before) {
    reasons.push_back({GLISSADE_TEXT("'%1' is to be removed before '%2'"), {first, then}});
  }
  return {ErrorKind::Usage, "", "", joined(reasons, "; "),
          GLISSADE_TEXT("Remove the earlier constraint, or omit the new one.")};
}

}  // namespace glissade
