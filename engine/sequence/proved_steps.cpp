#include "engine/sequence/proved_steps.h"

#include <algorithm>
#include <utility>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/standing.h"
#include "engine/sequence/step_stacks.h"

namespace glissade {
namespace {

/// True if the proof of the motion covers all present bodies, and the nearest body that it names is one of them.
bool isStillProved(const StepMotion& motion, const BodySet& proved, const BodySet& present,
                   const AssembledProduct& product) {
  for (std::size_t body = 0; body < present.size(); ++body) {
    if (present[body] && !proved[body]) return false;
  }
  return motion.proof.nearest.empty() || present[product.indexOf(motion.proof.nearest)];
}

/// True if all bodies of the motion end outside of the box of the other bodies of `present`.
bool endsOutside(const StepMotion& motion, const BodyGroup& group, const BodySet& present,
                 const AssembledProduct& product) {
  const Box3 others = boxOf(product, without(present, group));
  const Pose moved = motion.path.back().q * inverse(motion.path.front().q);
  return others.isEmpty() || std::none_of(group.begin(), group.end(), [&](std::size_t body) {
           const RigidBody& own = product.bodies[body];
           return others.intersects(boundingBox(*own.mesh, moved * own.X_WB));
         });
}

/// Certifies the motion against the bodies that are there; false if that fails.
bool certify(StepMotion& motion, const BodySet& proved, const BodySet& present, std::size_t place,
             const SequenceQuestion& question, const StopToken& stop) {
  const BodyGroup group = groupOf(motion, question.product);
  if (!isStillProved(motion, proved, present, question.product)) {
    const auto removed = question.trial.certified(group, motion.path, motion.method, present, stop);
    if (!removed) return false;
    motion.proof = makeMotion(group, *removed, question, present, place).proof;
  }
  return endsOutside(motion, group, present, question.product);
}

}  // namespace

std::vector<ProvedStep> provedSteps(const AssemblyPlan& plan, const SequenceQuestion& question) {
  std::vector<BodySet> before{question.initial()};
  for (const AssemblyStep& step : plan.steps) {
    before.push_back(without(before.back(), groupOf(step, question.product)));
  }
  std::vector<ProvedStep> steps;
  for (const AssemblyStep& step : plan.steps) steps.push_back({step, before[step.only().proof.afterSteps]});
  return steps;
}

std::optional<std::vector<AssemblyStep>> certifiedInOrder(std::vector<ProvedStep> steps,
                                                          const SequenceQuestion& question, const StopToken& stop) {
  std::vector<AssemblyStep> certified;
  BodySet present = question.initial();
  BodyGroup last;
  std::size_t number = 0;
  for (ProvedStep& each : steps) {
    AssemblyStep& step = each.step;
    StepMotion& motion = step.only();
    const std::size_t place = certified.size();
    if (motion.certified && !certify(motion, each.proved, present, place, question, stop)) return std::nullopt;
    motion.proof.afterSteps = place;
    step.wave = place + 1;
    const BodyGroup group = groupOf(motion, question.product);
    BodyGroup falling;
    if (question.standing != nullptr) falling = question.standing->newlyFalling(present, group);
    motion.falling = idsOf(falling, question.product);
    number += continuesStack(group, last, question.joints) ? 0 : 1;
    last = group;
    if (question.rules.placeOf(group) != 0) step.violates = violationsOf(group, present, falling, number, question);
    present = without(present, group);
    certified.push_back(std::move(step));
  }
  return certified;
}

}  // namespace glissade
