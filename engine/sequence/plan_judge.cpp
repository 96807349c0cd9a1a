#include "engine/sequence/plan_judge.h"

#include <algorithm>

#include "engine/collision/independent_check.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/path_examination.h"
#include "engine/sequence/motion_world.h"
#include "engine/sequence/product_fits.h"

namespace glissade {
namespace {

/// The body's mesh in the frame of a path that begins where it is assembled.
TriangleMesh inFrameOf(const Pose& first, const RigidBody& body) {
  return transformed(*body.mesh, inverse(first) * body.X_WB);
}

bool allowsNoMore(const AssemblyStep& step, const std::vector<Fit>& fits, const AssembledProduct& product) {
  return std::all_of(step.allowances.begin(), step.allowances.end(), [&](const StepAllowance& allowance) {
    return std::any_of(fits.begin(), fits.end(), [&](const Fit& fit) {
      return product.bodies[fit.obstacle].id == allowance.body && allowance.allowance <= fit.allowance;
    });
  });
}

/// Of a path that begins where the body is assembled, with those that are there.
std::vector<ThreadRule> threadsOf(const std::vector<Fit>& fits, const std::vector<std::size_t>& others,
                                  const Pose& assembled) {
  std::vector<Fit> there;
  for (const Fit& fit : fits) {
    if (std::find(others.begin(), others.end(), fit.obstacle) == others.end()) continue;
    there.push_back(fit);
    there.back().obstacle = obstacleOf(fit.obstacle, others);
  }
  std::vector<ThreadRule> rules = threadRulesOf(there);
  for (ThreadRule& rule : rules) rule.assembled = {assembled};
  return rules;
}

StepJudgement judge(const AssemblyStep& step, std::size_t body, const AssembledProduct& product, const BodySet& present,
                    const std::vector<Fit>& fits, std::optional<double> required, const StopToken& stop) {
  std::vector<std::size_t> others;
  std::vector<RigidBody> obstacles;
  std::vector<double> allowances;
  Box3 box;
  for (const std::size_t other : bodiesIn(present)) {
    if (other == body) continue;
    others.push_back(other);
    obstacles.push_back(product.bodies[other]);
    const auto fit = std::find_if(fits.begin(), fits.end(), [&](const Fit& each) { return each.obstacle == other; });
    allowances.push_back(fit == fits.end() ? 0.0 : fit->allowance);
    box.extend(boundingBox(*obstacles.back().mesh, obstacles.back().X_WB));
  }
  const std::vector<PathPoint> points = withUnitRotations(step.path);
  const TriangleMesh object = inFrameOf(points.front().q, product.bodies[body]);
  ParameterValues parameters(radiusAboutOrigin(object));
  if (required) static_cast<void>(parameters.set(ParameterId::RequiredClearance, *required));
  StepJudgement judgement{step.body, {}, false, allowsNoMore(step, fits, product)};
  const IndependentCheck check(obstacles, object, allowances, threadsOf(fits, others, points.front().q));
  judgement.certificate = check.check(configurationsOf(points), demandsOf(points, parameters), stop);
  nameByProduct(judgement.certificate, others);
  judgement.endsOutside = box.isEmpty() || !box.intersects(boundingBox(object, points.back().q));
  return judgement;
}

}  // namespace

Result<std::vector<StepJudgement>> judgePlan(const AssemblyPlan& plan, const AssembledProduct& product,
                                             std::optional<double> required, const StopToken& stop) {
  ThreadTeam alone(0);
  const auto fits = ProductFits::find(product, alone, stop);
  if (!fits) return fits.error();
  BodySet present(product.bodies.size(), true);
  std::vector<StepJudgement> judgements;
  for (const AssemblyStep& step : plan.steps) {
    const std::size_t body = *product.indexOf(step.body);
    judgements.push_back(judge(step, body, product, present, fits->fitsOf(body), required, stop));
    if (stop.stopRequested()) {
      return Diagnostic{ErrorKind::Interrupted, "", "", "was interrupted", "Start again."};
    }
    present[body] = false;
  }
  return judgements;
}

}  // namespace glissade
