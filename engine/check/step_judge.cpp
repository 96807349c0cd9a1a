#include "engine/check/step_judge.h"

#include <algorithm>
#include <limits>

#include "engine/base/parameters.h"
#include "engine/check/evidence_names.h"
#include "engine/check/pair_work.h"
#include "engine/check/standard_pitch.h"
#include "engine/check/stated_numbers.h"
#include "engine/check/verdict_words.h"
#include "engine/evidence/pulled_thread.h"

namespace glissade::check {
namespace {

/// Largest difference between the pitch of a motion and that of a modelled helix, as a share of the latter.
constexpr double kModelledPitchShare = 0.05;
/// Bodies farther from a sweep than this share of the moving body's radius are not looked at more closely.
constexpr double kNearShare = 0.1;

double usual(const Body& body, ParameterId id) { return ParameterValues(radiusAboutOrigin(*body.mesh))[id]; }

/// A box of all places of a frame's origin, and of points within `reach` of it.
Box3 sweepOf(const std::vector<Pose>& path, double reach) {
  Box3 box;
  for (const Pose& q : path) box.extend(q.position);
  return {box.min() - Vector3::Constant(reach), box.max() + Vector3::Constant(reach)};
}

/// The motion of one body of a step.
struct BodyMotion {
  JudgedMotion judged{};
  double met = std::numeric_limits<double>::infinity();  ///< metres: upper bound on the smallest distance to a body
  bool isMetThere = false;                               ///< that body is there in the order of the list
};

class StepJudge {
 public:
  StepJudge(const NumberedStep& numbered, const StepTools& tools)
      : product_(tools.product),
        plan_(tools.plan),
        numbered_(numbered),
        placed_(tools.placed),
        prepared_(tools.prepared),
        watch_(tools.watch) {
    required_ = std::numeric_limits<double>::infinity();
    for (const std::size_t body : numbered.group) {
      required_ = std::min(required_, usual(product_.bodies[body], ParameterId::RequiredClearance));
    }
    if (tools.required) required_ = *tools.required;
    isRequiredGiven_ = tools.required.has_value();
  }

  StepVerdict judge() {
    StepVerdict verdict{numbered_.step->bodies, {}, true, {}, {}, numbered_.wrong};
    verdict.isFlexible = numbered_.step->flexible;
    verdict.number = numbered_.step->number;
    verdict.motionNumber = numbered_.step->motion;
    if (numbered_.group.empty()) return verdict;
    checkNames(verdict);
    noteRules(verdict);
    if (verdict.isFlexible) {
      judgeFlexible(verdict);
      compareNumbers(std::numeric_limits<double>::infinity(), verdict);
      return verdict;
    }
    const std::vector<Pose> path = configurationsOf(numbered_.step->path);
    Box3 others;
    for (std::size_t body = 0; body < product_.bodies.size(); ++body) {
      const bool counts =
          numbered_.there[body] && !std::binary_search(numbered_.group.begin(), numbered_.group.end(), body);
      if (counts) others.extend(boundingBox(*product_.bodies[body].mesh, product_.bodies[body].X_WB));
    }
    bool first = true;
    double farthest = std::numeric_limits<double>::infinity();
    for (const std::size_t body : numbered_.group) {
      const Body& own = product_.bodies[body];
      const Pose end = path.back() * inverse(path.front()) * own.X_WB;
      const bool outside = others.isEmpty() || !others.intersects(boundingBox(*own.mesh, end));
      verdict.endsOutside = verdict.endsOutside && outside;
      const BodyMotion found = judgeBody(body, path, verdict);
      const JudgedMotion& motion = found.judged;
      farthest = std::min(farthest, found.isMetThere ? found.met : farthestFromThere(body));
      const bool certified = motion.verdict.status == Status::Certified;
      if (first || !certified || motion.verdict.minClearance < verdict.motion.verdict.minClearance) {
        verdict.motion = motion;
      }
      first = false;
      if (!certified) break;
    }
    if (verdict.certified()) compareNumbers(farthest, verdict);
    return verdict;
  }

 private:
  bool isInStep(const BodyId& id) const {
    const auto& ids = numbered_.step->bodies;
    return id.empty() || std::find(ids.begin(), ids.end(), id) != ids.end();
  }

  /// Refuses allowances whose bodies are not a body of the step and one of the product.
  void checkNames(StepVerdict& verdict) const {
    for (const StatedAllowance& each : numbered_.step->allowances) {
      if (product_.find(each.body) != nullptr && isInStep(each.moving)) continue;
      verdict.refusals.push_back({GLISSADE_TEXT("it states an allowance of '%1' against '%2', which are not a body of "
                                                "the step and one of the product"),
                                  {each.moving.text(), each.body.text()}});
    }
  }

  /// Refuses the allowances that the step states for a pair that is not compared.
  void refuseStated(const Body& own, const Body& other, CatalogueText why, StepVerdict& verdict) const {
    for (const StatedAllowance& each : numbered_.step->allowances) {
      if (!each.isAbout(own.id, other.id, numbered_.step->bodies.front()) || each.allowance <= 0.0) continue;
      AppliedAllowance refused{own.id, other.id, own.name, other.name};
      refused.stated = each.allowance;
      if (each.yields) std::swap(refused.thinner, refused.against);
      verdict.refusals.push_back(allowanceRefused(refused, why));
    }
  }

  /// `farthest`: see NumbersQuestion::farthest.
  void compareNumbers(double farthest, StepVerdict& verdict) const {
    const std::optional<double> required = isRequiredGiven_ ? std::nullopt : std::optional(required_);
    const auto wrong = wrongNumbers({numbered_, verdict, product_, required, farthest, placed_});
    verdict.refusals.insert(verdict.refusals.end(), wrong.begin(), wrong.end());
  }

  void judgeFlexible(StepVerdict& verdict) const {
    const BodyId& id = numbered_.step->bodies.front();
    const auto& said = product_.joints.flexible;
    if (std::find(said.begin(), said.end(), id) != said.end()) return;
    verdict.conditions.push_back(isFlexible(product_.bodies[numbered_.group.front()].name));
  }

  /// Notes broken rules that no person demands: the judge does not know them.
  void noteRules(StepVerdict& verdict) const {
    if (numbered_.step->motion > 1) return;  // the first motion of the step has them
    for (const StatedViolation& each : numbered_.step->violates) {
      if (each.rule == "before" || each.rule == "place") continue;
      std::vector<std::string> names;
      for (const BodyId& id : each.bodies) names.push_back(product_.nameOf(id));
      verdict.notes.push_back(
          {GLISSADE_TEXT("it says that it does not keep the rule \"%1\" about %2"), {each.rule, namesInWords(names)}});
    }
  }

  /// Upper bound on the distance of the body, at the beginning, from the nearest body that is there, metres.
  double farthestFromThere(std::size_t body) const {
    const Body& own = product_.bodies[body];
    const Box3 box = boundingBox(*own.mesh, own.X_WB);
    double farthest = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < product_.bodies.size(); ++other) {
      if (!numbered_.there[other] || std::binary_search(numbered_.group.begin(), numbered_.group.end(), other))
        continue;
      const Box3 others = boundingBox(*product_.bodies[other].mesh, product_.bodies[other].X_WB);
      const double reach = box.diagonal().norm() + others.diagonal().norm();
      farthest = std::min(farthest, box.exteriorDistance(others) + reach);
    }
    return farthest;
  }

  /// The pair as the step states it. What only the plan says of it, that its clash is accepted or which body is cut,
  /// becomes a condition of the verdict.
  PairFit takenFit(const PairQuestion& asked, StepVerdict& verdict) const {
    PairFit byPersons = fitOf(asked, product_.fits, placed_, watch_.stop);
    if (byPersons.refusals.empty() || !product_.fits.on) return byPersons;
    if (auto fit = withItsClash(product_.fits, asked, verdict)) return std::move(*fit);
    if (const Body* cut = cutByPlan(asked)) {
      FitWords words = product_.fits;
      words.cut.push_back(cut->id.text());
      PairFit byCut = fitOf(asked, words, placed_, watch_.stop);
      std::optional<PairFit> fit = byCut.refusals.empty() ? std::move(byCut) : withItsClash(words, asked, verdict);
      if (fit) {
        verdict.conditions.push_back(isTheOneCut(cut->name, idAsOption(cut->id)));
        return std::move(*fit);
      }
    }
    return byPersons;
  }

  /// The refused pair, with the clash accepted that the step states: the verdict gets a condition. Nothing: it is
  /// refused all the same.
  std::optional<PairFit> withItsClash(FitWords words, const PairQuestion& asked, StepVerdict& verdict) const {
    double claimed = 0.0;
    for (const StatedAllowance& each : *asked.stated) {
      if (each.isAbout(asked.moving.id, asked.other.id, asked.first)) claimed = std::max(claimed, each.allowance);
    }
    const double byPerson = words.acceptedClash;
    words.acceptedClash = std::max(byPerson, (1.0 + kEstimate) * claimed);
    PairFit accepted = fitOf(asked, words, placed_, watch_.stop);
    if (!accepted.refusals.empty()) return std::nullopt;
    words.acceptedClash = std::max(byPerson, accepted.depth);
    const bool isEnough = fitOf(asked, words, placed_, watch_.stop).refusals.empty();
    verdict.conditions.push_back(clashIsAccepted(isEnough ? accepted.depth : (1.0 + kEstimate) * claimed));
    return accepted;
  }

  /// The body of the pair that the step says is cut; null: it says none, or a person names one of the two.
  const Body* cutByPlan(const PairQuestion& asked) const {
    const auto isNamed = [&](const Body& body) { return product_.fits.isCut(body.id); };
    if (isNamed(asked.moving) || isNamed(asked.other)) return nullptr;
    for (const StatedAllowance& each : *asked.stated) {
      const bool isHere = each.isAbout(asked.moving.id, asked.other.id, asked.first);
      if (isHere && each.hollow) return each.yields ? &asked.other : &asked.moving;
    }
    return nullptr;
  }

  /// The shortest end of the id that names no other body of the product; the id where there is none.
  std::string idAsOption(const BodyId& id) const {
    const std::string& whole = id.text();
    for (std::size_t slash = whole.rfind('/'); slash != std::string::npos && slash > 0;
         slash = whole.rfind('/', slash - 1)) {
      FitWords words;
      words.cut = {whole.substr(slash + 1)};
      const auto named = std::count_if(product_.bodies.begin(), product_.bodies.end(),
                                       [&](const Body& body) { return words.isCut(body.id); });
      if (named == 1) return words.cut.front();
    }
    return whole;
  }

  void judgeBends(const PairQuestion& asked, const PairFit& fit, StepVerdict& verdict) const {
    const bool bends =
        std::any_of(fit.applied.begin(), fit.applied.end(), [](const auto& each) { return each.bend > 0.0; });
    const SnapWord* snap = product_.fits.snapOf(asked.moving.id, asked.other.id);
    if (!bends || snap == nullptr || !snap->byPlan) return;
    verdict.conditions.push_back(hookBends(product_.nameOf(snap->hook), product_.nameOf(snap->edge), snap->bend));
  }

  /// A pitch or a hand that is unusual for a thread of this diameter needs a person's statement.
  void judgePitch(const PairQuestion& asked, const TurnedThread& thread, StepVerdict& verdict) const {
    const std::string& moving = asked.moving.name;
    const std::string& other = asked.other.name;
    if (const std::optional<double> said = pitchSaidOf(asked)) {
      if (std::abs(*said - thread.pitch) <= kThreadPlay * std::abs(*said)) return;
      verdict.conditions.push_back(hasOtherPitch(moving, other, thread.pitch, *said));
      return;
    }
    if (thread.modelled != 0.0) {
      if (std::abs(thread.modelled - thread.pitch) <= kModelledPitchShare * std::abs(thread.modelled)) return;
      verdict.refusals.push_back(
          {GLISSADE_TEXT("'%1' and '%2': the thread is modelled with a pitch of %3, and the motion has %4"),
           {moving, other, Length{thread.modelled}, Length{thread.pitch}}});
      return;
    }
    if (!isStandardPitch(thread.diameter, thread.pitch)) {
      verdict.conditions.push_back(hasPitch(moving, other, std::abs(thread.pitch), thread.diameter));
    }
    const bool isLeft = thread.pitch < 0.0;
    if (isLeft == (saysLeftHanded(moving) || saysLeftHanded(other))) return;
    verdict.conditions.push_back(isLeft ? isLeftHanded(moving, other) : isRightHanded(moving, other));
  }

  std::optional<double> pitchSaidOf(const PairQuestion& asked) const {
    const PairWord* word = product_.fits.about(asked.moving.id, asked.other.id);
    if (word != nullptr && word->pitch) return word->pitch;
    for (const JointWords::Pitch& each : product_.joints.pitches) {
      if (std::minmax(each.a, each.b) == std::minmax(asked.moving.id, asked.other.id)) return each.pitch;
    }
    return std::nullopt;
  }

  /// True if an allowance or a joint of the step calls the pair a thread.
  bool isCalledThread(const PairQuestion& asked) const {
    const auto isThreadOfPair = [&](const StatedAllowance& each) {
      return each.isThread && each.isAbout(asked.moving.id, asked.other.id, asked.first);
    };
    const auto isOfPair = [&](const StatedJoint& joint) {
      return joint.isScrewed() && std::any_of(joint.others.begin(), joint.others.end(), [&](const BodyId& other) {
               return std::minmax(joint.body, other) == std::minmax(asked.moving.id, asked.other.id);
             });
    };
    const auto& joints = numbered_.step->joints;
    return std::any_of(asked.stated->begin(), asked.stated->end(), isThreadOfPair) ||
           std::any_of(joints.begin(), joints.end(), isOfPair);
  }

  /// Checks that a thread comes apart by turning. Marked threads, and those that are taken away, are judged with the
  /// motion.
  void judgeThread(const PairQuestion& asked, const PairFit& fit, StepVerdict& verdict) const {
    if (!product_.fits.on) return;
    if (fit.thread) {
      const double diameter = 2.0 * std::max(fit.thread->radiusMoving, fit.thread->radiusOther);
      if (!fit.core) judgePitch(asked, {fit.thread->pitch, diameter}, verdict);
      return;
    }
    const bool isCalled = isCalledThread(asked);
    if (!isCalled && !fit.isThinned()) return;
    double overlap = 0.0;
    for (const AppliedAllowance& each : fit.applied) overlap = std::max(overlap, each.evidence.overlap);
    const std::vector<CommonThread> threads =
        commonThreads({placed_.at({asked.moving, asked.moving.X_WB}), placed_.at({asked.other, asked.other.X_WB}),
                       overlap, isCalled, fit.inSolid ? &*fit.inSolid : nullptr, asked.moving.name, asked.other.name},
                      watch_.stop);
    for (const TurnedThread& each : turnedThreads(threads, asked.path)) judgePitch(asked, each, verdict);
    const Message pulled = pulledThread(threads, asked.path);
    if (pulled.empty()) return;
    const Message what{GLISSADE_TEXT("'%1' is pulled off '%2' without being unscrewed: %3"),
                       {asked.moving.name, asked.other.name, pulled}};
    const Message may = mayBePulled(asked, fit, verdict);
    if (may.empty()) {
      verdict.refusals.push_back(what);
    } else {
      verdict.pulls.push_back(joined({what, may}, "; "));
    }
  }

  /// The reason why the threads of the pair may be pulled; empty: they may not.
  Message mayBePulled(const PairQuestion& asked, const PairFit& fit, StepVerdict& verdict) const {
    if (asked.moving.mesh->faces.empty() || asked.other.mesh->faces.empty()) {
      return GLISSADE_TEXT("their meshes state no cylinders");
    }
    if (Message said = product_.fits.partingOf(asked.moving.id, asked.other.id); !said.empty()) return said;
    if (fit.acceptedClash) return GLISSADE_TEXT("the user accepts their clash");
    return partingByPlan(asked, verdict);
  }

  /// The plan's statement by which the pair may come apart without a turn, which is a condition; empty: none.
  Message partingByPlan(const PairQuestion& asked, StepVerdict& verdict) const {
    FitWords ofPlan;
    ofPlan.partings = plan_.partings;
    if (ofPlan.partingOf(asked.moving.id, asked.other.id).empty()) return {};
    const Condition condition =
        plan_.partings.anyPair ? noJointsAreUsed() : comesApart(asked.moving.name, asked.other.name);
    verdict.conditions.push_back(condition);
    return {GLISSADE_TEXT("the plan says that %1"), {condition.text}};
  }

  BodyMotion judgeBody(std::size_t body, const std::vector<Pose>& path, StepVerdict& verdict) const {
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
        refuseStated(
            own, obstacle,
            moves ? GLISSADE_TEXT("they are removed together") : GLISSADE_TEXT("the other one was removed before"),
            verdict);
        continue;
      }
      const double apart = sweep.exteriorDistance(boundingBox(*obstacle.mesh, obstacle.X_WB));
      if (apart > near) {
        leastOfFar = std::min(leastOfFar, apart);
        refuseStated(own, obstacle, GLISSADE_TEXT("they are apart"), verdict);
        continue;
      }
      const PairQuestion asked{own, obstacle, {own.X_WB}, stated, numbered_.step->bodies.front(), ofBody};
      MotionPair pair{other, &obstacle, takenFit(asked, verdict)};
      judgeBends(asked, pair.fit, verdict);
      judgeThread(asked, pair.fit, verdict);
      verdict.allowances.insert(verdict.allowances.end(), pair.fit.applied.begin(), pair.fit.applied.end());
      verdict.refusals.insert(verdict.refusals.end(), pair.fit.refusals.begin(), pair.fit.refusals.end());
      motion.pairs.push_back(std::move(pair));
    }
    BodyMotion found{judgeMotion(motion, prepared_, WorkWatch(watch_.stop))};
    JudgedMotion& judged = found.judged;
    found.met = judged.verdict.minClearance;
    const int nearest = judged.verdict.nearest.body;
    found.isMetThere = nearest >= 0 && numbered_.there[static_cast<std::size_t>(nearest)];
    judged.verdict.minClearance = std::min(judged.verdict.minClearance, leastOfFar);
    judged.verdict.provedClearance = std::min(judged.verdict.provedClearance, leastOfFar);
    return found;
  }

  const Product& product_;
  const Plan& plan_;
  const NumberedStep& numbered_;
  PlacedBodies& placed_;
  MotionBodies& prepared_;
  const WorkWatch& watch_;
  double required_ = 0.0;
  bool isRequiredGiven_ = false;
};

}  // namespace

StepVerdict judgeStep(const NumberedStep& numbered, const StepTools& tools) {
  return StepJudge(numbered, tools).judge();
}

}  // namespace glissade::check
