#include "app/cli/plan_conditions.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/check/condition.h"
#include "engine/check/standard_pitch.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade::cli {
namespace {

/// Adds the unusual pitches of the threads in which the motion turns.
void addPitches(const StepMotion& motion, const AssembledProduct& product, std::vector<Message>& conditions) {
  const auto nameOf = [&](const BodyId& id) { return product.body(id).shown(); };
  const std::vector<BodyId> moving = motion.bodies();
  for (const StepJoint& joint : motion.joints) {
    const double pitch = std::abs(joint.pitch);
    if (joint.turns == 0.0 || joint.isPitchStated || check::isStandardPitch(joint.diameter, pitch)) continue;
    const bool turns = std::find(moving.begin(), moving.end(), joint.body) != moving.end();
    for (const BodyId& other : joint.others) {
      const auto& [mover, fixed] = turns ? std::tie(joint.body, other) : std::tie(other, joint.body);
      conditions.push_back(check::hasPitch(nameOf(mover), nameOf(fixed), pitch, joint.diameter).text);
    }
  }
}

}  // namespace

std::vector<Message> conditionsOf(const AssemblyPlan& plan, const AssembledProduct& product, const StatedUnits& units) {
  std::vector<Message> conditions;
  for (const StepMotion* motion : allMotionsOf(plan)) addPitches(*motion, product, conditions);
  for (const auto& unit : units.leaving) conditions.push_back(check::areOneUnit(unit).text);
  if (!units.base.empty()) conditions.push_back(check::areFixedAsBase(units.base).text);
  return conditions;
}

}  // namespace glissade::cli
