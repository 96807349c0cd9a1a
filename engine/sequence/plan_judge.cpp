#include "engine/sequence/plan_judge.h"

#include <algorithm>
#include <limits>
#include <map>
#include <thread>

#include "engine/collision/independent_check.h"
#include "engine/collision/judged_thinning.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/path_examination.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/step_motion.h"
#include "engine/sequence/swept_box.h"

namespace glissade {
namespace {

/// Bodies farther from a sweep than this share of the moving body's radius are not looked at more closely.
constexpr double kNearShare = 0.1;

using MeshAllowance = std::pair<MeshPtr, double>;
using BodyAllowance = std::pair<std::size_t, double>;

/// By how much the moving body, and the other one, are taken thinner.
struct PairAllowance {
  double moving = 0.0;
  double other = 0.0;
};

/// The product as the judge takes it: each body thinned and prepared once for each allowance.
class JudgedProduct {
 public:
  JudgedProduct(const AssembledProduct& product, const ProductFits& fits) : product_(product), fits_(fits) {}

  PairAllowance between(std::size_t body, std::size_t other) const {
    PairAllowance pair;
    for (const Fit& fit : fits_.fitsOf(body)) {
      if (fit.obstacle == other) pair.moving = fit.allowance;
    }
    for (const Fit& fit : fits_.yieldingTo(body)) {
      if (fit.obstacle == other) pair.other = fit.allowance;
    }
    return pair;
  }

  const FitThread* threadOf(std::size_t body, std::size_t other) const { return fits_.threadOf(body, other); }

  /// For steps in which these bodies move.
  void prepare(const BodyGroup& moving, ThreadTeam& team) {
    std::map<MeshAllowance, MeshPtr> meshes;
    std::map<BodyAllowance, IndependentCheck::ObstaclePtr> obstacles;
    for (std::size_t body = 0; body < product_.bodies.size(); ++body) {
      meshes[{product_.bodies[body].mesh, 0.0}] = product_.bodies[body].mesh;
      obstacles[{body, 0.0}];
    }
    for (const std::size_t body : moving) {
      for (const Fit& fit : fits_.fitsOf(body)) meshes[{product_.bodies[body].mesh, fit.allowance}];
      for (const Fit& fit : fits_.yieldingTo(body)) {
        meshes[{product_.bodies[fit.obstacle].mesh, fit.allowance}];
        obstacles[{fit.obstacle, fit.allowance}];
      }
    }
    fill(meshes, team, [](const MeshAllowance& key) {
      return std::make_shared<const TriangleMesh>(thinnedForJudging(*key.first, key.second));
    });
    meshes_ = std::move(meshes);
    std::vector<RigidBody> all = product_.bodies;
    for (const auto& [key, mesh] : meshes_) {
      if (key.second == 0.0) continue;
      all.push_back(all.front());
      all.back().mesh = mesh;
    }
    scale_ = IndependentCheck::scaleFor(all);
    fill(obstacles, team, [&](const BodyAllowance& key) {
      RigidBody body = product_.bodies[key.first];
      body.mesh = thinned(key.first, key.second);
      return IndependentCheck::prepare(body, scale_);
    });
    obstacles_ = std::move(obstacles);
  }

  const AssembledProduct& product() const { return product_; }
  double scale() const { return scale_; }
  const MeshPtr& thinned(std::size_t body, double allowance) const {
    return meshes_.at({product_.bodies[body].mesh, allowance});
  }
  const IndependentCheck::ObstaclePtr& obstacle(std::size_t body, double allowance) const {
    return obstacles_.at({body, allowance});
  }

 private:
  /// Makes what is not there yet.
  template <class Key, class Value, class Make>
  static void fill(std::map<Key, Value>& map, ThreadTeam& team, const Make& make) {
    std::vector<std::pair<const Key*, Value*>> open;
    for (auto& [key, value] : map) {
      if (!value) open.emplace_back(&key, &value);
    }
    team.run(open.size(), [&](std::size_t i) { *open[i].second = make(*open[i].first); });
  }

  const AssembledProduct& product_;
  const ProductFits& fits_;
  double scale_ = 1.0;
  std::map<MeshAllowance, MeshPtr> meshes_;
  std::map<BodyAllowance, IndependentCheck::ObstaclePtr> obstacles_;
};

/// A step by indices.
struct JudgedStep {
  const AssemblyStep* step;
  BodyGroup group;
  BodySet there;       ///< in the order of the plan
  BodySet mayBeThere;  ///< in any order that keeps what has to be carried out before
};

/// Steps that are carried out before, in whatever order: those named that are earlier, and what these are after.
std::vector<BodySet> predecessorsOf(const AssemblyPlan& plan) {
  std::vector<BodySet> before;
  for (std::size_t step = 0; step < plan.steps.size(); ++step) {
    BodySet own(plan.steps.size(), false);
    for (const std::size_t number : plan.steps[step].after) {
      if (number == 0 || number > step) continue;
      own[number - 1] = true;
      for (std::size_t earlier = 0; earlier < number; ++earlier)
        own[earlier] = own[earlier] || before[number - 1][earlier];
    }
    before.push_back(std::move(own));
  }
  return before;
}

std::vector<JudgedStep> stepsOf(const AssemblyPlan& plan, const AssembledProduct& product) {
  const std::vector<BodySet> before = predecessorsOf(plan);
  std::vector<JudgedStep> steps;
  BodySet there(product.bodies.size(), true);
  for (const AssemblyStep& step : plan.steps) {
    JudgedStep judged{&step, {}, there, BodySet(product.bodies.size(), true)};
    for (const std::string& id : step.bodies()) judged.group.push_back(*product.indexOf(id));
    for (std::size_t earlier = 0; earlier < steps.size(); ++earlier) {
      if (before[steps.size()][earlier]) judged.mayBeThere = without(judged.mayBeThere, steps[earlier].group);
    }
    there = without(there, judged.group);
    steps.push_back(std::move(judged));
  }
  return steps;
}

bool allowsNoMore(const JudgedStep& judged, const JudgedProduct& product) {
  const auto& allowances = judged.step->allowances;
  return std::all_of(allowances.begin(), allowances.end(), [&](const StepAllowance& allowance) {
    const auto moving = product.product().indexOf(allowance.moving.empty() ? judged.step->body : allowance.moving);
    const auto other = product.product().indexOf(allowance.body);
    if (!moving || !other) return false;
    const PairAllowance pair = product.between(*moving, *other);
    return allowance.allowance <= (allowance.yields ? pair.other : pair.moving);
  });
}

/// One body of a step against those that may be there and are near its sweep; of others the distance of boxes counts.
MotionCertificate judgeBody(std::size_t body, const JudgedStep& judged, const JudgedProduct& product,
                            const std::vector<PathPoint>& points, const ParameterValues& parameters,
                            const StopToken& stop) {
  const RigidBody& own = product.product().bodies[body];
  const Pose X_PB = inverse(points.front().q) * own.X_WB;
  const auto inPathFrame = [&](const MeshPtr& mesh) {
    return std::make_shared<const TriangleMesh>(transformed(*mesh, X_PB));
  };
  const MeshPtr whole = inPathFrame(own.mesh);
  const std::vector<Pose> path = configurationsOf(points);
  const Box3 sweep = sweptBox(*whole, path);
  const double near =
      std::max(kNearShare * radiusAboutOrigin(*own.mesh), 4.0 * parameters[ParameterId::RequiredClearance]);
  std::map<double, MeshPtr> objects{{0.0, whole}};
  std::vector<IndependentCheck::Against> against;
  std::vector<IndependentCheck::Thread> threads;
  std::vector<std::size_t> others;
  double leastOfFar = std::numeric_limits<double>::infinity();
  for (const std::size_t other : bodiesIn(without(judged.mayBeThere, judged.group))) {
    const RigidBody& obstacle = product.product().bodies[other];
    const double apart = sweep.exteriorDistance(boundingBox(*obstacle.mesh, obstacle.X_WB));
    if (apart > near) {
      leastOfFar = std::min(leastOfFar, apart);
      continue;
    }
    const PairAllowance allowance = product.between(body, other);
    MeshPtr& object = objects[allowance.moving];
    if (!object) object = inPathFrame(product.thinned(body, allowance.moving));
    against.push_back({product.obstacle(other, allowance.other), object, allowance.moving + allowance.other > 0.0});
    if (const FitThread* thread = product.threadOf(body, other)) {
      threads.push_back({thread->rule, obstacle, product.obstacle(other, 0.0)});
      threads.back().rule.obstacle = static_cast<int>(others.size());
      threads.back().rule.assembled = {path.front()};
    }
    others.push_back(other);
  }
  const IndependentCheck check(against, *whole, product.scale(), threads);
  MotionCertificate certificate = check.check(path, demandsOf(points, parameters), stop);
  if (certificate.nearest.body >= 0) {
    certificate.nearest.body = static_cast<int>(others[static_cast<std::size_t>(certificate.nearest.body)]);
  }
  certificate.minClearance = std::min(certificate.minClearance, leastOfFar);
  certificate.provedClearance = std::min(certificate.provedClearance, leastOfFar);
  return certificate;
}

/// The clearance that is asked for, or the least of the usual ones of the bodies.
double requiredOf(const JudgedStep& judged, const AssembledProduct& product, std::optional<double> required) {
  if (required) return *required;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t body : judged.group) {
    const ParameterValues usual(radiusAboutOrigin(*product.bodies[body].mesh));
    least = std::min(least, usual[ParameterId::RequiredClearance]);
  }
  return least;
}

/// A demand of the plan that the step of this number does not keep, and that it does not name.
std::string againstDemand(const JudgedStep& judged, std::size_t number, const AssembledProduct& product,
                          const OrderRules& rules) {
  const auto name = [&](std::size_t body) { return "'" + product.bodies[body].name + "'"; };
  BodyGroup group = judged.group;
  std::sort(group.begin(), group.end());
  const auto says = [&](StepViolation::Rule rule, const std::string& body) {
    const auto& all = judged.step->violates;
    return std::any_of(all.begin(), all.end(), [&](const StepViolation& violation) {
      const auto& bodies = violation.bodies;
      return violation.rule == rule && (body.empty() || std::find(bodies.begin(), bodies.end(), body) != bodies.end());
    });
  };
  if (isForbidden(exitDirection(judged.step->path), rules.forbiddenTo(group))) {
    return "it leaves in a direction that is forbidden";
  }
  for (const std::size_t first : heldBy(group, judged.there, rules, false)) {
    if (says(StepViolation::Rule::Before, product.bodies[first].id)) continue;
    return name(first) + " is demanded to leave before, and the step does not say that it does not";
  }
  const std::size_t place = rules.placeOf(group);
  if (place != 0 && place != number && !says(StepViolation::Rule::Place, "")) {
    return "it is demanded as step " + std::to_string(place);
  }
  const auto* motion = rules.motionOf(group);
  if (motion != nullptr && motion->path.size() != judged.step->path.size()) {
    return "another motion is demanded of it";
  }
  for (std::size_t i = 0; motion != nullptr && i < motion->path.size(); ++i) {
    if (!(motion->path[i].q == judged.step->path[i].q)) return "another motion is demanded of it";
  }
  return {};
}

StepJudgement judge(const JudgedStep& judged, const JudgedProduct& product, std::optional<double> required,
                    const StopToken& stop) {
  const std::vector<PathPoint> points = withUnitRotations(judged.step->path);
  StepJudgement judgement{judged.step->body, {}, true, allowsNoMore(judged, product), {}};
  const Box3 box = boxOf(product.product(), without(judged.there, judged.group));
  bool first = true;
  for (const std::size_t body : judged.group) {
    const RigidBody& own = product.product().bodies[body];
    ParameterValues parameters(radiusAboutOrigin(*own.mesh));
    static_cast<void>(parameters.set(ParameterId::RequiredClearance, requiredOf(judged, product.product(), required)));
    const MotionCertificate certificate = judgeBody(body, judged, product, points, parameters, stop);
    const Pose end = points.back().q * inverse(points.front().q) * own.X_WB;
    judgement.endsOutside = judgement.endsOutside && (box.isEmpty() || !box.intersects(boundingBox(*own.mesh, end)));
    const bool certified = certificate.status == CertificateStatus::Certified;
    if (first || !certified || certificate.minClearance < judgement.certificate.minClearance) {
      judgement.certificate = certificate;
    }
    first = false;
    if (!certified) break;
  }
  return judgement;
}

}  // namespace

Result<std::vector<StepJudgement>> judgePlan(const AssemblyPlan& plan, const AssembledProduct& product,
                                             std::optional<double> required, const StopToken& stop) {
  ThreadTeam team(std::max(1U, std::thread::hardware_concurrency()) - 1);
  const auto fits = ProductFits::find(product, team, stop);
  if (!fits) return fits.error();
  const auto rules = resolved(plan.demands, product);
  if (!rules) return rules.error();
  const std::vector<JudgedStep> steps = stepsOf(plan, product);
  JudgedProduct judged(product, *fits);
  BodyGroup moving;
  for (const JudgedStep& step : steps) moving.insert(moving.end(), step.group.begin(), step.group.end());
  judged.prepare(moving, team);
  std::vector<StepJudgement> judgements(steps.size());
  team.run(steps.size(), [&](std::size_t i) {
    if (stop.stopRequested()) return;
    judgements[i] = judge(steps[i], judged, required, stop);
    judgements[i].againstDemand = againstDemand(steps[i], i + 1, product, *rules);
  });
  if (stop.stopRequested()) return Diagnostic{ErrorKind::Interrupted, "", "", "was interrupted", "Start again."};
  return judgements;
}

}  // namespace glissade
