#include "engine/check/taken_core.h"

#include <algorithm>
#include <cmath>

#include "engine/check/thread_axis.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

constexpr double kSameRadius = 1e-5;  ///< metres

/// Searches the assembled configurations for one that shows the core, and sets it in the thread.
Result<ThreadCore> findCore(const PairWork& work, Thread& thread) {
  const bool own = thread.movingIsShaft;
  const ClaimedThread claim{thread.point, thread.axis, thread.pitch, own ? thread.radiusMoving : thread.radiusOther};
  Result<ThreadCore> core(Diagnostic{});
  for (const Pose& end : work.question.assembled) {
    const PlacedBody& moving = work.bodies.at({work.question.moving, end});
    const PlacedBody& other = work.bodies.at({work.question.other, work.question.other.X_WB});
    core = own ? threadCoreOf(moving, other, claim) : threadCoreOf(other, moving, claim);
    thread.assembled = end;
    if (core) break;
  }
  return core;
}

/// Gives faces of the shaft beside the thread an allowance for their contacts.
void takeTouching(const Thread& thread, const ThreadCore& core, PairWork& work) {
  PairWord accepted = work.word != nullptr ? *work.word : PairWord{work.question.moving.id, work.question.other.id};
  accepted.accepted = true;
  work.findBounds(&accepted);
  const PlacedBody& moving = work.bodies.at({work.question.moving, thread.assembled});
  const PlacedBody& other = work.bodies.at({work.question.other, work.question.other.X_WB});
  const bool own = thread.movingIsShaft;
  const double touching = core.spacing + core.margin + moving.largestDeflection + other.largestDeflection;
  // At most `touching` is taken, which counts for whole faces.
  const std::size_t count = (own ? moving : other).mesh.triangles.size();
  std::vector<double> allowances = mostOfTriangles(own ? work.bounds.one : work.bounds.other, count);
  (own ? work.fit.meshOfMoving : work.fit.meshOfOther) = nullptr;
  const std::vector<bool> ofThread = trianglesOfThread((own ? moving : other).mesh, core);
  for (std::size_t t = 0; t < allowances.size(); ++t) {
    allowances[t] = ofThread[t] ? 0.0 : std::min(allowances[t], touching);
  }
  if (largest(allowances) > 0.0) (own ? work.fit.moving : work.fit.other) = std::move(allowances);
}

}  // namespace

void takeCore(const std::vector<StatedAllowance>& stated, PairWork& work) {
  const StatedAllowance& claim = stated.front();
  const auto refuse = [&](const Message& reason) {
    if (work.fit.applied.empty()) work.add(claim.yields, 0.0).stated = claim.allowance;
    work.fit.refusals.push_back(allowanceRefused(work.fit.applied.front(), reason));
  };
  if (stated.size() > 1 || !claim.core)
    return refuse(GLISSADE_TEXT("a thread is taken away of one body of a pair, and nothing else"));
  if (work.word != nullptr && !work.word->kind.empty() && !work.word->isThread())
    return refuse(GLISSADE_TEXT("the user states that the pair is no thread"));
  Thread thread = threadOf(*claim.core);
  thread.movingIsShaft = !claim.yields;
  Result<ThreadCore> core = findCore(work, thread);
  if (!core) return refuse(core.error().reason);
  double& hole = thread.movingIsShaft ? thread.radiusOther : thread.radiusMoving;
  if (std::abs(hole - core->hole) > kSameRadius)
    return refuse(GLISSADE_TEXT("the hole is not as narrow as the file states"));
  hole = core->hole;
  takeTouching(thread, *core, work);
  AppliedAllowance& allowance = work.add(claim.yields, core->depth());
  allowance.stated = claim.allowance;
  allowance.core = true;
  allowance.most = core->depth();
  allowance.evidence = {core->depth() - core->spacing - core->margin, 0.0, core->spacing, core->margin};
  work.applyStatements(thread, thread.pitch);
  allowance.thread = work.fit.thread = thread;
  work.fit.core = inFrame(inverse(claim.yields ? work.question.other.X_WB : thread.assembled), *core);
  if (claim.allowance > (1.0 + kEstimate) * core->depth()) refuse(GLISSADE_TEXT("its thread is not so deep"));
}

}  // namespace glissade::check
