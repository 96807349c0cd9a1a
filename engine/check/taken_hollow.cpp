#include "engine/check/taken_hollow.h"

#include <algorithm>

#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

/// True if the evidence would refuse the pair without an accepted clash.
bool isClash(const PairWork& work) {
  FitWords strict = work.fits;
  strict.acceptedClash = 0.0;
  return std::any_of(work.question.assembled.begin(), work.question.assembled.end(), [&](const Pose& end) {
    const Placement moving{work.question.moving, end};
    const Placement other{work.question.other, work.question.other.X_WB};
    return !work.bodies.boundsOf(moving, other, strict, nullptr, work.stop).refused().empty();
  });
}

/// The configuration in which the two overlap deepest.
struct Overlapping {
  Pose end;
  double depth = 0.0;  ///< metres
};

Overlapping deepestEnd(const PairWork& work) {
  Overlapping deepest;
  for (const Pose& end : work.question.assembled) {
    const Placement other{work.question.other, work.question.other.X_WB};
    const double depth =
        work.bodies.boundsOf({work.question.moving, end}, other, work.fits, work.word, work.stop).depth;
    if (depth > deepest.depth) deepest = {end, depth};
  }
  return deepest;
}

Message isCut(const Body& body) { return {GLISSADE_TEXT("'%1' is the one that is cut"), {body.name}}; }

/// The reason why the body that the file cuts may not be cut; empty if it may.
Message wrongCut(Cut cut, bool yields, const PairWork& work) {
  switch (cut) {
    case Cut::NotClear: return GLISSADE_TEXT("which of the two is cut is not clear, and the user does not name it");
    case Cut::NotWhole: return GLISSADE_TEXT("what would be left of it is not one piece as before");
    case Cut::One: return yields ? isCut(work.question.moving) : Message();
    case Cut::Other: return yields ? Message() : isCut(work.question.other);
  }
  return {};
}

/// The hole that the body in the hollow one makes as a screw; nothing if it makes none.
std::optional<ScrewInSolid> screwOf(const PairWork& work, bool yields) {
  const Placement other{work.question.other, work.question.other.X_WB};
  for (const Pose& end : work.question.assembled) {
    const Placement moving{work.question.moving, end};
    const auto screw = yields ? screwInSolid(moving, other, work.bodies, work.stop)
                              : screwInSolid(other, moving, work.bodies, work.stop);
    if (screw) return screw;
  }
  return std::nullopt;
}

/// Thins the body in the hollow one on all sides.
void takeAllAround(const StatedAllowance& stated, PairWork& work) {
  const PlacedBody& moving = work.bodies.at({work.question.moving, work.question.moving.X_WB});
  const PlacedBody& other = work.bodies.at({work.question.other, work.question.other.X_WB});
  const double spacing = moving.spacing + other.spacing;
  const PlacedBody& thinner = stated.yields ? other : moving;
  const double room = hollowRoom(stated.yields ? moving : other, thinner);
  (stated.yields ? work.fit.other : work.fit.moving)
      .assign(thinner.mesh.triangles.size(), std::min(stated.allowance, room));
  AppliedAllowance& allowance = work.add(stated.yields, std::min(stated.allowance, room));
  allowance.stated = stated.allowance;
  allowance.most = room;
  const double ofWall = wallDeflection(thinner);
  allowance.evidence = {0.0, ofWall, spacing, room - ofWall - spacing, 0.0};
  if (stated.allowance > (1.0 + kEstimate) * room) work.fit.refusals.push_back(allowanceRefused(allowance, {}));
}

}  // namespace

void takeHollow(const std::vector<StatedAllowance>& stated, PairWork& work) {
  const bool isFirst = stated.front().hollow;
  const StatedAllowance& host = isFirst ? stated.front() : stated.back();
  const StatedAllowance& guest = isFirst ? stated.back() : stated.front();
  const auto refuse = [&](const StatedAllowance& claim, const Message& reason) {
    AppliedAllowance& allowance = work.add(claim.yields, 0.0);
    allowance.stated = claim.allowance;
    AppliedAllowance claimed = allowance;
    claimed.hollow = claim.hollow;
    work.fit.refusals.push_back(allowanceRefused(claimed, reason));
  };
  if (stated.size() != 2 || guest.hollow || host.yields == guest.yields || host.core || host.thread || guest.thread)
    return refuse(
        host, GLISSADE_TEXT("what overlaps is taken away of one body of a pair, and the other one has the allowance"));
  if (work.word != nullptr && work.word->isThread())
    return refuse(host, GLISSADE_TEXT("the user states that the pair is a thread"));
  work.findBounds(work.word);
  work.fit = {};
  const Overlapping at = deepestEnd(work);
  work.fit.depth = at.depth;
  if (at.depth <= 0.0) return refuse(host, GLISSADE_TEXT("no overlap with the other one can be taken away of it"));
  if (!work.fits.accepts(work.word, at.depth)) {
    work.fit.inSolid = screwOf(work, host.yields);
    if (!work.fit.inSolid) return refuse(host, clashRefused(at.depth));
    work.bounds.isPlainOverlap = false;
  }
  const Placement moving{work.question.moving, at.end};
  const Placement other{work.question.other, work.question.other.X_WB};
  if (!work.fit.inSolid) {
    const Message wrong = wrongCut(work.bodies.cutOf(moving, other, work.fits, work.stop), host.yields, work);
    if (!wrong.empty()) return refuse(host, wrong);
  }
  const MeshPtr hollow = work.bodies.hollowOf(host.yields ? other : moving, host.yields ? moving : other, work.stop);
  if (!hollow) return refuse(host, GLISSADE_TEXT("no overlap with the other one can be taken away of it"));
  (host.yields ? work.fit.hollowOther : work.fit.hollowMoving) = hollow;
  work.fit.acceptedClash = !work.fit.inSolid && isClash(work);
  AppliedAllowance& ofHost = work.add(host.yields, at.depth);
  ofHost.hollow = true;
  ofHost.screwHole = work.fit.inSolid.has_value();
  ofHost.stated = host.allowance;
  ofHost.most = at.depth;
  ofHost.evidence = {at.depth, 0.0, 0.0, 0.0, 0.0};
  takeAllAround(guest, work);
}

}  // namespace glissade::check
