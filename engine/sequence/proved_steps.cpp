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

/// Certifies the motion against the bodies that are there; false if that fails.
bool certify(StepMotion& motion, const BodySet& proved, const BodySet& present, std::size_t place,
             const SequenceQuestion& question, const StopToken& stop) {
  const BodyGroup group = groupOf(motion, question.product);
  if (!isStillProved(motion, proved, present, question.product)) {
    const auto removed = question.trial.certified(group, motion.path, motion.method, present, stop);
    if (!removed) return false;
    motion.proof = makeMotion(group, *removed, question, present, place).proof;
  }
  return endsOutside(motion, without(present, group), question.product);
}

}  // namespace

bool endsOutside(const StepMotion& motion, const BodySet& others, const AssembledProduct& product) {
  const Box3 room = boxOf(product, others);
  const Pose moved = motion.path.back().q * inverse(motion.path.front().q);
  const BodyGroup group = groupOf(motion, product);
  return room.isEmpty() || std::none_of(group.begin(), group.end(), [&](std::size_t body) {
           const RigidBody& own = product.bodies[body];
           return room.intersects(boundingBox(*own.mesh, moved * own.X_WB));
         });
}

std::vector<ProvedStep> provedSteps(const AssemblyPlan& plan, const SequenceQuestion& question) {
  std::vector<BodySet> before{question.initial()};
  for (const AssemblyStep& step : plan.steps) {
    before.push_back(without(before.back(), question.product.indicesOf(step.bodies())));
  }
  std::vector<ProvedStep> steps;
  for (const AssemblyStep& step : plan.steps) {
    steps.push_back({step, {}});
    BodyGroup earlier;  // bodies of the step that have left
    for (const StepMotion& motion : step.motions) {
      steps.back().proved.push_back(without(before[motion.proof.afterSteps], earlier));
      for (const std::size_t body : groupOf(motion, question.product)) earlier.push_back(body);
    }
  }
  return steps;
}

std::vector<ProvedStep> provedSteps(const AssemblyPlan& plan, const std::vector<std::size_t>& order,
                                    const SequenceQuestion& question) {
  std::vector<std::size_t> numberOf(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) numberOf[order[place]] = place + 1;
  const std::vector<ProvedStep> proved = provedSteps(plan, question);
  std::vector<ProvedStep> steps;
  for (const std::size_t step : order) {
    steps.push_back(proved[step]);
    for (std::size_t& earlier : steps.back().step.after) earlier = numberOf[earlier - 1];
    std::sort(steps.back().step.after.begin(), steps.back().step.after.end());
  }
  return steps;
}

std::optional<std::vector<AssemblyStep>> certifiedInOrder(std::vector<ProvedStep> steps,
                                                          const SequenceQuestion& question, const StopToken& stop,
                                                          std::size_t* refused) {
  std::vector<AssemblyStep> certified;
  BodySet present = question.initial();
  BodyGroup last;
  std::size_t number = 0;
  for (ProvedStep& each : steps) {
    AssemblyStep& step = each.step;
    const std::size_t place = certified.size();
    std::vector<StepViolation> violates;
    bool isPlaced = false;
    for (std::size_t i = 0; i < step.motions.size(); ++i) {
      StepMotion& motion = step.motions[i];
      if (motion.certified && !certify(motion, each.proved[i], present, place, question, stop)) {
        if (refused != nullptr) *refused = place;
        return std::nullopt;
      }
      motion.proof.afterSteps = place;
      const BodyGroup group = groupOf(motion, question.product);
      BodyGroup falling;
      if (question.standing != nullptr) falling = question.standing->newlyFalling(present, group);
      motion.falling = idsOf(falling, question.product);
      number += continuesStack(group, last, question.joints) ? 0 : 1;
      last = group;
      if (question.rules.placeOf(group) != 0) {
        isPlaced = true;
        const auto own = violationsOf(group, present, falling, number, question);
        violates.insert(violates.end(), own.begin(), own.end());
      }
      present = without(present, group);
    }
    step.wave = place + 1;
    if (isPlaced) step.violates = std::move(violates);
    certified.push_back(std::move(step));
  }
  return certified;
}

}  // namespace glissade
