#include "engine/check/pair_work.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade::check {
namespace {

/// True if the path follows the exit direction that a person states for the hook.
bool bends(const PairWork& work) {
  const SnapWord* snap = work.fits.snapOf(work.question.moving.id, work.question.other.id);
  if (snap == nullptr) return false;
  const Vector3 way = snap->hook == work.question.moving.id ? snap->direction : Vector3(-snap->direction);
  return goesAlong(way, work.question.moving, work.question.path, work.question.other);
}

/// Bend of the body's hook, metres; 0: it has no hook that bends.
double bendOf(const PairWork& work, bool yields) {
  const SnapWord* snap = work.fits.snapOf(work.question.moving.id, work.question.other.id);
  if (snap == nullptr || (yields ? work.bounds.other : work.bounds.one).share != kHookShare) return 0.0;
  return snap->bend;
}

/// The pitch of the path where it begins or ends in the thread. For a path without a turn it is a tenth of the
/// diameter, so that the path is refused.
double pitchOfPath(std::vector<Pose> path, const Thread& thread) {
  const double far = (path.front().position - thread.assembled.position).norm();
  if ((path.back().position - thread.assembled.position).norm() < far) std::reverse(path.begin(), path.end());
  double turn = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Quaternion step = path[i].orientation * path[i - 1].orientation.conjugate();
    turn += std::remainder(2.0 * std::atan2(step.vec().dot(thread.axis), step.w()), 2.0 * std::numbers::pi);
    const double advance = (path[i].position - path.front().position).dot(thread.axis);
    if (std::abs(turn) >= 0.5 * std::numbers::pi) return advance / turn * 2.0 * std::numbers::pi;
  }
  return 0.2 * std::max(thread.radiusMoving, thread.radiusOther);
}

}  // namespace

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void PairWork::findBounds(const PairWord* about) {
  FitWords words = fits;
  if (!bends(*this)) words.snaps.clear();
  std::optional<PairBounds> all;
  for (const Pose& end : question.assembled) {
    const PairBounds found =
        bodies.boundsOf({question.moving, end}, {question.other, question.other.X_WB}, words, about, stop);
    all = all ? united(*all, found) : found;
  }
  if (all) bounds = std::move(*all);
  fit.share = std::max(bounds.one.share, bounds.other.share);
  fit.depth = bounds.depth;
  fit.meshOfMoving = bounds.one.mesh;
  fit.meshOfOther = bounds.other.mesh;
}

AppliedAllowance& PairWork::add(bool yields, double applied) {
  const AllowanceBound& bound = yields ? bounds.other : bounds.one;
  AppliedAllowance allowance;
  allowance.moving = question.moving.id;
  allowance.other = question.other.id;
  allowance.thinner = yields ? question.other.name : question.moving.name;
  allowance.against = yields ? question.moving.name : question.other.name;
  allowance.yields = yields;
  allowance.applied = applied;
  allowance.most = bound.most;
  allowance.evidence = bound.largest;
  allowance.bend = bendOf(*this, yields);
  if (bounds.isPlainOverlap) allowance.plainOverlap = bounds.depth;
  fit.applied.push_back(std::move(allowance));
  return fit.applied.back();
}

void PairWork::applyStatements(Thread& thread, const std::optional<double>& stated) {
  const std::optional<double> said = word != nullptr ? word->pitch : std::nullopt;
  if (said && stated && std::abs(*said - *stated) > 1e-9) {
    fit.refusals.push_back(
        {GLISSADE_TEXT("'%1' and '%2': the file's pitch is not the one that the user gives for the thread"),
         {question.moving.name, question.other.name}});
  }
  thread.pitch = said ? *said : stated.value_or(pitchOfPath(question.path, thread));
  thread.mayTurn = word == nullptr || word->turned.empty() || word->turned == question.moving.id;
}

}  // namespace glissade::check
