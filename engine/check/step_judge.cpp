#include "engine/check/step_judge.h"

#include <algorithm>
#include <limits>

#include "engine/base/parameters.h"
#include "engine/check/pulled_thread.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

/// Bodies farther from a sweep than this share of the moving body's radius are not looked at more closely.
constexpr double kNearShare = 0.1;

double usual(const Body& body, ParameterId id) { return ParameterValues(radiusAboutOrigin(*body.mesh))[id]; }

/// Holds all places of a frame's origin, and of points that are so near to it.
Box3 sweepOf(const std::vector<Pose>& path, double reach) {
  Box3 box;
  for (const Pose& q : path) box.extend(q.position);
  return {box.min() - Vector3::Constant(reach), box.max() + Vector3::Constant(reach)};
}

class StepJudge {
 public:
  StepJudge(const NumberedStep& numbered, const StepTools& tools)
      : product_(tools.product),
        numbered_(numbered),
        placed_(tools.placed),
        prepared_(tools.prepared),
        watch_(tools.watch) {
    required_ = std::numeric_limits<double>::infinity();
    for (const std::size_t body : numbered.group) {
      required_ = std::min(required_, usual(product_.bodies[body], ParameterId::RequiredClearance));
    }
    if (tools.required) required_ = *tools.required;
  }

  StepVerdict judge() {
    StepVerdict verdict{numbered_.step->bodies, {}, true, "", {}, numbered_.wrong};
    verdict.isFlexible = numbered_.step->flexible;
    if (numbered_.group.empty()) return verdict;
    checkNames(verdict);
    if (verdict.isFlexible) return verdict;
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
      if (!each.isAbout(own.id, other.id, numbered_.step->bodies.front()) || each.allowance <= 0.0) continue;
      AppliedAllowance refused{own.id, other.id, own.name, other.name};
      refused.stated = each.allowance;
      if (each.yields) std::swap(refused.thinner, refused.against);
      verdict.refusals.push_back(allowanceRefused(refused, why));
    }
  }

  /// By an allowance or by a joint of the step.
  bool isCalledThread(const PairQuestion& asked) const {
    const auto isThreadOfPair = [&](const StatedAllowance& each) {
      return each.isThread && each.isAbout(asked.moving.id, asked.other.id, asked.first);
    };
    const auto isPair = [&](const std::pair<std::string, std::string>& pair) {
      return std::minmax(pair.first, pair.second) == std::minmax(asked.moving.id, asked.other.id);
    };
    const auto& turned = numbered_.step->turned;
    return std::any_of(asked.stated->begin(), asked.stated->end(), isThreadOfPair) ||
           std::any_of(turned.begin(), turned.end(), isPair);
  }

  /// A thread comes apart by turning. What a person marks as one, and what is taken away, is judged with the motion.
  void judgeThread(const PairQuestion& asked, const PairFit& fit, StepVerdict& verdict) const {
    if (fit.thread || !product_.fits.on) return;
    const bool isCalled = isCalledThread(asked);
    if (!isCalled && !fit.isThinned()) return;
    double overlap = 0.0;
    for (const AppliedAllowance& each : fit.applied) overlap = std::max(overlap, each.evidence.overlap);
    const std::string pulled =
        pulledThread({placed_.at({asked.moving, asked.moving.X_WB}), placed_.at({asked.other, asked.other.X_WB}),
                      asked.path, overlap, isCalled});
    if (pulled.empty()) return;
    const std::string what =
        "'" + asked.moving.name + "' is pulled off '" + asked.other.name + "' without a turn: " + pulled;
    std::string may = product_.fits.partingOf(asked.moving.id, asked.other.id);
    if (may.empty() && fit.acceptedClash) may = "a person accepts their clash";
    if (asked.moving.mesh->faces.empty() || asked.other.mesh->faces.empty()) may = "their meshes state no cylinders";
    (may.empty() ? verdict.refusals : verdict.pulls).push_back(what + (may.empty() ? "" : "; " + may));
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
      judgeThread(asked, pair.fit, verdict);
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

}  // namespace

StepVerdict judgeStep(const NumberedStep& numbered, const StepTools& tools) {
  return StepJudge(numbered, tools).judge();
}

}  // namespace glissade::check
