#include "engine/check/pair_fit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "engine/check/thinning.h"
#include "engine/check/thread_axis.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

/// By which two careful estimates of the same bound may differ, as a share of it, and metres.
constexpr double kEstimate = 0.02;
constexpr double kEstimateAtLeast = 2e-7;
constexpr double kSameRadius = 1e-5;  ///< metres

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::vector<double> limited(const std::vector<double>& atMost, double stated) {
  std::vector<double> allowances = atMost;
  for (double& each : allowances) each = std::min(each, stated);
  return largest(allowances) > 0.0 ? allowances : std::vector<double>();
}

/// Taken so, no point of the one is nearer to the other than the gap.
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

class PairFitter {
 public:
  PairFitter(const PairQuestion& question, const FitWords& fits, PlacedBodies& bodies, const StopToken& stop)
      : question_(question),
        fits_(fits),
        bodies_(bodies),
        stop_(stop),
        word_(fits.about(question.moving.id, question.other.id)) {}

  PairFit take() {
    const bool marked = fits_.on && word_ != nullptr && word_->isThread();
    const std::vector<StatedAllowance> stated = ofPair();
    const bool core = std::any_of(stated.begin(), stated.end(), [](const auto& each) { return each.core.has_value(); });
    if (stated.empty() && question_.stated && !marked) return {};
    if (!fits_.on) {
      for (const StatedAllowance& each : stated) refuseOff(each);
      return std::move(fit_);
    }
    if (core) {
      takeCore(stated);
      return std::move(fit_);
    }
    if (std::any_of(stated.begin(), stated.end(), [](const auto& each) { return each.hollow; })) {
      takeHollow(stated);
      return std::move(fit_);
    }
    findBounds(word_);
    if (!question_.stated) {
      applyOwn();
    } else {
      for (const StatedAllowance& each : stated) apply(each);
    }
    if (marked) takeThread(stated);
    return std::move(fit_);
  }

 private:
  std::vector<StatedAllowance> ofPair() const {
    std::vector<StatedAllowance> own;
    if (!question_.stated) return own;
    for (const StatedAllowance& each : *question_.stated) {
      if (each.isAbout(question_.moving.id, question_.other.id, question_.first)) own.push_back(each);
    }
    return own;
  }

  /// A hook bends on the way that the person says, and on no other one.
  bool bends() const {
    const SnapWord* snap = fits_.snapOf(question_.moving.id, question_.other.id);
    if (snap == nullptr) return false;
    const Vector3 way = snap->hook == question_.moving.id ? snap->direction : Vector3(-snap->direction);
    return goesAlong(way, question_.moving, question_.path, question_.other);
  }

  /// What the pair may be taken thinner, with this word about it.
  void findBounds(const PairWord* word) {
    FitWords words = fits_;
    if (!bends()) words.snaps.clear();
    bool first = true;
    for (const Pose& end : question_.assembled) {
      const PairBounds found =
          bodies_.boundsOf({question_.moving, end}, {question_.other, question_.other.X_WB}, words, word, stop_);
      bounds_.one = first ? found.one : united(bounds_.one, found.one);
      bounds_.other = first ? found.other : united(bounds_.other, found.other);
      first = false;
    }
    fit_.share = std::max(bounds_.one.share, bounds_.other.share);
  }

  /// Metres; 0: the body has no hook that bends.
  double bendOf(bool yields) const {
    const SnapWord* snap = fits_.snapOf(question_.moving.id, question_.other.id);
    if (snap == nullptr || (yields ? bounds_.other : bounds_.one).share != kHookShare) return 0.0;
    return snap->bend;
  }

  AppliedAllowance& add(bool yields, double applied) {
    const AllowanceBound& bound = yields ? bounds_.other : bounds_.one;
    AppliedAllowance allowance;
    allowance.moving = question_.moving.id;
    allowance.other = question_.other.id;
    allowance.thinner = yields ? question_.other.name : question_.moving.name;
    allowance.against = yields ? question_.moving.name : question_.other.name;
    allowance.yields = yields;
    allowance.applied = applied;
    allowance.most = bound.most;
    allowance.evidence = bound.largest;
    allowance.bend = bendOf(yields);
    fit_.applied.push_back(std::move(allowance));
    return fit_.applied.back();
  }

  void refuseOff(const StatedAllowance& stated) {
    if (stated.allowance <= 0.0) return;
    AppliedAllowance& allowance = add(stated.yields, 0.0);
    allowance.stated = stated.allowance;
    fit_.refusals.push_back(allowanceRefused(allowance, "fits are off: every pair has to keep its clearance"));
  }

  void apply(const StatedAllowance& stated) {
    const AllowanceBound& bound = stated.yields ? bounds_.other : bounds_.one;
    std::vector<double>& taken = stated.yields ? fit_.other : fit_.moving;
    taken = limited(bound.atMost, stated.allowance);
    AppliedAllowance& allowance = add(stated.yields, largest(taken));
    allowance.stated = stated.allowance;
    const double enough = bound.most + std::max(kEstimateAtLeast, kEstimate * bound.most);
    if (stated.allowance <= (bound.most > 0.0 ? enough : 0.0)) return;
    const bool apart = bound.refused.empty() && !bound.inFit;
    fit_.refusals.push_back(allowanceRefused(allowance, apart ? "they are apart" : bound.refused));
  }

  void applyOwn() {
    if (const std::string refused = bounds_.refused(); !refused.empty()) {
      AppliedAllowance& allowance = add(false, 0.0);
      fit_.refusals.push_back(allowanceRefused(allowance, refused));
    }
    if (bounds_.one.most <= 0.0 && bounds_.other.most <= 0.0) return;
    const std::vector<double> one = limited(bounds_.one.atMost, bounds_.one.most);
    const std::vector<double> other = limited(bounds_.other.atMost, bounds_.other.most);
    for (const auto& [moving, yielding] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
      fit_.moving = moving ? one : std::vector<double>();
      fit_.other = yielding ? other : std::vector<double>();
      if (isFree()) break;
    }
    if (!fit_.moving.empty()) add(false, largest(fit_.moving));
    if (!fit_.other.empty()) add(true, largest(fit_.other));
  }

  /// Taken so, the pair is free where it is assembled.
  bool isFree() {
    const TriangleMesh own =
        fit_.moving.empty() ? *question_.moving.mesh : thinned(*question_.moving.mesh, fit_.moving, fit_.share);
    TriangleMesh others =
        fit_.other.empty() ? *question_.other.mesh : thinned(*question_.other.mesh, fit_.other, fit_.share);
    others = transformed(others, question_.other.X_WB);
    const double gap = 0.5 * assembledMargin(radiusAboutOrigin(*question_.moving.mesh));
    return std::all_of(question_.assembled.begin(), question_.assembled.end(),
                       [&](const Pose& end) { return areApart(transformed(own, end), others, gap); });
  }

  void takeThread(const std::vector<StatedAllowance>& stated) {
    std::optional<StatedThread> said;
    std::optional<double> pitch;
    for (const StatedAllowance& each : stated) {
      if (each.thread) said = each.thread;
      if (each.thread) pitch = each.thread->pitch;
      if (!pitch) pitch = each.pitch;
    }
    Result<Thread> found(Diagnostic{});
    Pose assembled;
    for (const Pose& end : question_.assembled) {
      found =
          threadAxis(bodies_.at({question_.moving, end}), bodies_.at({question_.other, question_.other.X_WB}), said);
      assembled = end;
      if (found) break;
    }
    if (!found) {
      fit_.refusals.push_back(pairInWords(question_.moving.name, question_.other.name) + ": " + found.error().reason);
      return;
    }
    Thread thread = *found;
    thread.assembled = assembled;
    heedWord(thread, pitch);
    if (const std::string wrong = wrongPitch(thread); !wrong.empty()) {
      fit_.refusals.push_back(pairInWords(question_.moving.name, question_.other.name) + ": " + wrong);
    }
    for (AppliedAllowance& allowance : fit_.applied) allowance.thread = thread;
    fit_.thread = thread;
  }

  /// The pitch is a person's, else the file's, else that of the path.
  void heedWord(Thread& thread, const std::optional<double>& stated) {
    const std::optional<double> said = word_ != nullptr ? word_->pitch : std::nullopt;
    if (said && stated && std::abs(*said - *stated) > 1e-9) {
      fit_.refusals.push_back(pairInWords(question_.moving.name, question_.other.name) +
                              ": the file's pitch is not the one that a person gives for the thread");
    }
    thread.pitch = said ? *said : stated.value_or(pitchOfPath(thread));
    thread.mayTurn = word_ == nullptr || word_->turned.empty() || word_->turned == question_.moving.id;
  }

  /// What the one body fills of the other one is taken away where a person accepts the clash. The one that fills it is
  /// taken thinner all around.
  void takeHollow(const std::vector<StatedAllowance>& stated) {
    const bool isFirst = stated.front().hollow;
    const StatedAllowance& host = isFirst ? stated.front() : stated.back();
    const StatedAllowance& guest = isFirst ? stated.back() : stated.front();
    const auto refuse = [&](const StatedAllowance& claim, const std::string& reason) {
      AppliedAllowance& allowance = add(claim.yields, 0.0);
      allowance.stated = claim.allowance;
      AppliedAllowance claimed = allowance;
      claimed.hollow = claim.hollow;
      fit_.refusals.push_back(allowanceRefused(claimed, reason));
    };
    if (stated.size() != 2 || guest.hollow || host.yields == guest.yields || host.core || host.thread || guest.thread)
      return refuse(host, "what overlaps is taken away of one body of a pair, and the other one is taken thinner");
    if (word_ != nullptr && word_->isThread()) return refuse(host, "a person says that the pair is a thread");
    const PlacedBodies::HollowPtr hollow = hollowOf(host.yields);
    if (!hollow) return refuse(host, "no overlap with the other one can be taken away of it");
    if (!fits_.accepts(word_, hollow->depth)) return refuse(host, "it is a clash that nobody accepted");
    (host.yields ? fit_.hollowOther : fit_.hollowMoving) = hollow;
    fit_.acceptedClash = isClash();
    AppliedAllowance& ofHost = add(host.yields, hollow->depth);
    ofHost.hollow = true;
    ofHost.stated = host.allowance;
    ofHost.most = hollow->depth;
    ofHost.evidence = {hollow->depth, 0.0, 0.0, 0.0, 0.0};
    takeAllAround(guest);
  }

  /// Were nothing accepted, the evidence would refuse the pair.
  bool isClash() {
    FitWords strict = fits_;
    strict.acceptedClash = 0.0;
    return std::any_of(question_.assembled.begin(), question_.assembled.end(), [&](const Pose& end) {
      const Placement moving{question_.moving, end};
      const Placement other{question_.other, question_.other.X_WB};
      return !bodies_.boundsOf(moving, other, strict, nullptr, stop_).refused().empty();
    });
  }

  /// The other body of the pair fills what is taken away.
  PlacedBodies::HollowPtr hollowOf(bool yields) {
    const Placement other{question_.other, question_.other.X_WB};
    for (const Pose& end : question_.assembled) {
      const Placement moving{question_.moving, end};
      const PlacedBodies::HollowPtr hollow = bodies_.hollowOf(yields ? other : moving, yields ? moving : other, stop_);
      if (hollow) return hollow;
    }
    return nullptr;
  }

  void takeAllAround(const StatedAllowance& stated) {
    const PlacedBody& moving = bodies_.at({question_.moving, question_.moving.X_WB});
    const PlacedBody& other = bodies_.at({question_.other, question_.other.X_WB});
    const double spacing = moving.spacing + other.spacing;
    const double room = hollowRoom(moving, other);
    const PlacedBody& thinner = stated.yields ? other : moving;
    (stated.yields ? fit_.other : fit_.moving).assign(thinner.mesh.triangles.size(), std::min(stated.allowance, room));
    AppliedAllowance& allowance = add(stated.yields, std::min(stated.allowance, room));
    allowance.stated = stated.allowance;
    allowance.most = room;
    allowance.evidence = {0.0, 0.0, spacing, room - spacing, 0.0};
    if (stated.allowance > (1.0 + kEstimate) * room) fit_.refusals.push_back(allowanceRefused(allowance, ""));
  }

  /// The thread of one of the bodies is taken away, and nothing else but what touches.
  void takeCore(const std::vector<StatedAllowance>& stated) {
    const StatedAllowance& claim = stated.front();
    const auto refuse = [&](const std::string& reason) {
      if (fit_.applied.empty()) add(claim.yields, 0.0).stated = claim.allowance;
      fit_.refusals.push_back(allowanceRefused(fit_.applied.front(), reason));
    };
    if (stated.size() > 1 || !claim.core)
      return refuse("a thread is taken away of one body of a pair, and nothing else");
    if (word_ != nullptr && !word_->kind.empty() && !word_->isThread())
      return refuse("a person says that the pair is no thread");
    Thread thread = threadOf(*claim.core);
    thread.movingIsShaft = !claim.yields;
    Result<ThreadCore> core = findCore(thread);
    if (!core) return refuse(core.error().reason);
    double& hole = thread.movingIsShaft ? thread.radiusOther : thread.radiusMoving;
    if (std::abs(hole - core->hole) > kSameRadius) return refuse("the hole is not as narrow as the file states");
    hole = core->hole;
    takeTouching(thread, *core);
    AppliedAllowance& allowance = add(claim.yields, core->depth());
    allowance.stated = claim.allowance;
    allowance.core = true;
    allowance.most = core->depth();
    allowance.evidence = {core->depth() - core->spacing - core->margin, 0.0, core->spacing, core->margin};
    heedWord(thread, thread.pitch);
    allowance.thread = fit_.thread = thread;
    fit_.core = inFrame(inverse(claim.yields ? question_.other.X_WB : thread.assembled), *core);
    if (claim.allowance > (1.0 + kEstimate) * core->depth()) refuse("its thread is not so deep");
  }

  /// In the first configuration that shows it; it is told to the thread.
  Result<ThreadCore> findCore(Thread& thread) {
    const bool own = thread.movingIsShaft;
    const ClaimedThread claim{thread.point, thread.axis, thread.pitch, own ? thread.radiusMoving : thread.radiusOther};
    Result<ThreadCore> core(Diagnostic{});
    for (const Pose& end : question_.assembled) {
      const PlacedBody& moving = bodies_.at({question_.moving, end});
      const PlacedBody& other = bodies_.at({question_.other, question_.other.X_WB});
      core = own ? threadCoreOf(moving, other, claim) : threadCoreOf(other, moving, claim);
      thread.assembled = end;
      if (core) break;
    }
    return core;
  }

  /// Faces of the shaft beside the thread have room for what they touch.
  void takeTouching(const Thread& thread, const ThreadCore& core) {
    PairWord accepted = word_ != nullptr ? *word_ : PairWord{question_.moving.id, question_.other.id};
    accepted.accepted = true;
    findBounds(&accepted);
    const PlacedBody& moving = bodies_.at({question_.moving, thread.assembled});
    const PlacedBody& other = bodies_.at({question_.other, question_.other.X_WB});
    const bool own = thread.movingIsShaft;
    const double touching = core.spacing + core.margin + moving.largestDeflection + other.largestDeflection;
    std::vector<double> allowances = own ? bounds_.one.atMost : bounds_.other.atMost;
    const std::vector<bool> ofThread = trianglesOfThread((own ? moving : other).mesh, core);
    for (std::size_t t = 0; t < allowances.size(); ++t) {
      allowances[t] = ofThread[t] ? 0.0 : std::min(allowances[t], touching);
    }
    if (largest(allowances) > 0.0) (own ? fit_.moving : fit_.other) = std::move(allowances);
  }

  /// As the path has it where it begins or ends in the thread; that of no turn is a tenth of the diameter, so that the
  /// path is refused for not turning.
  double pitchOfPath(const Thread& thread) const {
    std::vector<Pose> path = question_.path;
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

  const PairQuestion& question_;
  const FitWords& fits_;
  PlacedBodies& bodies_;
  const StopToken& stop_;
  const PairWord* word_;
  PairBounds bounds_;
  PairFit fit_;
};

}  // namespace

PairFit fitOf(const PairQuestion& question, const FitWords& fits, PlacedBodies& bodies, const StopToken& stop) {
  return PairFitter(question, fits, bodies, stop).take();
}

}  // namespace glissade::check
