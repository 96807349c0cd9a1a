#include "engine/sequence/step_joints.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "engine/sequence/plan_steps.h"

namespace glissade {
namespace {

/// The ids of the bodies that are there: in the line of a group the other bodies do not exist.
std::vector<BodyId> idsOf(const std::vector<std::size_t>& bodies, const BodySet& present,
                          const AssembledProduct& product) {
  BodyGroup there;
  for (const std::size_t body : bodies) {
    if (present[body]) there.push_back(body);
  }
  return idsOf(there, product);
}

StepJoint stepJoint(const Joint& joint, const BodySet& present, const AssembledProduct& product) {
  StepJoint own;
  own.kind = joint.kind;
  own.body = product.bodies[joint.body].id;
  own.others = idsOf(joint.others, present, product);
  own.clamped = idsOf(joint.clamped, present, product);
  own.designation = joint.designation;
  own.drive = joint.drive;
  own.driveSize = joint.driveSize;
  own.bend = joint.bend;
  if (!joint.thread) return own;
  own.diameter = joint.thread->diameter;
  own.pitch = joint.thread->pitch;
  own.isPitchStated = joint.thread->isPitchStated;
  return own;
}

/// True for a joint without a thread whose body leaves while a body that it is joined to stays.
bool isLeft(const Joint& joint, const BodyGroup& group, const BodySet& others) {
  return !isScrewed(joint.kind) && std::binary_search(group.begin(), group.end(), joint.body) &&
         std::any_of(joint.others.begin(), joint.others.end(), [&](std::size_t other) { return others[other]; });
}

std::vector<StepJoint> jointsOf(const StepMotion& motion, const BodyGroup& group, const BodySet& present,
                                const SequenceQuestion& question) {
  std::vector<StepJoint> joints;
  const JointRules& rules = *question.joints;
  for (const std::size_t index : rules.opened(group, present)) {
    joints.push_back(stepJoint(rules.joints()[index], present, question.product));
    joints.back().turns = turnsOf(motion.path);
  }
  const BodySet others = without(present, group);
  for (const Joint& joint : rules.joints()) {
    if (isLeft(joint, group, others)) joints.push_back(stepJoint(joint, present, question.product));
  }
  return joints;
}

}  // namespace

void setJoints(StepMotion& motion, const BodyGroup& group, const BodySet& present, const SequenceQuestion& question) {
  if (question.joints != nullptr) motion.joints = jointsOf(motion, group, present, question);
}

double turnsOf(const std::vector<PathPoint>& path) {
  double angle = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) angle += angleBetween(path[i - 1].q.orientation, path[i].q.orientation);
  return angle / (2.0 * std::numbers::pi);
}

void addJoints(AssemblyPlan& plan, const SequenceQuestion& question) {
  if (question.joints == nullptr) return;
  BodySet present = question.initial();
  std::map<std::size_t, std::vector<std::size_t>> tasks;  // indices of the steps of each task
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const BodyGroup group = groupOf(plan.steps[i], question.product);
    setJoints(plan.steps[i].only(), group, present, question);
    plan.steps[i].task = 0;
    if (group.size() == 1) tasks[question.joints->taskOf(group.front())].push_back(i);
    present = without(std::move(present), group);
  }
  tasks.erase(0);
  std::map<std::size_t, std::vector<std::size_t>> byFirst;
  for (auto& [task, steps] : tasks) {
    if (steps.size() > 1) byFirst[steps.front()] = std::move(steps);
  }
  std::size_t number = 0;
  for (const auto& [first, steps] : byFirst) {
    ++number;
    for (const std::size_t step : steps) plan.steps[step].task = number;
  }
}

}  // namespace glissade
