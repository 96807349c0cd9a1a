#include "engine/check/pair_fit.h"

#include <algorithm>

#include "engine/check/evidence_names.h"
#include "engine/check/pair_work.h"
#include "engine/check/taken_core.h"
#include "engine/check/taken_hollow.h"
#include "engine/check/thread_axis.h"
#include "engine/check/verdict_words.h"
#include "engine/evidence/thinning.h"

namespace glissade::check {
namespace {

/// Absolute counterpart of kEstimate, metres.
constexpr double kEstimateAtLeast = 2e-7;

std::vector<double> limited(const std::vector<double>& atMost, double stated) {
  std::vector<double> allowances = atMost;
  for (double& each : allowances) each = std::min(each, stated);
  return largest(allowances) > 0.0 ? allowances : std::vector<double>();
}

/// True if no two points of the meshes are nearer than the gap.
bool areApart(const TriangleMesh& one, const TriangleMesh& other, double gap) {
  bool apart = true;
  const TriangleTree a(one);
  const TriangleTree b(other);
  a.visitPairs(b, gap, [&](std::uint32_t i, std::uint32_t k) {
    const Triangle& first = a.triangles()[i];
    const Triangle& second = b.triangles()[k];
    apart = !trianglesMeet(first, second) && triangleDistance(first, second).squared >= gap * gap;
    return apart;
  });
  return apart;
}

std::vector<StatedAllowance> ofPair(const PairQuestion& question) {
  std::vector<StatedAllowance> own;
  if (!question.stated) return own;
  for (const StatedAllowance& each : *question.stated) {
    if (each.isAbout(question.moving.id, question.other.id, question.first)) own.push_back(each);
  }
  return own;
}

void refuseOff(const StatedAllowance& stated, PairWork& work) {
  if (stated.allowance <= 0.0) return;
  AppliedAllowance& allowance = work.add(stated.yields, 0.0);
  allowance.stated = stated.allowance;
  work.fit.refusals.push_back(
      allowanceRefused(allowance, GLISSADE_TEXT("fits are off: every pair has to keep its clearance")));
}

void apply(const StatedAllowance& stated, PairWork& work) {
  const AllowanceBound& bound = stated.yields ? work.bounds.other : work.bounds.one;
  std::vector<double>& taken = stated.yields ? work.fit.other : work.fit.moving;
  taken = limited(bound.atMost, stated.allowance);
  AppliedAllowance& allowance = work.add(stated.yields, largest(taken));
  allowance.stated = stated.allowance;
  const double enough = bound.most + std::max(kEstimateAtLeast, kEstimate * bound.most);
  if (stated.allowance <= (bound.most > 0.0 ? enough : 0.0)) return;
  Message why;
  if (bound.isClash) {
    why = clashRefused(work.bounds.depth);
  } else if (!bound.inFit) {
    why = GLISSADE_TEXT("they are apart");
  }
  work.fit.refusals.push_back(allowanceRefused(allowance, why));
}

/// True if the pair with its allowances is free where it is assembled.
bool isFree(const PairWork& work) {
  const auto taken = [&](const AllowanceBound& bound, const Body& body, const std::vector<double>& allowances) {
    return allowances.empty() ? *body.mesh : thinned(bound.mesh ? *bound.mesh : *body.mesh, allowances, work.fit.share);
  };
  const TriangleMesh own = taken(work.bounds.one, work.question.moving, work.fit.moving);
  TriangleMesh others = taken(work.bounds.other, work.question.other, work.fit.other);
  others = transformed(others, work.question.other.X_WB);
  const double gap = 0.5 * assembledMargin(radiusAboutOrigin(*work.question.moving.mesh));
  return std::all_of(work.question.assembled.begin(), work.question.assembled.end(),
                     [&](const Pose& end) { return areApart(transformed(own, end), others, gap); });
}

/// Applies the allowances of the evidence: to the moving body if that is enough, else to the other body, else to both.
/// If one body is below a part of a face of the other one, both are thinned at once, because they slide past the rest
/// of the face.
void applyOwn(PairWork& work) {
  if (const Message refused = work.bounds.refused(); !refused.empty()) {
    AppliedAllowance& allowance = work.add(false, 0.0);
    work.fit.refusals.push_back(allowanceRefused(allowance, refused));
  }
  if (work.bounds.one.most <= 0.0 && work.bounds.other.most <= 0.0) return;
  const std::vector<double> one = limited(work.bounds.one.atMost, work.bounds.one.most);
  const std::vector<double> other = limited(work.bounds.other.atMost, work.bounds.other.most);
  std::vector<std::pair<bool, bool>> choices{{true, false}, {false, true}, {true, true}};
  if (work.bounds.one.mesh || work.bounds.other.mesh) std::swap(choices.front(), choices.back());
  for (const auto& [moving, yielding] : choices) {
    work.fit.moving = moving ? one : std::vector<double>();
    work.fit.other = yielding ? other : std::vector<double>();
    if (isFree(work)) break;
  }
  if (!work.fit.moving.empty()) work.add(false, largest(work.fit.moving));
  if (!work.fit.other.empty()) work.add(true, largest(work.fit.other));
}

void refusePair(const Message& reason, PairWork& work) {
  const Message pair = pairInWords(work.question.moving.name, work.question.other.name);
  work.fit.refusals.push_back({GLISSADE_TEXT("%1: %2"), {pair, reason}});
}

void takeThread(const std::vector<StatedAllowance>& stated, PairWork& work) {
  std::optional<StatedThread> said;
  std::optional<double> pitch;
  for (const StatedAllowance& each : stated) {
    if (each.thread) said = each.thread;
    if (each.thread) pitch = each.thread->pitch;
    if (!pitch) pitch = each.pitch;
  }
  Result<Thread> found(Diagnostic{});
  Pose assembled;
  for (const Pose& end : work.question.assembled) {
    found = threadAxis(work.bodies.at({work.question.moving, end}),
                       work.bodies.at({work.question.other, work.question.other.X_WB}), said);
    assembled = end;
    if (found) break;
  }
  if (!found) {
    refusePair(found.error().reason, work);
    return;
  }
  Thread thread = *found;
  thread.assembled = assembled;
  work.applyStatements(thread, pitch);
  if (const Message wrong = wrongPitch(thread); !wrong.empty()) refusePair(wrong, work);
  for (AppliedAllowance& allowance : work.fit.applied) allowance.thread = thread;
  work.fit.thread = thread;
}

void takeThinner(const std::vector<StatedAllowance>& stated, PairWork& work) {
  work.findBounds(work.word);
  if (!work.question.stated) {
    applyOwn(work);
  } else {
    for (const StatedAllowance& each : stated) apply(each, work);
  }
}

}  // namespace

PairFit fitOf(const PairQuestion& question, const FitWords& fits, PlacedBodies& bodies, const StopToken& stop) {
  PairWork work{question, fits, bodies, stop, fits.about(question.moving.id, question.other.id)};
  const bool marked = fits.on && work.word != nullptr && work.word->isThread();
  const std::vector<StatedAllowance> stated = ofPair(question);
  const auto states = [&](auto what) { return std::any_of(stated.begin(), stated.end(), what); };
  if (stated.empty() && question.stated && !marked) return {};
  if (!fits.on) {
    for (const StatedAllowance& each : stated) refuseOff(each, work);
  } else if (states([](const StatedAllowance& each) { return each.core.has_value(); })) {
    takeCore(stated, work);
  } else if (states([](const StatedAllowance& each) { return each.hollow; })) {
    takeHollow(stated, work);
  } else {
    takeThinner(stated, work);
    if (marked) takeThread(stated, work);
  }
  return std::move(work.fit);
}

}  // namespace glissade::check
