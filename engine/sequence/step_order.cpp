#include "engine/sequence/step_order.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/proved_steps.h"
#include "engine/sequence/step_joints.h"
#include "engine/sequence/step_tools.h"

namespace glissade {
namespace {

BodyGroup bodiesOfStep(const AssemblyStep& step, const AssembledProduct& product) {
  BodyGroup bodies = product.indicesOf(step.bodies());
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

/// The bodies that are there after the first n steps, for each n.
std::vector<BodySet> presentAfter(const std::vector<AssemblyStep>& steps, const SequenceQuestion& question) {
  std::vector<BodySet> present{question.initial()};
  for (const AssemblyStep& step : steps) {
    present.push_back(without(present.back(), bodiesOfStep(step, question.product)));
  }
  return present;
}

/// For each step, its place in the order.
std::vector<std::size_t> placesIn(const std::vector<std::size_t>& order) {
  std::vector<std::size_t> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) places[order[place]] = place;
  return places;
}

bool isIn(std::size_t body, const std::vector<std::size_t>& bodies) {
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

/// Finds why a step has to be carried out before another one.
class OrderReasons {
 public:
  OrderReasons(const AssemblyPlan& plan, const SequenceQuestion& question, const StopToken& stop)
      : plan_(plan), question_(question), stop_(stop) {}

  /// Empty if nothing speaks against the other order.
  Message of(std::size_t first, std::size_t then) const {
    const BodyGroup before = bodiesOfStep(plan_.steps[first], question_.product);
    const BodyGroup after = bodiesOfStep(plan_.steps[then], question_.product);
    if (Message rule = ofRules(before, after); !rule.empty()) return rule;
    if (Message joint = ofJoints(before, after); !joint.empty()) return joint;
    for (const StepMotion& motion : plan_.steps[then].motions) {
      if (Message block = ofMotion(motion, before); !block.empty()) return block;
    }
    return {};
  }

  const std::string& name(std::size_t body) const { return question_.product.bodies[body].shown(); }

 private:
  Message ofRules(const BodyGroup& before, const BodyGroup& after) const {
    for (const OrderRule& rule : question_.rules.before) {
      if (!isIn(rule.first, before) || !isIn(rule.then, after)) continue;
      if (rule.demanded) {
        return {GLISSADE_TEXT("a constraint states that '%1' is removed before '%2'"),
                {name(rule.first), name(rule.then)}};
      }
      return {GLISSADE_TEXT("'%1' is on '%2'"), {name(rule.first), name(rule.then)}};
    }
    return {};
  }

  Message ofJoints(const BodyGroup& before, const BodyGroup& after) const {
    if (question_.joints == nullptr) return {};
    for (const Joint& joint : question_.joints->joints()) {
      std::vector<std::size_t> members = joint.others;
      members.insert(members.begin(), joint.body);
      const auto held = [&](const std::vector<std::size_t>& bodies, const BodyGroup& group) {
        return std::find_if(bodies.begin(), bodies.end(), [&](std::size_t body) { return isIn(body, group); });
      };
      const auto first = held(members, before);
      if (first == members.end()) continue;
      const auto clamped = held(joint.clamped, after);
      if (clamped != joint.clamped.end()) return {GLISSADE_TEXT("'%1' clamps '%2'"), {name(*first), name(*clamped)}};
      const auto then = held(members, after);
      if (then == members.end()) continue;
      if (isScrewed(joint.kind)) return {GLISSADE_TEXT("'%1' is screwed to '%2'"), {name(*first), name(*then)}};
      if (joint.kind == JointKind::Flexible) {
        return {GLISSADE_TEXT("'%1' goes around '%2'"), {name(joint.body), name(*then)}};
      }
    }
    return {};
  }

  Message ofMotion(const StepMotion& motion, const BodyGroup& before) const {
    const BodyGroup group = groupOf(motion, question_.product);
    if (!motion.certified) {
      const BodySet none(question_.product.bodies.size(), false);
      const auto box = [&](const BodyGroup& bodies) {
        BodySet set = none;
        for (const std::size_t body : bodies) set[body] = true;
        return boxOf(question_.product, set);
      };
      if (!box(group).intersects(box(before))) return {};
      return {GLISSADE_TEXT("'%1' is flexible and may meet '%2'"), {name(group.front()), name(before.front())}};
    }
    const auto blocking = question_.trial.inTheWay(group, motion.path, before, stop_);
    if (blocking.empty()) return {};
    return {GLISSADE_TEXT("'%1' is in the way of '%2'"), {name(blocking.front()), name(group.front())}};
  }

  const AssemblyPlan& plan_;
  const SequenceQuestion& question_;
  const StopToken& stop_;
};

/// Why the motion of a step is not certified at its new place.
OrderConflict conflictOf(std::size_t refused, const std::vector<std::size_t>& places, const AssemblyPlan& plan,
                         const SequenceQuestion& question, const StopToken& stop) {
  const OrderReasons reasons(plan, question, stop);
  for (std::size_t other = 0; other < refused; ++other) {
    if (places[other] < places[refused]) continue;
    if (Message reason = reasons.of(other, refused); !reason.empty()) return {other, refused, reason};
  }
  const BodyGroup group = groupOf(plan.steps[refused].motions.front(), question.product);
  return {
      refused, refused, {GLISSADE_TEXT("the motion of '%1' is not certified there"), {reasons.name(group.front())}}};
}

/// Sets what depends on the bodies that are there, for the steps from `begin` to before `end`.
void describe(AssemblyPlan& plan, std::size_t begin, std::size_t end, const SequenceQuestion& question,
              const StopToken& stop) {
  AssemblyPlan motions;  // tools are found for steps of one motion
  std::vector<BodySet> there;
  BodySet present = presentAfter(plan.steps, question)[begin];
  for (std::size_t step = begin; step < end; ++step) {
    for (StepMotion& motion : plan.steps[step].motions) {
      const BodyGroup group = groupOf(motion, question.product);
      setJoints(motion, group, present, question);
      present = without(std::move(present), group);
      motions.steps.push_back({{motion}});
      there.push_back(present);
    }
  }
  ToolFacts facts(motions, question);
  std::size_t number = 0;
  for (std::size_t step = begin; step < end; ++step) {
    for (StepMotion& motion : plan.steps[step].motions) {
      setTool(motion, facts, number, there[number], question, stop);
      ++number;
    }
  }
}

/// Drops what was noted while other bodies were there: after more than `begin` and fewer than `end` steps.
void forgetBetween(AssemblyPlan& plan, std::size_t begin, std::size_t end) {
  const auto isBetween = [&](std::size_t steps) { return steps > begin && steps < end; };
  std::erase_if(plan.refusals, [&](const RefusedRemoval& refused) { return isBetween(refused.afterSteps); });
  std::erase_if(plan.waiting, [&](const StepMotion& motion) { return isBetween(motion.proof.afterSteps); });
}

/// Lengthens the motions that would end among bodies that leave later in this order.
void lengthenIn(AssemblyPlan& plan, const std::vector<std::size_t>& order, const SequenceQuestion& question) {
  BodySet present = question.initial();
  for (const std::size_t step : order) {
    for (StepMotion& motion : plan.steps[step].motions) {
      const BodyGroup group = groupOf(motion, question.product);
      present = without(std::move(present), group);
      if (!motion.certified || endsOutside(motion, present, question.product)) continue;
      if (lengthen(motion, present, question.product)) motion.proof.afterSteps = plan.steps.size();  // no proof of it
    }
  }
}

}  // namespace

bool lengthen(StepMotion& motion, const BodySet& others, const AssembledProduct& product) {
  if (motion.path.size() < 2) return false;
  const Box3 room = boxOf(product, others);
  const Pose& q = motion.path.back().q;
  const Pose X_end = q * inverse(motion.path.front().q);
  Box3 box;
  for (const std::size_t body : groupOf(motion, product)) {
    box.extend(boundingBox(*product.bodies[body].mesh, X_end * product.bodies[body].X_WB));
  }
  const Vector3 displacement = q.position - motion.path[motion.path.size() - 2].q.position;
  if (room.isEmpty() || !box.intersects(room) || displacement.isZero()) return false;
  const Vector3 direction = displacement.normalized();
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (direction[i] > 0.0) least = std::min(least, (room.max()[i] - box.min()[i]) / direction[i]);
    if (direction[i] < 0.0) least = std::min(least, (room.min()[i] - box.max()[i]) / direction[i]);
  }
  constexpr double kBeyond = 0.01;  // share of the box, so that rounding does not matter
  motion.path.push_back(motion.path.back());
  motion.path.back().q.position += (least + kBeyond * room.diagonal().norm()) * direction;
  return true;
}

std::variant<AssemblyPlan, OrderConflict> withOrder(AssemblyPlan plan, const std::vector<std::size_t>& order,
                                                    const SequenceQuestion& question, SequenceHost& host) {
  const StopToken& stop = host.stopToken();
  const std::vector<std::size_t> places = placesIn(order);
  {
    const OrderReasons reasons(plan, question, stop);
    for (const std::size_t then : order) {
      std::vector<std::size_t> kept;
      for (const std::size_t number : plan.steps[then].after) {
        const std::size_t first = number - 1;
        if (places[first] > places[then]) {
          if (Message reason = reasons.of(first, then); !reason.empty()) return OrderConflict{first, then, reason};
        } else {
          kept.push_back(number);
        }
      }
      plan.steps[then].after = std::move(kept);
    }
  }
  lengthenIn(plan, order, question);
  std::size_t refusedAt = 0;
  auto steps = certifiedInOrder(provedSteps(plan, order, question), question, stop, &refusedAt);
  if (!steps) return conflictOf(order[refusedAt], places, plan, question, stop);
  plan.steps = std::move(*steps);
  for (SubassemblyLine& line : plan.lines) line.step = places[line.step - 1] + 1;
  std::sort(plan.lines.begin(), plan.lines.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
  std::size_t begin = 0;
  std::size_t end = order.size();
  while (begin < end && order[begin] == begin) ++begin;
  while (end > begin && order[end - 1] == end - 1) --end;
  forgetBetween(plan, begin, end);
  describe(plan, begin, end, question, stop);
  return plan;
}

}  // namespace glissade
