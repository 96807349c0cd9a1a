#include "engine/sequence/demand_edits.h"

#include <algorithm>

#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

using BodyNames = std::vector<std::string>;

bool isOneOf(const std::string& name, const BodyNames& bodies) {
  return std::find(bodies.begin(), bodies.end(), name) != bodies.end();
}

bool areAmong(const BodyNames& names, const BodyNames& bodies) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) { return isOneOf(name, bodies); });
}

bool hasOneOf(const BodyNames& bodies, const BodyNames& others) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const std::string& name) { return isOneOf(name, others); });
}

void dropMotion(const BodyNames& bodies, SequenceDemands& demands) {
  std::erase_if(demands.motions, [&](const DemandedMotion& each) { return hasOneOf(each.bodies, bodies); });
}

/// Moves a step that is demanded at this place to the next free place.
void makeRoomAt(std::size_t place, std::vector<DemandedPlace>& places) {
  const auto at = [&](std::size_t number) {
    return std::find_if(places.begin(), places.end(), [&](const DemandedPlace& each) { return each.place == number; });
  };
  const auto there = at(place);
  if (there == places.end()) return;
  std::size_t next = place + 1;
  while (at(next) != places.end()) ++next;
  there->place = next;
}

/// The bodies of each step for which its place is demanded.
std::vector<BodyNames> placedBodies(const AssemblyPlan& plan) {
  std::vector<BodyNames> steps;
  for (const AssemblyStep& step : plan.steps) steps.push_back(textsOf(step.motions.front().bodies()));
  return steps;
}

}  // namespace

SequenceDemands withStepMoved(std::size_t from, std::size_t to, const AssemblyPlan& plan, SequenceDemands demands) {
  demands.places = movedTo(to, from, placedBodies(plan), demands.places);
  return demands;
}

std::vector<std::size_t> orderWithStepMoved(std::size_t from, std::size_t to, const AssemblyPlan& plan,
                                            const SequenceDemands& demands) {
  return movedOrder(to, from, lockedSteps(placedBodies(plan), demands.places));
}

SequenceDemands withStepLocked(std::size_t step, bool locked, const AssemblyPlan& plan, SequenceDemands demands) {
  const AssemblyStep& own = plan.steps[step];
  const BodyNames bodies = textsOf(own.bodies());
  std::erase_if(demands.places, [&](const DemandedPlace& each) { return hasOneOf(each.bodies, bodies); });
  for (const StepMotion& motion : own.motions) {
    if (motion.method == kByHand) continue;
    const BodyNames moved = textsOf(motion.bodies());
    dropMotion(moved, demands);
    if (locked) demands.motions.push_back({moved, motion.path, motion.method});
  }
  if (!locked) return demands;
  makeRoomAt(step + 1, demands.places);
  demands.places.push_back({textsOf(own.motions.front().bodies()), step + 1, true});
  std::sort(demands.places.begin(), demands.places.end(),
            [](const DemandedPlace& a, const DemandedPlace& b) { return a.place < b.place; });
  return demands;
}

SequenceDemands withForbidden(const std::vector<BodyId>& bodies, const Vector3& direction, SequenceDemands demands) {
  for (const BodyId& body : bodies) {
    const ForbiddenDirection added{body.text(), direction.normalized() + Vector3::Zero()};  // 0, not -0
    if (std::find(demands.forbidden.begin(), demands.forbidden.end(), added) == demands.forbidden.end()) {
      demands.forbidden.push_back(added);
    }
  }
  return demands;
}

SequenceDemands withOrder(const std::vector<std::vector<BodyId>>& steps, SequenceDemands demands) {
  for (std::size_t i = 1; i < steps.size(); ++i) {
    for (const BodyId& first : steps[i - 1]) {
      for (const BodyId& then : steps[i]) {
        const std::pair<std::string, std::string> rule(first.text(), then.text());
        auto& before = demands.before;
        if (std::find(before.begin(), before.end(), rule) == before.end()) before.push_back(rule);
      }
    }
  }
  return demands;
}

SequenceDemands withMotion(const DemandedMotion& motion, SequenceDemands demands) {
  dropMotion(motion.bodies, demands);
  demands.motions.push_back(motion);
  return demands;
}

SequenceDemands withoutDemandsOn(const std::vector<BodyId>& ids, SequenceDemands demands) {
  const BodyNames bodies = textsOf(ids);
  dropMotion(bodies, demands);
  std::erase_if(demands.places, [&](const DemandedPlace& each) { return hasOneOf(each.bodies, bodies); });
  std::erase_if(demands.forbidden, [&](const ForbiddenDirection& each) { return isOneOf(each.body, bodies); });
  std::erase_if(demands.before,
                [&](const auto& each) { return isOneOf(each.first, bodies) || isOneOf(each.second, bodies); });
  return demands;
}

StepDemands demandsOn(const std::vector<BodyId>& ids, const SequenceDemands& demands) {
  const BodyNames bodies = textsOf(ids);
  StepDemands own;
  for (const DemandedPlace& each : demands.places) {
    if (areAmong(each.bodies, bodies)) own.place = &each;
  }
  for (const DemandedMotion& each : demands.motions) {
    if (areAmong(each.bodies, bodies)) own.motion = &each;
  }
  for (const ForbiddenDirection& each : demands.forbidden) {
    if (isOneOf(each.body, bodies)) own.forbidden.push_back(each.direction);
  }
  for (const auto& [first, then] : demands.before) {
    if (isOneOf(first, bodies)) own.before.push_back(then);
    if (isOneOf(then, bodies)) own.after.push_back(first);
  }
  return own;
}

}  // namespace glissade
