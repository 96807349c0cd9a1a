#include "engine/sequence/demand_edits.h"

#include <algorithm>
#include <set>

#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

using BodyNames = std::vector<std::string>;

bool areSameBodies(const BodyNames& a, const BodyNames& b) {
  return std::set<std::string>(a.begin(), a.end()) == std::set<std::string>(b.begin(), b.end());
}

bool isOneOf(const std::string& name, const BodyNames& bodies) {
  return std::find(bodies.begin(), bodies.end(), name) != bodies.end();
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

}  // namespace

SequenceDemands withStepMoved(std::size_t from, std::size_t to, const AssemblyPlan& plan, SequenceDemands demands) {
  std::vector<BodyNames> steps;
  for (const AssemblyStep& step : plan.steps) steps.push_back(textsOf(step.bodies()));
  demands.places = movedTo(to, from, steps, demands.places);
  return demands;
}

SequenceDemands withStepLocked(std::size_t step, bool locked, const AssemblyPlan& plan, SequenceDemands demands) {
  const AssemblyStep& own = plan.steps[step];
  const BodyNames bodies = textsOf(own.bodies());
  const bool byHand = own.method == kByHand;
  std::erase_if(demands.places, [&](const DemandedPlace& each) { return hasOneOf(each.bodies, bodies); });
  if (!byHand) dropMotion(bodies, demands);
  if (!locked) return demands;
  makeRoomAt(step + 1, demands.places);
  demands.places.push_back({bodies, step + 1, true});
  std::sort(demands.places.begin(), demands.places.end(),
            [](const DemandedPlace& a, const DemandedPlace& b) { return a.place < b.place; });
  return byHand ? demands : withMotion({bodies, own.path, own.method}, std::move(demands));
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
    if (areSameBodies(each.bodies, bodies)) own.place = &each;
  }
  for (const DemandedMotion& each : demands.motions) {
    if (areSameBodies(each.bodies, bodies)) own.motion = &each;
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
