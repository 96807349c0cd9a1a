#include "engine/check/plan_verdict.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <mutex>
#include <set>
#include <thread>

#include "engine/base/parameters.h"
#include "engine/base/thread_team.h"
#include "engine/check/path_verdict.h"
#include "engine/check/plan_demands.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

/// Bodies farther from a sweep than this share of the moving body's radius are not looked at more closely.
constexpr double kNearShare = 0.1;

/// A step by numbers of bodies.
struct NumberedStep {
  const Step* step = nullptr;
  Group group{};
  Present there{};       ///< in the order of the plan
  Present mayBeThere{};  ///< in any order that keeps what has to be carried out before
  std::vector<std::string> wrong{};
};

void takeAway(const Group& group, Present& present) {
  for (const std::size_t body : group) present[body] = false;
}

/// Numbers of the steps that are carried out before, in whatever order.
std::set<std::size_t> predecessorsOf(std::size_t number, const std::vector<std::set<std::size_t>>& earlier,
                                     NumberedStep& numbered) {
  std::set<std::size_t> before;
  for (const std::size_t each : numbered.step->after) {
    if (each == 0 || each >= number) {
      numbered.wrong.push_back("it is after step " + std::to_string(each) + ", which is not an earlier one");
      continue;
    }
    before.insert(each);
    before.insert(earlier[each - 1].begin(), earlier[each - 1].end());
  }
  return before;
}

void numberBodies(const Product& product, const Plan& plan, Present& left, NumberedStep& numbered) {
  for (const std::string& id : numbered.step->bodies) {
    const auto body =
        std::find_if(product.bodies.begin(), product.bodies.end(), [&](const Body& each) { return each.id == id; });
    const bool stays = std::find(plan.staying.begin(), plan.staying.end(), id) != plan.staying.end();
    if (body == product.bodies.end()) {
      numbered.wrong.push_back("it moves '" + id + "', which is not a body of the product");
      continue;
    }
    const auto index = static_cast<std::size_t>(body - product.bodies.begin());
    if (stays) numbered.wrong.push_back("it moves '" + id + "', which is said to stay");
    if (left[index]) numbered.wrong.push_back("it moves '" + id + "', which has left before");
    left[index] = true;
    numbered.group.push_back(index);
  }
  if (numbered.step->bodies.empty()) numbered.wrong.emplace_back("it moves no body");
  if (!numbered.step->certified) numbered.wrong.emplace_back("it says that it is not certified");
  std::sort(numbered.group.begin(), numbered.group.end());
}

std::vector<NumberedStep> numberedSteps(const Product& product, const Plan& plan) {
  std::vector<NumberedStep> steps;
  std::vector<std::set<std::size_t>> before;
  Present there(product.bodies.size(), true);
  Present left(product.bodies.size(), false);
  for (const Step& step : plan.steps) {
    NumberedStep numbered{&step, {}, there, Present(product.bodies.size(), true), {}};
    numberBodies(product, plan, left, numbered);
    before.push_back(predecessorsOf(steps.size() + 1, before, numbered));
    for (const std::size_t each : before.back()) takeAway(steps[each - 1].group, numbered.mayBeThere);
    takeAway(numbered.group, there);
    steps.push_back(std::move(numbered));
  }
  return steps;
}

double usual(const Body& body, ParameterId id) { return ParameterValues(radiusAboutOrigin(*body.mesh))[id]; }

/// Holds all places of a frame's origin, and of points that are so near to it.
Box3 sweepOf(const std::vector<Pose>& path, double reach) {
  Box3 box;
  for (const Pose& q : path) box.extend(q.position);
  return {box.min() - Vector3::Constant(reach), box.max() + Vector3::Constant(reach)};
}

class StepJudge {
 public:
  StepJudge(const Product& product, const NumberedStep& numbered, std::optional<double> required, PlacedBodies& placed,
            MotionBodies& prepared, const WorkWatch& watch)
      : product_(product), numbered_(numbered), placed_(placed), prepared_(prepared), watch_(watch) {
    required_ = std::numeric_limits<double>::infinity();
    for (const std::size_t body : numbered.group) {
      required_ = std::min(required_, usual(product.bodies[body], ParameterId::RequiredClearance));
    }
    if (required) required_ = *required;
  }

  StepVerdict judge() {
    StepVerdict verdict{numbered_.step->bodies, {}, true, "", {}, numbered_.wrong};
    if (numbered_.group.empty()) return verdict;
    checkNames(verdict);
    const std::vector<Pose> path = configurationsOf(numbered_.step->path);
    Box3 others;
    for (std::size_t body = 0; body < product_.bodies.size(); ++body) {
      const bool counts =
          numbered_.there[body] && !std::binary_search(numbered_.group.begin(), numbered_.group.end(), body);
      if (counts) others.extend(boundingBox(*product_.bodies[body].mesh, product_.bodies[body].X_WB));
    }
    bool first = true;
    for (const std::size_t body : numbered_.group) {
      const Body& own = product_.bodies[body];
      const Pose end = path.back() * inverse(path.front()) * own.X_WB;
      const bool outside = others.isEmpty() || !others.intersects(boundingBox(*own.mesh, end));
      verdict.endsOutside = verdict.endsOutside && outside;
      const JudgedMotion motion = judgeBody(body, path, verdict);
      const bool certified = motion.verdict.status == Status::Certified;
      if (first || !certified || motion.verdict.minClearance < verdict.motion.verdict.minClearance) {
        verdict.motion = motion;
      }
      first = false;
      if (!certified) break;
    }
    return verdict;
  }

 private:
  bool isInStep(const std::string& id) const {
    const auto& ids = numbered_.step->bodies;
    return id.empty() || std::find(ids.begin(), ids.end(), id) != ids.end();
  }

  /// An allowance for bodies that do not meet is about nothing.
  void checkNames(StepVerdict& verdict) const {
    for (const StatedAllowance& each : numbered_.step->allowances) {
      const bool known = std::any_of(product_.bodies.begin(), product_.bodies.end(),
                                     [&](const Body& body) { return body.id == each.body; });
      if (known && isInStep(each.moving)) continue;
      verdict.refusals.push_back("it states an allowance of '" + each.moving + "' against '" + each.body +
                                 "', which are not a body of the step and one of the product");
    }
  }

  /// What the step states for a pair that is not compared.
  void refuseStated(const Body& own, const Body& other, const char* why, StepVerdict& verdict) const {
    for (const StatedAllowance& each : numbered_.step->allowances) {
      const std::string& moving = each.moving.empty() ? numbered_.step->bodies.front() : each.moving;
      if (moving != own.id || each.body != other.id || each.allowance <= 0.0) continue;
      AppliedAllowance refused{own.id, other.id, own.name, other.name};
      refused.stated = each.allowance;
      if (each.yields) std::swap(refused.thinner, refused.against);
      verdict.refusals.push_back(allowanceRefused(refused, why));
    }
  }

  JudgedMotion judgeBody(std::size_t body, const std::vector<Pose>& path, StepVerdict& verdict) const {
    const Body& own = product_.bodies[body];
    const Pose X_PB = inverse(path.front()) * own.X_WB;
    MotionQuestion motion{own, X_PB, path, {}, {}};
    motion.demands = demandsOf(numbered_.step->path, required_, usual(own, ParameterId::ContactGap));
    const Box3 sweep = sweepOf(path, radiusAboutOrigin(transformed(*own.mesh, X_PB)));
    const double near = std::max(kNearShare * radiusAboutOrigin(*own.mesh), 4.0 * required_);
    const std::optional<std::vector<StatedAllowance>> stated = numbered_.step->allowances;
    double leastOfFar = std::numeric_limits<double>::infinity();
    std::vector<Pose> ofBody;
    for (const Pose& q : path) ofBody.push_back(q * X_PB);
    for (std::size_t other = 0; other < product_.bodies.size(); ++other) {
      const bool moves = std::binary_search(numbered_.group.begin(), numbered_.group.end(), other);
      if (watch_.stop.stopRequested()) continue;
      const Body& obstacle = product_.bodies[other];
      if (!numbered_.mayBeThere[other] || moves) {
        refuseStated(own, obstacle, moves ? "they leave together" : "the other one has left before", verdict);
        continue;
      }
      const double apart = sweep.exteriorDistance(boundingBox(*obstacle.mesh, obstacle.X_WB));
      if (apart > near) {
        leastOfFar = std::min(leastOfFar, apart);
        refuseStated(own, obstacle, "they are apart", verdict);
        continue;
      }
      const PairQuestion asked{own, obstacle, {own.X_WB}, stated, numbered_.step->bodies.front(), ofBody};
      MotionPair pair{other, &obstacle, fitOf(asked, product_.fits, placed_, watch_.stop)};
      verdict.allowances.insert(verdict.allowances.end(), pair.fit.applied.begin(), pair.fit.applied.end());
      verdict.refusals.insert(verdict.refusals.end(), pair.fit.refusals.begin(), pair.fit.refusals.end());
      motion.pairs.push_back(std::move(pair));
    }
    JudgedMotion judged = judgeMotion(motion, prepared_, WorkWatch(watch_.stop));
    judged.verdict.minClearance = std::min(judged.verdict.minClearance, leastOfFar);
    judged.verdict.provedClearance = std::min(judged.verdict.provedClearance, leastOfFar);
    return judged;
  }

  const Product& product_;
  const NumberedStep& numbered_;
  PlacedBodies& placed_;
  MotionBodies& prepared_;
  const WorkWatch& watch_;
  double required_ = 0.0;
};

/// The two largest, together.
double largestTwo(const Product& product) {
  std::vector<double> values(2, 0.0);
  for (const Body& body : product.bodies) values.push_back(deflectionOf(body));
  std::partial_sort(values.begin(), values.begin() + 2, values.end(), std::greater<>());
  return values[0] + values[1];
}

}  // namespace

std::size_t PlanVerdict::validSteps() const {
  return static_cast<std::size_t>(
      std::count_if(steps.begin(), steps.end(), [](const StepVerdict& step) { return step.valid(); }));
}

PlanVerdict judgePlan(const Product& product, const Plan& plan, std::optional<double> required,
                      const WorkWatch& watch) {
  PlanVerdict verdict;
  verdict.refusals = wrongClaims(product, plan);
  verdict.deviation = largestTwo(product);
  const std::vector<NumberedStep> steps = numberedSteps(product, plan);
  std::size_t removed = 0;
  for (const NumberedStep& step : steps) removed += step.group.size();
  verdict.parts = plan.bodies.size() - std::min(plan.bodies.size(), plan.staying.size());
  verdict.remaining = verdict.parts - std::min(verdict.parts, removed);
  verdict.steps.resize(steps.size());
  PlacedBodies placed;
  MotionBodies prepared(product.bodies);
  ThreadTeam team(std::max(1U, std::thread::hardware_concurrency()) - 1);
  std::mutex mutex;
  std::size_t judged = 0;
  team.run(steps.size(), [&](std::size_t i) {
    verdict.steps[i].bodies = steps[i].step->bodies;
    verdict.steps[i].motion.why = "the check was stopped";
    if (watch.stop.stopRequested()) return;
    verdict.steps[i] = StepJudge(product, steps[i], required, placed, prepared, watch).judge();
    for (const Demands* demands : {&plan.demands, &product.demands}) {
      if (!verdict.steps[i].againstDemand.empty()) continue;
      verdict.steps[i].againstDemand =
          againstDemands(*steps[i].step, steps[i].group, steps[i].there, i + 1, product, *demands);
    }
    const std::lock_guard lock(mutex);
    watch.report(static_cast<double>(++judged) / static_cast<double>(steps.size()));
  });
  return verdict;
}

}  // namespace glissade::check
