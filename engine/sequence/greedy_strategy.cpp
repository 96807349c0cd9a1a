#include "engine/sequence/greedy_strategy.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/sequence_strategy.h"
#include "engine/sequence/step_precedence.h"
#include "engine/sequence/step_stacks.h"
#include "engine/sequence/stuck_reasons.h"

namespace glissade {
namespace {

/// For each assembly of the file, its bodies that are in `present`; the smallest first. Assemblies with one such body,
/// and those that would cut a unit of the rules, are left out.
std::vector<BodyGroup> assembliesThere(const SequenceQuestion& question, const BodySet& present) {
  const Product& tree = question.product.tree;
  std::map<BodyId, std::size_t> numbers;
  for (const std::size_t body : bodiesIn(present)) numbers.emplace(question.product.bodies[body].id, body);
  std::set<BodyGroup> assemblies;
  for (std::size_t node = 0; node < tree.nodes().size(); ++node) {
    if (tree.nodes()[node].children.empty()) continue;
    BodyGroup bodies;
    for (const BodyId& id : tree.bodiesBelow(node)) {
      if (const auto there = numbers.find(id); there != numbers.end()) bodies.push_back(there->second);
    }
    std::sort(bodies.begin(), bodies.end());
    const bool whole = std::all_of(bodies.begin(), bodies.end(), [&](std::size_t body) {
      const BodyGroup unit = unitOf(body, question.rules);
      return std::includes(bodies.begin(), bodies.end(), unit.begin(), unit.end());
    });
    if (whole && bodies.size() > 1) assemblies.insert(std::move(bodies));
  }
  std::vector<BodyGroup> groups(assemblies.begin(), assemblies.end());
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return groups;
}

/// The clusters of the bodies that are there at the beginning (LiaisonGraph::clusters()), without those that are one
/// unit of the rules, or the whole of what is there.
std::vector<BodyGroup> clustersOf(const SequenceQuestion& question) {
  if (question.joints == nullptr || question.liaisons == nullptr) return {};
  const BodySet there = question.initial();
  std::vector<BodyGroup> clusters = question.liaisons->clusters();
  std::erase_if(clusters, [&](const BodyGroup& cluster) {
    const bool isWhole = std::all_of(cluster.begin(), cluster.end(), [&](std::size_t body) {
      const BodyGroup unit = unitOf(body, question.rules);
      return there[body] && std::includes(cluster.begin(), cluster.end(), unit.begin(), unit.end());
    });
    return !isWhole || unitOf(cluster.front(), question.rules) == cluster ||
           cluster.size() == static_cast<std::size_t>(std::count(there.begin(), there.end(), true));
  });
  return clusters;
}

/// Number of units that are searched at the same time, whatever the number of threads.
constexpr std::size_t kSearchedTogether = 4;
/// Limits of the bodies of a group that leaves as one: before the long searches of single bodies, and after them.
constexpr std::size_t kFewBodies = 4;
constexpr std::size_t kMostBodies = 32;
/// Searches up to this effort come before groups.
constexpr int kShortEffort = 1;
/// Effort of the searches of groups.
constexpr int kGroupEffort = 2;

class GreedySearch {
 public:
  GreedySearch(const SequenceQuestion& question, SequenceHost& host)
      : question_(question), host_(host), present_(question.initial()), placed_(question.product.bodies.size(), false) {
    plan_.seed = question.seed;
    plan_.up = question.up;
    for (std::size_t body = 0; body < present_.size(); ++body) {
      if (present_[body]) plan_.bodies.push_back(idOf(body));
      if (present_[body] && question.staying[body]) plan_.staying.push_back(idOf(body));
      volumes_.push_back(boxVolume(question.product.bodies[body]));
    }
    for (const auto& step : question.rules.placed) {
      for (const std::size_t body : step.group) placed_[body] = true;
    }
    clusters_ = clustersOf(question);
    if (question.resumed != nullptr) resume(*question.resumed);
  }

  AssemblyPlan run() {
    while (!stopped() && wave()) {
    }
    finish();
    return std::move(plan_);
  }

 private:
  const BodyId& idOf(std::size_t body) const { return question_.product.bodies[body].id; }
  bool stopped() const { return host_.stopToken().stopRequested(); }

  std::vector<BodyId> idsOf(const BodyGroup& bodies) const { return glissade::idsOf(bodies, question_.product); }

  BodyGroup refusedGroup(const RefusedRemoval& refused) const {
    BodyGroup group = question_.product.indicesOf(refused.with);
    group.push_back(question_.product.indexOf(refused.body));
    std::sort(group.begin(), group.end());
    return group;
  }

  void resume(const AssemblyPlan& earlier) {
    for (const AssemblyStep& step : earlier.steps) {
      const BodyGroup group = groupOf(step, question_.product);
      count(group);
      plan_.steps.push_back(step);
      present_ = without(present_, group);
      wave_ = step.wave;
      question_.trial.learn(group, step.only().path);
    }
    for (const RefusedRemoval& refused : earlier.refusals) {
      refusals_[refusedGroup(refused)][refused.effort] = {question_.product.indicesOf(refused.blockedBy),
                                                          refused.afterSteps};
    }
    for (const StepMotion& motion : earlier.waiting) waiting_[groupOf(motion, question_.product)] = motion;
  }

  /// The units that leave as one: groups that a person demands, and single bodies.
  std::vector<BodyGroup> units() const {
    std::vector<BodyGroup> units;
    BodySet open = present_;
    for (const BodyGroup& group : question_.rules.together) {
      if (open[group.front()]) units.push_back(group);
      open = without(open, group);
    }
    for (const std::size_t body : bodiesIn(open)) units.push_back({body});
    std::sort(units.begin(), units.end());
    return units;
  }

  /// False if no question is left. Rules that nobody demands are kept only for the first trial of straight lines.
  bool wave() {
    if (leaveAtPlaces(false)) return true;
    if (stopped()) return false;
    if (clustersLeave()) return true;
    if (stopped()) return false;
    if (askAll(openUnits(0, true), 0)) return true;
    if (stopped()) return false;  // a question that the stop cut off might have led to a removal
    if (leave() || flexibleLeaves()) return true;
    const int efforts = question_.trial.efforts();
    for (int effort = 0; effort < efforts && !stopped(); ++effort) {
      if (effort == kShortEffort + 1 && (groupsLeave(kFewBodies) || assembliesLeave())) return true;
      if (askAll(openUnits(effort, false), effort)) return true;
    }
    if (stopped()) return false;
    if (efforts <= kShortEffort + 1 && (groupsLeave(kFewBodies) || assembliesLeave())) return true;
    return searchedGroupsLeave() || groupsLeave(kMostBodies) || leaveAtPlaces(true);
  }

  /// Carries out the steps that a person wants at the places that come now. `early`: if no step is due, the next such
  /// step is carried out. True if a body has left.
  bool leaveAtPlaces(bool early) {
    const std::size_t before = plan_.steps.size();
    for (const auto& step : question_.rules.placed) {
      if (stopped()) break;
      const bool due = step.place == numberOfNext(step.group);
      const bool isNext = early && plan_.steps.size() == before;
      if ((due || isNext) && isThere(step.group) && notAtPlace_.count(step.group) == 0) leaveAtPlace(step.group);
    }
    if (plan_.steps.size() == before) return false;
    std::erase_if(waiting_, [&](const auto& each) { return !isThere(each.first); });
    announce();
    return true;
  }

  /// Uses the first motion that is found. A group without a motion never leaves: it gets no other place silently.
  void leaveAtPlace(const BodyGroup& group) {
    const int efforts = std::min(question_.trial.efforts(), kGroupEffort + 1);
    std::set<std::size_t> blocking;
    for (int effort = 0; effort < efforts; ++effort) {
      host_.asking({group}, effort);
      const RemovalAnswer answer = question_.trial.tryRemoval(group, present_, effort, host_.stopToken());
      if (const auto* removed = std::get_if<Removed>(&answer)) {
        const BodyGroup falling = fallingWithout(group);
        const auto violations = violationsOf(group, present_, falling, numberOfNext(group), question_);
        waiting_[group] = makeMotion(group, *removed, question_, present_, plan_.steps.size());
        ++wave_;
        carryOut(group, falling);
        plan_.steps.back().violates = violations;
        restOfStackLeaves(group);
        return;
      }
      const auto& refused = std::get<Refused>(answer);
      if (refused.stopped || stopped()) return;
      blocking.insert(refused.blockedBy.begin(), refused.blockedBy.end());
      if (question_.rules.motionOf(group) != nullptr) break;  // there is no other motion
    }
    notAtPlace_[group] = {{blocking.begin(), blocking.end()}, numberOfNext(group) - 1};
  }

  /// Announces the plan so far, as one that can be resumed.
  void announce() {
    AssemblyPlan soFar = plan_;
    for (const auto& [group, byEffort] : refusals_) addRefusals(group, byEffort, soFar);
    for (const auto& [group, motion] : waiting_) soFar.waiting.push_back(motion);
    soFar.end = PlanEnd::Interrupted;
    host_.stepFound(soFar);
  }

  /// Asks for batches of groups; true as soon as a body has left.
  bool askAll(std::vector<BodyGroup> open, int effort) {
    const std::size_t together = effort == 0 ? open.size() : kSearchedTogether;
    while (!open.empty() && !stopped()) {
      if (ask(takeDisjoint(open, together), effort)) return true;
    }
    return false;
  }

  /// Takes out the first groups that have no body in common, up to `most`.
  static std::vector<BodyGroup> takeDisjoint(std::vector<BodyGroup>& open, std::size_t most) {
    std::set<std::size_t> taken;
    std::vector<BodyGroup> batch;
    std::vector<BodyGroup> rest;
    for (BodyGroup& group : open) {
      const bool free = batch.size() < most &&
                        std::none_of(group.begin(), group.end(), [&](std::size_t b) { return taken.count(b) != 0; });
      if (free) taken.insert(group.begin(), group.end());
      (free ? batch : rest).push_back(std::move(group));
    }
    open = std::move(rest);
    return batch;
  }

  std::vector<BodyGroup> openUnits(int effort, bool knowledge) const {
    std::vector<BodyGroup> open;
    for (const BodyGroup& unit : units()) {
      const bool isSearched = effort == 0 || !isFlexible(unit);
      if (isSearched && waiting_.count(unit) == 0 && mayLeave(unit, knowledge) && isOpen(unit, effort)) {
        open.push_back(unit);
      }
    }
    return open;
  }

  /// A body that a person wants at a place may leave there only. `knowledge`: rules that nobody demands count as well.
  bool mayLeave(const BodyGroup& group, bool knowledge) const {
    const bool stays = std::any_of(group.begin(), group.end(), [&](std::size_t b) { return question_.staying[b]; });
    const bool placed = std::any_of(group.begin(), group.end(), [&](std::size_t b) { return placed_[b]; });
    return !stays && !placed && !waitsForStack(group) && heldBy(group, knowledge).empty();
  }

  /// The bodies of the group's fastener stack; empty: it is of none.
  BodyGroup stackOf(const BodyGroup& group) const {
    if (question_.joints == nullptr || group.size() != 1) return {};
    const std::size_t stack = question_.joints->stackOf(group.front());
    return stack == 0 ? BodyGroup() : question_.joints->stacks()[stack - 1];
  }

  /// True if a person wants another motion of the stack at a place: the rest of the stack follows it.
  bool waitsForStack(const BodyGroup& group) const {
    const BodyGroup stack = stackOf(group);
    return std::any_of(stack.begin(), stack.end(), [&](std::size_t body) {
      return body != group.front() && present_[body] && placed_[body] && notAtPlace_.count({body}) == 0;
    });
  }

  /// Bodies that hold the group, by demands and by joints.
  std::vector<std::size_t> heldBy(const BodyGroup& group, bool knowledge) const {
    std::vector<std::size_t> holding = glissade::heldBy(group, present_, question_.rules, knowledge);
    const BodyGroup screws = heldByJoints(group, present_, question_, knowledge);
    holding.insert(holding.end(), screws.begin(), screws.end());
    return holding;
  }

  bool isFlexible(const BodyGroup& unit) const {
    return question_.joints != nullptr && unit.size() == 1 && question_.joints->isFlexible(unit.front());
  }

  /// If nothing leaves along a line, the smallest flexible body leaves, because it bends.
  bool flexibleLeaves() {
    std::optional<std::size_t> smallest;
    for (const BodyGroup& unit : units()) {
      if (!isFlexible(unit) || !mayLeave(unit, false)) continue;
      if (!smallest || volumes_[unit.front()] < volumes_[*smallest]) smallest = unit.front();
    }
    if (!smallest) return false;
    ++wave_;
    const BodyGroup unit{*smallest};
    waiting_[unit] = makeFlexibleMotion(*smallest, present_, question_, plan_.steps.size());
    carryOut(unit, fallingWithout(unit));
    waiting_.erase(unit);
    announce();
    return true;
  }

  bool isOpen(const BodyGroup& group, int effort) const {
    const auto ofGroup = refusals_.find(group);
    if (ofGroup == refusals_.end()) return true;
    const auto refusal = ofGroup->second.find(effort);
    return refusal == ofGroup->second.end() ||
           std::any_of(refusal->second.blockedBy.begin(), refusal->second.blockedBy.end(),
                       [&](std::size_t other) { return !present_[other]; });
  }

  bool groupsLeave(std::size_t most) {
    const auto all = units();
    std::vector<BodyGroup> groups =
        question_.trial.groupsAlongLines({present_, question_.staying, all, most}, host_.team(), host_.stopToken());
    groups.erase(
        std::remove_if(groups.begin(), groups.end(), [&](const BodyGroup& group) { return !mayLeave(group, false); }),
        groups.end());
    // Only the smallest groups leave: bodies that they release may leave alone.
    if (groups.empty() || stopped()) return false;
    const std::size_t size = groups.front().size();
    groups.erase(std::find_if(groups.begin(), groups.end(), [&](const BodyGroup& g) { return g.size() > size; }),
                 groups.end());
    return ask(groups, 0);
  }

  /// Asks for the clusters that nothing joins to the base, along lines: a carriage slides off its rail before its
  /// wheels are unscrewed.
  bool clustersLeave() {
    std::vector<BodyGroup> open;
    for (const BodyGroup& cluster : clusters_) {
      const bool mayBeAsked = isThere(cluster) && waiting_.count(cluster) == 0 && cluster.size() <= kMostBodies;
      if (mayBeAsked && mayLeave(cluster, false) && isOpen(cluster, 0)) open.push_back(cluster);
    }
    return askAll(std::move(open), 0);
  }

  /// Asks for the assemblies of the file along lines, whatever their size: a carriage slides off its rail.
  bool assembliesLeave() {
    std::vector<BodyGroup> open;
    for (const BodyGroup& group : assembliesThere(question_, present_)) {
      if (mayLeave(group, false) && isOpen(group, 0)) open.push_back(group);
    }
    return askAll(std::move(open), 0);
  }

  /// Searches each unit together with one of the units that block it, and the assemblies of the file.
  bool searchedGroupsLeave() {
    if (question_.trial.efforts() <= 1) return false;
    std::set<BodyGroup> groups;
    for (const BodyGroup& unit : units()) {
      const auto ofUnit = refusals_.find(unit);
      if (ofUnit == refusals_.end()) continue;
      for (const auto& [effort, refusal] : ofUnit->second) {
        for (const std::size_t other : refusal.blockedBy) addGroup(groups, unit, unitOf(other));
      }
    }
    for (const BodyGroup& group : assembliesThere(question_, present_)) {
      if (group.size() <= kMostBodies) groups.insert(group);
    }
    std::vector<BodyGroup> open;
    const int effort = std::min(kGroupEffort, question_.trial.efforts() - 1);
    for (const BodyGroup& group : groups) {
      if (mayLeave(group, false) && isOpen(group, effort)) open.push_back(group);
    }
    return askAll(std::move(open), effort);
  }

  BodyGroup unitOf(std::size_t body) const { return glissade::unitOf(body, question_.rules); }

  void addGroup(std::set<BodyGroup>& groups, const BodyGroup& one, const BodyGroup& other) const {
    if (!present_[other.front()] || one == other) return;
    BodyGroup both = one;
    both.insert(both.end(), other.begin(), other.end());
    std::sort(both.begin(), both.end());
    if (both.size() <= kFewBodies) groups.insert(std::move(both));
  }

  /// True if a body has left. The groups have no body in common. After a stop all answers are dropped, because a
  /// missing answer could have been a removal.
  bool ask(const std::vector<BodyGroup>& groups, int effort) {
    if (groups.empty()) return false;
    host_.asking(groups, effort);
    std::vector<RemovalAnswer> answers(groups.size());
    host_.team().run(groups.size(), [&](std::size_t i) {
      answers[i] = question_.trial.tryRemoval(groups[i], present_, effort, host_.stopToken());
    });
    const bool cut = std::any_of(answers.begin(), answers.end(), [](const RemovalAnswer& answer) {
      const auto* refused = std::get_if<Refused>(&answer);
      return refused != nullptr && refused->stopped;
    });
    if (cut) return false;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (const auto* removed = std::get_if<Removed>(&answers[i])) {
        waiting_[groups[i]] = makeMotion(groups[i], *removed, question_, present_, plan_.steps.size());
      } else {
        refusals_[groups[i]][effort] = {std::get<Refused>(answers[i]).blockedBy, plan_.steps.size()};
      }
    }
    return leave();
  }

  /// Bodies that fall if the group leaves now.
  BodyGroup fallingWithout(const BodyGroup& group) const {
    return question_.standing == nullptr ? BodyGroup() : question_.standing->newlyFalling(present_, group);
  }

  bool isFragile(const BodyGroup& group) const {
    return !question_.fragile.empty() &&
           std::any_of(group.begin(), group.end(), [&](std::size_t body) { return question_.fragile[body]; });
  }

  /// Sort key: smaller groups come first, and all groups of a task come with its smallest one.
  double sizeInOrder(const BodyGroup& group) const {
    if (isFragile(group)) return -1.0;
    const std::size_t task = taskOf(group);
    double size = volumeOf(group);
    for (const auto& [other, motion] : waiting_) {
      if (task != 0 && taskOf(other) == task && !isFragile(other)) size = std::min(size, volumeOf(other));
    }
    return size;
  }

  /// Number of the group's task; 0: no task.
  std::size_t taskOf(const BodyGroup& group) const {
    return question_.joints != nullptr && group.size() == 1 ? question_.joints->taskOf(group.front()) : 0;
  }

  /// Carries out known motions: fragile bodies first, then the smallest groups. A group whose removal lets bodies fall
  /// waits, because it may not do so after other groups have left. If all such removals let bodies fall, the one with
  /// the fewest falling bodies is carried out. False if no motion is known.
  bool leave() {
    if (waiting_.empty()) return false;
    ++wave_;
    std::vector<std::pair<double, BodyGroup>> bySize;
    for (const auto& [group, step] : waiting_) bySize.emplace_back(sizeInOrder(group), group);
    std::stable_sort(bySize.begin(), bySize.end(), [&](const auto& a, const auto& b) {
      return std::pair(a.first, taskOf(a.second)) < std::pair(b.first, taskOf(b.second));
    });
    const std::size_t before = plan_.steps.size();
    const BodyGroup* least = nullptr;  // group with the fewest falling bodies
    BodyGroup leastFalling;
    for (const auto& [volume, group] : bySize) {
      if (!isThere(group)) continue;
      if (isPlaceTaken()) break;  // the remaining groups wait
      BodyGroup falling = fallingWithout(group);
      if (falling.empty()) {
        carryOut(group, {});
        restOfStackLeaves(group);
      } else if (least == nullptr || falling.size() < leastFalling.size()) {
        least = &group;
        leastFalling = std::move(falling);
      }
    }
    if (plan_.steps.size() == before) {
      carryOut(*least, leastFalling);
      restOfStackLeaves(*least);
    }
    std::erase_if(waiting_, [&](const auto& each) { return !isThere(each.first); });
    announce();
    return true;
  }

  /// True if a person wants another step at the place that comes now.
  bool isPlaceTaken() const {
    return std::any_of(question_.rules.placed.begin(), question_.rules.placed.end(), [&](const auto& step) {
      return step.place == steps_ + 1 && isThere(step.group) && notAtPlace_.count(step.group) == 0;
    });
  }

  /// Counts the step of the group, which leaves now.
  void count(const BodyGroup& group) {
    steps_ = numberOfNext(group);
    last_ = group;
  }

  /// Number that the step of the group gets if it leaves now, as a person counts steps: a stack is one.
  std::size_t numberOfNext(const BodyGroup& group) const {
    return continuesStack(group, last_, question_.joints) ? steps_ : steps_ + 1;
  }

  /// Removes the other bodies of the group's fastener stack along lines, where a person counts places: a stack is one
  /// step. Else the order search brings the stack together.
  void restOfStackLeaves(const BodyGroup& group) {
    if (question_.rules.placed.empty()) return;
    for (bool hasLeft = true; hasLeft;) {
      hasLeft = false;
      for (const std::size_t body : stackOf(group)) {
        const bool mayBeAsked = !stopped() && present_[body] && unitOf(body).size() == 1 && mayLeave({body}, true);
        if (!mayBeAsked || !findLine({body})) continue;
        carryOut({body}, fallingWithout({body}));
        hasLeft = true;
      }
    }
  }

  /// True if a motion of the group is known, or a line is found.
  bool findLine(const BodyGroup& group) {
    if (waiting_.count(group) != 0) return true;
    if (!isOpen(group, 0)) return false;
    RemovalAnswer answer = question_.trial.tryRemoval(group, present_, 0, host_.stopToken());
    const auto* removed = std::get_if<Removed>(&answer);
    if (removed != nullptr) waiting_[group] = makeMotion(group, *removed, question_, present_, plan_.steps.size());
    return removed != nullptr;
  }

  void carryOut(const BodyGroup& group, const BodyGroup& falling) {
    count(group);
    present_ = without(present_, group);
    StepMotion motion = waiting_[group];
    motion.falling = idsOf(falling);
    question_.trial.learn(group, motion.path);
    plan_.steps.push_back({{std::move(motion)}, wave_});
  }

  bool isThere(const BodyGroup& group) const {
    return std::all_of(group.begin(), group.end(), [&](std::size_t body) { return present_[body]; });
  }

  double volumeOf(const BodyGroup& group) const {
    double volume = 0.0;
    for (const std::size_t body : group) volume += volumes_[body];
    return volume;
  }

  void finish() {
    for (const auto& [group, byEffort] : refusals_) addRefusals(group, byEffort, plan_);
    for (const auto& [group, motion] : waiting_) plan_.waiting.push_back(motion);
    bool complete = true;
    for (const std::size_t body : bodiesIn(present_)) {
      if (question_.staying[body]) continue;
      complete = false;
      if (waiting_.count(unitOf(body)) == 0) addStuck(body);
    }
    if (!complete) plan_.end = stopped() ? PlanEnd::Interrupted : PlanEnd::Stuck;
  }

  /// Adds the refusals of groups that are still there.
  void addRefusals(const BodyGroup& group, const std::map<int, Refusal>& byEffort, AssemblyPlan& plan) const {
    if (!isThere(group)) return;
    for (const auto& [effort, refusal] : byEffort) {
      plan.refusals.push_back({idOf(group.front()), effort, refusal.afterSteps, idsOf(refusal.blockedBy),
                               idsOf({group.begin() + 1, group.end()})});
    }
  }

  /// A body for which no removal was searched is not stuck, unless a person forbids it to leave.
  void addStuck(std::size_t body) {
    const BodyGroup unit = unitOf(body);
    const auto refusedThere = notAtPlace_.find(unit);
    if (refusedThere != notAtPlace_.end()) {
      const Refusal& refusal = refusedThere->second;
      plan_.stuck.push_back({idOf(body), idsOf(refusal.blockedBy),
                             GLISSADE_TEXT("no motion was found at the place that a constraint gives it")});
      return;
    }
    const std::vector<std::size_t> holding = heldBy(unit, false);
    std::set<std::size_t> blocking(holding.begin(), holding.end());
    const auto refused = refusals_.find(unit);
    if (refused == refusals_.end() && holding.empty()) return;
    if (refused != refusals_.end()) {
      for (const auto& [effort, refusal] : refused->second) {
        for (const std::size_t other : refusal.blockedBy) {
          if (present_[other]) blocking.insert(other);
        }
      }
    }
    const StuckReasons reasons(question_, present_, refusals_, host_.stopToken());
    plan_.stuck.push_back({idOf(body), idsOf({blocking.begin(), blocking.end()}), reasons.of(body, holding, blocking)});
  }

  const SequenceQuestion& question_;
  SequenceHost& host_;
  BodySet present_;
  BodySet placed_;                           ///< bodies that have a demanded place
  std::map<BodyGroup, Refusal> notAtPlace_;  ///< steps that were refused at their place
  std::vector<double> volumes_;              ///< box volumes of the bodies
  std::vector<BodyGroup> clusters_;          ///< see clustersOf()
  Refusals refusals_;
  std::map<BodyGroup, StepMotion> waiting_;  ///< motions that are known and not yet carried out
  std::size_t wave_ = 0;
  std::size_t steps_ = 0;  ///< number of steps as a person counts them: a stack is one
  BodyGroup last_;         ///< bodies of the last motion
  AssemblyPlan plan_;
};

}  // namespace

AssemblyPlan GreedyStrategy::plan(const SequenceQuestion& question, SequenceHost& host) {
  AssemblyPlan plan = GreedySearch(question, host).run();
  plan.strategy = "greedy";
  addPrecedence(plan, question, host);
  return plan;
}

}  // namespace glissade
