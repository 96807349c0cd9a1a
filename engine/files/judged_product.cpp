#include "engine/files/judged_product.h"

#include <algorithm>

#include "engine/files/scenario_fits.h"
#include "engine/fits/fit_thread.h"
#include "engine/fits/fit_words.h"
#include "engine/fits/joint_edits.h"

namespace glissade {
namespace {

std::vector<check::Point> judgedPoints(const std::vector<PathPoint>& points) {
  std::vector<check::Point> judged;
  for (const PathPoint& point : points) judged.push_back({point.q, point.author == Author::Contact});
  return judged;
}

check::Demands judgedDemands(const SequenceDemands& demands) {
  check::Demands judged;
  judged.together = demands.together;
  judged.before = demands.before;
  for (const DemandedPlace& each : demands.places) judged.places.push_back({each.bodies, each.place});
  for (const DemandedMotion& each : demands.motions) {
    judged.motions.push_back({each.bodies, configurationsOf(each.path)});
  }
  for (const ForbiddenDirection& each : demands.forbidden) judged.forbidden.emplace_back(each.body, each.direction);
  judged.stay = demands.stay;
  return judged;
}

check::StatedJoint judgedJoint(const StepJoint& joint) {
  check::StatedJoint judged{kJointKindNames.of(joint.kind), joint.body, joint.others};
  if (joint.drive != DriveKind::None) judged.drive = kDriveNames.of(joint.drive);
  judged.isNamed = !joint.designation.empty();
  if (joint.driveSize > 0.0) judged.driveSize = joint.driveSize;
  if (joint.bend > 0.0) judged.bend = joint.bend;
  if (joint.pitch == 0.0) return judged;
  judged.diameter = joint.diameter;
  judged.pitch = joint.pitch;
  judged.turns = joint.turns;
  return judged;
}

check::StatedProof judgedProof(const StepProof& proof) {
  return {proof.afterSteps, proof.required, proof.provedClearance, proof.minClearance, proof.nearest};
}

check::Step judgedMotion(const StepMotion& motion, const AssemblyStep& step) {
  check::Step judged{motion.bodies(), judgedPoints(motion.path), step.after, {}, {}, motion.certified};
  for (const Allowance& each : motion.allowances) {
    check::StatedAllowance allowance{each.moving, each.body, each.allowance, each.yields};
    allowance.hollow = each.hollow;
    allowance.core = each.core;
    allowance.isThread = each.kind == ContactKind::Thread;
    allowance.overlap = each.overlap;
    if (each.evidence.sum() > 0.0) allowance.evidence = each.evidence;
    if (each.pitch != 0.0) {
      allowance.pitch = each.pitch;
      allowance.turns = each.turns;
    }
    judged.allowances.push_back(std::move(allowance));
  }
  for (const StepViolation& each : step.violates) judged.violates.push_back({kRuleNames.of(each.rule), each.bodies});
  judged.flexible =
      motion.with.empty() && std::any_of(motion.joints.begin(), motion.joints.end(), [&](const auto& joint) {
        return joint.kind == JointKind::Flexible && joint.body == motion.body;
      });
  for (const StepJoint& joint : motion.joints) judged.joints.push_back(judgedJoint(joint));
  if (motion.proof.required > 0.0) judged.proof = judgedProof(motion.proof);
  judged.unit = motion.unit;
  judged.wave = step.wave;
  judged.task = step.task;
  return judged;
}

/// The motions of all steps.
std::vector<check::Step> judgedSteps(const std::vector<AssemblyStep>& steps) {
  std::vector<check::Step> judged;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool isOnly = steps[i].motions.size() == 1;
    for (const StepMotion& motion : steps[i].motions) {
      check::Step own = judgedMotion(motion, steps[i]);
      own.number = i + 1;
      const bool isFirst = judged.empty() || judged.back().number != own.number;
      if (!isOnly) own.motion = isFirst ? 1 : judged.back().motion + 1;
      judged.push_back(std::move(own));
    }
  }
  return judged;
}

/// A person's statements about joints, in the order in which they were made.
evidence::PartingWords partingsOf(const SequenceDemands& demands) {
  evidence::PartingWords words = glissade::partingsOf(demands.joints);
  words.anyPair = demands.jointUse == JointUse::Off;
  return words;
}

check::JointWords jointWordsOf(const std::vector<JointEdit>& edits) {
  check::JointWords words;
  words.units = unitsOf(edits);
  for (const JointEdit& edit : edits) {
    const bool isConfirmed = edit.word == JointEdit::Word::Confirmed;
    switch (edit.key.kind) {
      case JointKind::Flexible:
        std::erase(words.flexible, edit.key.body);
        if (isConfirmed) words.flexible.push_back(edit.key.body);
        break;
      case JointKind::Insert:
      case JointKind::Permanent:
      case JointKind::Unit: break;
      default:
        if (!isConfirmed || !edit.made || !edit.made->thread) break;
        for (const BodyId& other : edit.key.others) {
          words.pitches.push_back({edit.key.body, other, edit.made->thread->pitch});
        }
    }
  }
  return words;
}

check::Line judgedLine(const SubassemblyLine& line) {
  check::Line judged{line.step, line.bodies, line.staying, judgedSteps(line.steps), {}};
  for (const SubassemblyLine& below : line.lines) judged.lines.push_back(judgedLine(below));
  return judged;
}

}  // namespace

std::vector<evidence::Body> judgedBodies(const std::vector<RigidBody>& bodies) {
  std::vector<evidence::Body> judged;
  for (const RigidBody& body : bodies) judged.push_back({body.id, body.shown(), body.mesh, body.X_WB});
  return judged;
}

check::Product judgedProduct(const AssembledProduct& product) {
  check::Product judged{judgedBodies(product.bodies), wordsOf(product.fits)};
  judged.fits.snaps = product.snaps;
  for (std::size_t i = 0; i < judged.bodies.size() && i < product.deflections.size(); ++i) {
    judged.bodies[i].deflection = product.deflections[i];
  }
  return judged;
}

check::Plan judgedPlan(const AssemblyPlan& plan) {
  check::Plan judged;
  judged.bodies = plan.bodies;
  judged.staying = plan.staying;
  judged.steps = judgedSteps(plan.steps);
  judged.end = kPlanEndNames.of(plan.end);
  judged.demands = judgedDemands(plan.demands);
  judged.snaps = bendsOf(plan.demands.joints);
  judged.partings = partingsOf(plan.demands);
  judged.joints = jointWordsOf(plan.demands.joints);
  judged.deflection = plan.deflection;
  for (const SubassemblyLine& line : plan.lines) judged.lines.push_back(judgedLine(line));
  return judged;
}

check::Question judgedQuestion(const LoadedScenario& scenario) {
  check::Question question;
  const AssembledProduct product = objectAndOthers(scenario);
  question.product = judgedProduct(product);
  question.product.bodies.back().X_WB = scenario.problem.start;
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    question.product.bodies[i].spacing = product.spacings[i];
  }
  question.product.demands = judgedDemands(scenario.scenario.sequence);
  if (const Pose* goal = std::get_if<Pose>(&scenario.problem.goal)) question.goal = *goal;
  question.workspace = scenario.problem.bounds;
  question.requiredClearance = scenario.parameters[ParameterId::RequiredClearance];
  question.contactGap = scenario.parameters[ParameterId::ContactGap];
  return question;
}

check::PlanVerdict judgePlan(const AssemblyPlan& plan, const AssembledProduct& product, std::optional<double> required,
                             const WorkWatch& watch, const SequenceDemands* said) {
  check::Product judged = judgedProduct(product);
  if (said != nullptr) {
    judged.demands = judgedDemands(*said);
    judged.fits.partings = partingsOf(*said);
    judged.joints = jointWordsOf(said->joints);
  }
  return check::judgePlan(judged, judgedPlan(plan), required, watch);
}

}  // namespace glissade
