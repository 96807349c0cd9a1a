#include "engine/sequence/greedy_strategy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace glissade {
namespace {

/// Bodies that are searched at the same time, whatever the number of threads.
constexpr std::size_t kSearchedTogether = 4;

class GreedySearch {
 public:
  GreedySearch(const SequenceQuestion& question, SequenceHost& host)
      : question_(question),
        host_(host),
        present_(question.product.bodies.size(), true),
        refusals_(question.product.bodies.size()) {
    for (auto& ofBody : refusals_) ofBody.resize(static_cast<std::size_t>(question.trial.efforts()));
    plan_.seed = question.seed;
    for (std::size_t body = 0; body < present_.size(); ++body) {
      plan_.bodies.push_back(idOf(body));
      if (question.staying[body]) plan_.staying.push_back(idOf(body));
    }
    if (question.resumed != nullptr) resume(*question.resumed);
  }

  AssemblyPlan run() {
    while (!stopped() && wave()) {
    }
    finish();
    return std::move(plan_);
  }

 private:
  struct Refusal {
    std::vector<std::size_t> blockedBy;
    std::size_t afterSteps = 0;
  };

  const std::string& idOf(std::size_t body) const { return question_.product.bodies[body].id; }
  bool stopped() const { return host_.stopToken().stopRequested(); }

  std::vector<std::string> idsOf(const std::vector<std::size_t>& bodies) const {
    std::vector<std::string> ids;
    for (const std::size_t body : bodies) ids.push_back(idOf(body));
    return ids;
  }

  void resume(const AssemblyPlan& earlier) {
    for (const AssemblyStep& step : earlier.steps) {
      const std::size_t body = *question_.product.indexOf(step.body);
      plan_.steps.push_back(step);
      present_[body] = false;
      wave_ = step.wave;
      question_.trial.learn(body, step.path);
    }
    for (const RefusedRemoval& refused : earlier.refusals) {
      Refusal refusal{{}, refused.afterSteps};
      for (const std::string& id : refused.blockedBy) refusal.blockedBy.push_back(*question_.product.indexOf(id));
      refusals_[*question_.product.indexOf(refused.body)][static_cast<std::size_t>(refused.effort)] = refusal;
    }
  }

  /// False where nothing is left to ask.
  bool wave() {
    for (int effort = 0; effort < question_.trial.efforts(); ++effort) {
      std::vector<std::size_t> open = bodiesToAsk(effort);
      const std::size_t together = effort == 0 ? open.size() : kSearchedTogether;
      for (std::size_t first = 0; first < open.size(); first += together) {
        const std::size_t last = std::min(first + together, open.size());
        if (ask({open.begin() + static_cast<std::ptrdiff_t>(first), open.begin() + static_cast<std::ptrdiff_t>(last)},
                effort)) {
          return true;
        }
        if (stopped()) return false;
      }
    }
    return false;
  }

  std::vector<std::size_t> bodiesToAsk(int effort) const {
    std::vector<std::size_t> open;
    for (const std::size_t body : bodiesIn(present_)) {
      if (!question_.staying[body] && isOpen(body, effort)) open.push_back(body);
    }
    return open;
  }

  bool isOpen(std::size_t body, int effort) const {
    const auto& refusal = refusals_[body][static_cast<std::size_t>(effort)];
    return !refusal || std::any_of(refusal->blockedBy.begin(), refusal->blockedBy.end(),
                                   [&](std::size_t other) { return !present_[other]; });
  }

  /// True where a body has left. After a stop all answers are dropped: what is missing could have left as well.
  bool ask(const std::vector<std::size_t>& bodies, int effort) {
    host_.asking(bodies.size(), effort);
    std::vector<RemovalAnswer> answers(bodies.size());
    host_.team().run(bodies.size(), [&](std::size_t i) {
      answers[i] = question_.trial.tryRemoval(bodies[i], present_, effort, host_.stopToken());
    });
    const bool cut = std::any_of(answers.begin(), answers.end(), [](const RemovalAnswer& answer) {
      const auto* refused = std::get_if<Refused>(&answer);
      return refused != nullptr && refused->stopped;
    });
    if (cut) return false;
    std::vector<std::pair<std::size_t, const Removed*>> leaving;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (const auto* removed = std::get_if<Removed>(&answers[i])) {
        leaving.emplace_back(bodies[i], removed);
      } else {
        refusals_[bodies[i]][static_cast<std::size_t>(effort)] =
            Refusal{std::get<Refused>(answers[i]).blockedBy, plan_.steps.size()};
      }
    }
    leave(leaving);
    return !leaving.empty();
  }

  void leave(std::vector<std::pair<std::size_t, const Removed*>>& leaving) {
    if (leaving.empty()) return;
    ++wave_;
    const auto& bodies = question_.product.bodies;
    std::stable_sort(leaving.begin(), leaving.end(), [&](const auto& a, const auto& b) {
      return boxVolume(bodies[a.first]) < boxVolume(bodies[b.first]);
    });
    const std::size_t before = plan_.steps.size();
    for (const auto& [body, removed] : leaving) {
      present_[body] = false;
      plan_.steps.push_back(stepOf(body, *removed, before));
      question_.trial.learn(body, removed->path.points);
    }
    host_.stepFound(plan_);
  }

  AssemblyStep stepOf(std::size_t body, const Removed& removed, std::size_t afterSteps) const {
    const MotionCertificate& certificate = removed.path.certificate;
    AssemblyStep step{idOf(body), removed.path.points, removed.method, wave_, {}, {}};
    step.proof = {afterSteps, certificate.tolerance, certificate.provedClearance, certificate.minClearance, {}};
    if (certificate.nearest.body >= 0) step.proof.nearest = idOf(static_cast<std::size_t>(certificate.nearest.body));
    for (const Fit& fit : removed.fits) {
      const RigidBody& other = question_.product.bodies[fit.obstacle];
      const RigidBody& own = question_.product.bodies[body];
      StepAllowance allowance{other.id, fit.kind, fit.overlap, fit.allowance, inWords(fit, own.name, other.name)};
      if (fit.thread) {
        allowance.pitch = fit.thread->rule.pitch;
        allowance.turns = std::abs(
            turnsWhileEngaged(ThreadPair(fit.thread->rule, *own.mesh, other), configurationsOf(removed.path.points)));
        allowance.text += turnsInWords(allowance.turns);
      }
      step.allowances.push_back(std::move(allowance));
    }
    return step;
  }

  void finish() {
    bool complete = true;
    for (const std::size_t body : bodiesIn(present_)) {
      if (question_.staying[body]) continue;
      complete = false;
      addRefusals(body);
    }
    if (!complete) plan_.end = stopped() ? PlanEnd::Interrupted : PlanEnd::Stuck;
  }

  /// A body that was never asked is not stuck.
  void addRefusals(std::size_t body) {
    bool asked = false;
    std::set<std::size_t> blocking;
    for (std::size_t effort = 0; effort < refusals_[body].size(); ++effort) {
      const auto& refusal = refusals_[body][effort];
      if (!refusal) continue;
      asked = true;
      plan_.refusals.push_back({idOf(body), static_cast<int>(effort), refusal->afterSteps, idsOf(refusal->blockedBy)});
      for (const std::size_t other : refusal->blockedBy) {
        if (present_[other]) blocking.insert(other);
      }
    }
    if (asked) plan_.stuck.push_back({idOf(body), idsOf({blocking.begin(), blocking.end()})});
  }

  const SequenceQuestion& question_;
  SequenceHost& host_;
  BodySet present_;
  std::vector<std::vector<std::optional<Refusal>>> refusals_;  ///< of each body, by effort
  std::size_t wave_ = 0;
  AssemblyPlan plan_;
};

}  // namespace

AssemblyPlan GreedyStrategy::plan(const SequenceQuestion& question, SequenceHost& host) {
  AssemblyPlan plan = GreedySearch(question, host).run();
  plan.strategy = "greedy";
  return plan;
}

}  // namespace glissade
