#include "engine/sequence/floating_units.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/sequence/holding.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/proved_steps.h"

namespace glissade {
namespace {

/// Largest number of bodies that come as one.
constexpr std::size_t kMostLifted = 32;

class UnitLifter {
 public:
  UnitLifter(const AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host)
      : question_(question),
        host_(host),
        stop_(host.stopToken()),
        holding_(question),
        steps_(provedSteps(plan, question)) {}

  /// The steps with the lifted units; nothing if none was lifted.
  std::optional<std::vector<AssemblyStep>> run() {
    BodySet present = question_.initial();
    bool lifted = false;
    for (std::size_t place = 0; place < steps_.size() && !stop_.stopRequested(); ++place) {
      if (liftAt(place, present)) lifted = true;
      present = without(present, groupOf(steps_[place].step, question_.product));
    }
    if (!lifted) return std::nullopt;
    for (ProvedStep& each : steps_) each.step.after.clear();
    return certifiedInOrder(std::move(steps_), question_, stop_);
  }

 private:
  /// Lifts one of the units that would float after the step; false if there is none that can leave.
  bool liftAt(std::size_t place, const BodySet& present) {
    const BodyGroup carrier = groupOf(steps_[place].step, question_.product);
    const BodySet before = holding_.floating(present);
    BodySet after = holding_.floating(without(present, carrier));
    for (std::size_t body = 0; body < after.size(); ++body) after[body] = after[body] && !before[body];
    for (const BodyGroup& unit : holding_.connectedParts(after)) {
      if (lift(unit, place, present)) return true;
      BodyGroup with = unit;
      with.insert(with.end(), carrier.begin(), carrier.end());
      std::sort(with.begin(), with.end());
      if (lift(with, place, present)) return true;
      if (const auto larger = alongALine(with, place, present); larger && lift(*larger, place, present)) return true;
    }
    return false;
  }

  /// The smallest group with this unit that can leave along a line.
  std::optional<BodyGroup> alongALine(const BodyGroup& unit, std::size_t place, const BodySet& present) {
    std::vector<BodyGroup> units{unit};
    for (const std::size_t body : bodiesIn(question_.staying)) units.push_back({body});
    for (std::size_t later = place; later < steps_.size(); ++later) {
      BodyGroup group = groupOf(steps_[later].step, question_.product);
      if (!std::includes(unit.begin(), unit.end(), group.begin(), group.end())) units.push_back(std::move(group));
    }
    const auto groups =
        question_.trial.groupsAlongLines({present, question_.staying, units, kMostLifted}, host_.team(), stop_);
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const BodyGroup& group) {
      return std::includes(group.begin(), group.end(), unit.begin(), unit.end());
    });
    if (found == groups.end()) return std::nullopt;
    return *found;
  }

  /// Lets the unit leave before the step at `place`, and takes the steps of its bodies away.
  bool lift(const BodyGroup& unit, std::size_t place, const BodySet& present) {
    if (unit.size() > kMostLifted || !mayLeave(unit, present)) return false;
    for (int effort = 0; effort <= kMostEffort; ++effort) {
      const RemovalAnswer answer = question_.trial.tryRemoval(unit, present, effort, stop_);
      const auto* removed = std::get_if<Removed>(&answer);
      if (removed == nullptr) continue;
      AssemblyStep step;
      step.motions.push_back(makeMotion(unit, *removed, question_, present, place));
      const auto leavesWithIt = [&](const ProvedStep& each) {
        const BodyGroup group = groupOf(each.step, question_.product);
        return std::includes(unit.begin(), unit.end(), group.begin(), group.end());
      };
      steps_.erase(std::remove_if(steps_.begin(), steps_.end(), leavesWithIt), steps_.end());
      steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(place), {std::move(step), {present}});
      return true;
    }
    return false;
  }

  /// True if the steps of the unit's bodies are theirs alone, no person demands anything of them, and no joint holds
  /// them.
  bool mayLeave(const BodyGroup& unit, const BodySet& present) const {
    std::size_t bodies = 0;
    for (const ProvedStep& each : steps_) {
      const BodyGroup group = groupOf(each.step, question_.product);
      if (!std::binary_search(unit.begin(), unit.end(), group.front())) continue;
      if (!std::includes(unit.begin(), unit.end(), group.begin(), group.end())) return false;
      if (!each.step.only().certified) return false;
      if (question_.rules.placeOf(group) != 0 || question_.rules.motionOf(group) != nullptr) return false;
      bodies += group.size();
    }
    return bodies == unit.size() && heldBy(unit, present, question_.rules, true).empty() &&
           heldByJoints(unit, present, question_, true).empty();
  }

  /// Lines, turns and the shortest search.
  static constexpr int kMostEffort = 1;

  const SequenceQuestion& question_;
  SequenceHost& host_;
  const StopToken& stop_;
  Holding holding_;
  std::vector<ProvedStep> steps_;
};

}  // namespace

bool liftFloatingUnits(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host) {
  if (question.liaisons == nullptr || question.liaisons->liaisons().empty()) return false;
  auto steps = UnitLifter(plan, question, host).run();
  if (!steps) return false;
  plan.steps = std::move(*steps);
  plan.refusals.clear();  // they name numbers of steps that there are no longer
  plan.waiting.clear();
  return true;
}

}  // namespace glissade
