#include "engine/fits/object_fits.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <utility>

#include "engine/base/depth_text.h"
#include "engine/evidence/named_screw.h"
#include "engine/fits/fit_refusals.h"
#include "engine/fits/fit_thread.h"
#include "engine/fits/fit_words.h"
#include "engine/fits/giving_way.h"
#include "engine/fits/hollow_fit.h"
#include "engine/fits/modelled_thread.h"
#include "engine/fits/object_contacts.h"
#include "engine/fits/thread_pitch.h"
#include "engine/model/designation.h"

namespace glissade {
namespace {

/// Clearance that paths keep, as a share of the assembled gap.
constexpr double kPathShare = 0.25;
/// Least clearance where paths begin, as a share of the assembled gap.
constexpr double kStartShare = 0.3;
constexpr std::array<double, 2> kBothWays{1.0, -1.0};

/// The role of the object, which is `b`, in the coaxial pair.
Fit::Role roleOf(const Contact& contact) {
  if (!contact.axis) return Fit::Role::Other;
  return contact.axis->shaftIsA ? Fit::Role::Hole : Fit::Role::Shaft;
}

/// The allowances, limited to `most` (metres).
std::vector<double> limited(std::vector<double> allowances, double most) {
  for (double& each : allowances) each = std::min(each, most);
  return allowances;
}

/// The result of a person's statement and the evidence for a contact.
struct Decision {
  ContactKind kind = ContactKind::Contact;
  bool refused = false;   ///< a clash that nobody has accepted
  bool given = false;     ///< a person states the allowance
  bool accepted = false;  ///< a person accepts a clash of this depth
};

/// The evidence, which is measured face by face, decides whether an overlap is a clash. A smaller requested limit still
/// gives the pair its kind.
Decision decide(const Contact& contact, const FitEdit* edit, bool accepted, const evidence::PairBounds& bounds,
                const ContactLimits& limits) {
  Decision decision{contact.kind, false, edit != nullptr && edit->allowance, accepted};
  const bool usual = limits.clashOverlap == ContactLimits().clashOverlap;
  const bool clash = !bounds.refused().empty();
  if (contact.kind == ContactKind::Clash && !clash && !accepted && usual) decision.kind = ContactKind::Overlap;
  if (clash) decision.kind = ContactKind::Clash;
  if (edit != nullptr && edit->kind) decision.kind = *edit->kind;
  decision.refused = !decision.given && clash;
  return decision;
}

class FitFinder {
 public:
  FitFinder(const FitQuestion& question, const StopToken& stop)
      : question_(question),
        stop_(stop),
        object_(question.product.bodies[question.object]),
        ends_(question.ends.empty() ? std::vector<Pose>{object_.X_WB} : question.ends),
        tools_(question.tools != nullptr ? *question.tools : ownTools_),
        gap_(assembledGap(radiusAboutOrigin(*object_.mesh))),
        words_(wordsOf(question.product.fits)) {
    words_.snaps = question.product.snaps;
  }

  Result<ObjectFits> find() {
    const auto contacts = findObjectContacts(question_, ends_, tools_.thinnable, stop_);
    if (!contacts) return contacts.error();
    for (const auto& [obstacle, found] : *contacts) {
      if (stop_.stopRequested()) break;
      resolve(obstacle, found);
    }
    return std::move(fits_);
  }

 private:
  const FitEdit* editAbout(std::size_t obstacle) const {
    return editOf(question_.product.fits, object_.id, body(obstacle).id);
  }
  const RigidBody& body(std::size_t index) const { return question_.product.bodies[index]; }

  /// True if the obstacle has the hook that bends; nothing if the pair is no snap.
  std::optional<bool> hookYields(std::size_t obstacle) const {
    const evidence::SnapWord* snap = words_.snapOf(object_.id, body(obstacle).id);
    return snap == nullptr ? std::nullopt : std::optional(snap->hook != object_.id);
  }

  const evidence::PairWord* wordAbout(std::size_t obstacle) const {
    return words_.about(object_.id, body(obstacle).id);
  }

  evidence::PairBounds boundsWith(std::size_t obstacle, const evidence::FitWords& words,
                                  const evidence::PairWord* word) const {
    const evidence::Body own = question_.product.measured(question_.object);
    const evidence::Body fixed = question_.product.measured(obstacle);
    std::optional<evidence::PairBounds> bounds;
    for (const Pose& end : ends_) {
      const evidence::PairBounds found = tools_.placed.boundsOf({own, end}, {fixed, fixed.X_WB}, words, word, stop_);
      bounds = bounds ? united(*bounds, found) : found;
    }
    return *bounds;
  }

  /// True if the overlap would be a clash if nobody accepted it, whatever kind the surfaces have.
  bool isAcceptedClash(std::size_t obstacle, double depth) const {
    if (depth <= 0.0 || !words_.accepts(wordAbout(obstacle), depth)) return false;
    evidence::FitWords strict = words_;
    strict.acceptedClash = 0.0;
    return !boundsWith(obstacle, strict, nullptr).refused().empty();
  }

  /// An insert or a bearing by its name is thicker than its hole by as much as a thread, and is pressed or melted in.
  bool isPressedInsert(std::size_t obstacle, const Contact& contact) const {
    if (contact.kind != ContactKind::Thread || !contact.axis) return false;
    const std::size_t shaft = contact.axis->shaftIsA ? obstacle : question_.object;
    const auto said = designationIn(question_.product.nameInFile(shaft));
    return said && (said->part == StandardPart::Insert || said->part == StandardPart::Bearing);
  }

  void resolve(std::size_t obstacle, const FoundContact& found) {
    const FitEdit* edit = editAbout(obstacle);
    const evidence::PairBounds bounds = boundsWith(obstacle, words_, wordAbout(obstacle));
    Decision decision =
        decide(found.contact, edit, words_.accepts(wordAbout(obstacle), bounds.depth), bounds, question_.limits);
    if ((edit == nullptr || !edit->kind) && isAcceptedClash(obstacle, bounds.depth)) decision.kind = ContactKind::Clash;
    Contact& contact = fits_.contacts.emplace_back(found.contact);
    contact.kind = edit == nullptr && isPressedInsert(obstacle, found.contact) ? ContactKind::Press : decision.kind;
    const bool hasDepth = decision.kind == ContactKind::Clash || decision.kind == ContactKind::Overlap;
    if (hasDepth && bounds.depth > 0.0) contact.overlap = bounds.depth;
    contact.isPlainOverlap = hasDepth && bounds.isPlainOverlap && !decision.refused;
    Fit fit{{body(obstacle).id, contact.kind, contact.overlap}, question_.object, obstacle, roleOf(contact)};
    fit.moving = object_.id;
    const bool marked = edit != nullptr && edit->kind == ContactKind::Thread;
    if (marked && found.contact.axis) fit.thread = threadOf(found, edit);
    if (fit.thread) fit.pitch = fit.thread->rule.pitch;
    if (contact.isPlainOverlap && takeScrewHole(fit, found, bounds.depth)) return;
    if (decision.refused) {
      if (!takeWithoutThread(fit, found) && !takeScrewHole(fit, found, bounds.depth))
        refuseClash(fit, found, bounds.depth);
    } else if ((found.contact.kind == ContactKind::Clearance && !hookYields(obstacle)) ||
               (bounds.one.most <= 0.0 && bounds.other.most <= 0.0)) {
      if (fit.thread) {
        fits_.allowed.push_back(fit);
      } else if (contact.kind != ContactKind::Clearance) {
        resolveCrossing(fit, found, bounds.depth);
      }
    } else if (decision.given || !isClearInThread(fit, found)) {
      if (bounds.depth > 0.0 && takeWithoutThread(fit, found)) return;
      if (fit.kind == ContactKind::Clash && namesCut(obstacle) && takeHollow(fit, found, bounds.depth)) return;
      takeThinner(fit, bounds, found, decision.accepted);
    }
  }

  /// Handles surfaces that cross although no face of one faces the other, such as a rod that is drawn through a plate:
  /// no face has an overlap, but the pair is a clash.
  void resolveCrossing(const Fit& fit, const FoundContact& found, double depth) {
    if (depth <= 0.0 || isFree(object_.mesh, fit.obstacle, body(fit.obstacle).mesh, found.at)) return;
    if (takeHollow(fit, found, depth) || takeScrewHole(fit, found, depth)) return;
    refuseClash(fit, found, depth);
  }

  /// True if a person names the one body of the pair that is cut, and states no allowance.
  bool namesCut(std::size_t obstacle) const {
    const FitEdit* edit = editAbout(obstacle);
    const bool hasAllowance = edit != nullptr && edit->allowance;
    return !hasAllowance && words_.isCut(object_.id) != words_.isCut(body(obstacle).id);
  }

  /// True if the object is clear in a modelled thread, so that it is not thinned.
  bool isClearInThread(const Fit& fit, const FoundContact& found) {
    if (fit.kind != ContactKind::Contact) return false;
    const RigidBody& other = body(fit.obstacle);
    return isFree(object_.mesh, fit.obstacle, other.mesh, found.at) &&
           !findModelledThreads(*object_.mesh, found.measuredAt, other, found.contact.gap).empty();
  }

  /// True if the object and the obstacle with these meshes are apart.
  bool isFree(const MeshPtr& object, std::size_t obstacle, const MeshPtr& mesh, const std::vector<Pose>& ends) {
    const auto query = pairOf(object, obstacle, mesh)->makeQuery();
    const double least = leastStartGap(obstacle);
    return std::all_of(ends.begin(), ends.end(), [&](const Pose& end) { return query->clearAbove(end, least); });
  }

  /// The gap is the same for either moving body, unless paths need more: else a pair would be a clash for one of them
  /// only.
  double leastStartGap(std::size_t obstacle) const {
    const double smaller = std::min(gap_, assembledGap(radiusAboutOrigin(*body(obstacle).mesh)));
    return std::max(0.5 * smaller, kStartShare * gap_);
  }

  CollisionWorldPtr pairOf(const MeshPtr& object, std::size_t obstacle, const MeshPtr& mesh) const {
    if (tools_.prepared) return tools_.prepared->world(object, {{obstacle, object, mesh}});
    RigidBody other = body(obstacle);
    other.mesh = mesh;
    return question_.world ? question_.world->updated({other}, object) : CollisionWorld::build({other}, object);
  }

  FitThread threadOf(const FoundContact& found, const FitEdit* edit) const {
    return fitThreadOf({question_.product, question_.object, found.contact, found.measuredAt, found.at, edit}, stop_);
  }

  void refuse(Fit fit, const Message& reason, const Message& advice) {
    fit.refused = reason;
    fits_.warnings.push_back({ErrorKind::InCollision,
                              "",
                              {GLISSADE_TEXT("'%1' and '%2'"), {object_.shown(), body(fit.obstacle).shown()}},
                              reason,
                              advice});
    fits_.clashes.push_back(std::move(fit));
  }

  /// A clash is advised to be accepted only where that frees the pair.
  void refuseClash(Fit fit, const FoundContact& found, double overlap) {
    fit.overlap = overlap;
    fit.allowance = overlap + found.contact.deviation;
    const bool isAccepted = words_.accepts(wordAbout(fit.obstacle), overlap);
    if (!isAccepted && fit.kind == ContactKind::Press && isPressedInsert(fit.obstacle, found.contact)) {
      refuse(fit, {GLISSADE_TEXT("overlap by %1, because the insert is pressed or melted in"), {Depth{overlap}}},
             {GLISSADE_TEXT("It is removed with its host. To press it out, accept the clash (--accept-clashes %1) and "
                            "state this for the joint."),
              {depthAsOption(overlap)}});
      return;
    }
    const evidence::Cut cut = cutOf(fit.obstacle, found);
    const bool isWhole = cut != evidence::Cut::NotWhole;
    if (isAccepted || (!isWhole && !isFreeIfAccepted(fit.obstacle, found))) {
      refuseCut(fit, cut);
      return;
    }
    const Message accept{GLISSADE_TEXT("Accept it (--accept-clashes %1), or mend the parts."),
                         {depthAsOption(overlap)}};
    const Message acceptAndName{
        GLISSADE_TEXT("Accept it and name the one that is cut (--accept-clashes %1 --cut \"%2\" or --cut \"%3\"), or "
                      "mend the parts."),
        {depthAsOption(overlap), object_.shown(), body(fit.obstacle).shown()}};
    refuse(fit, {GLISSADE_TEXT("overlap by %1, which is a clash"), {Depth{overlap}}},
           cut == evidence::Cut::NotClear ? acceptAndName : accept);
  }

  /// Refuses a clash that is accepted, or that would be refused all the same if it were.
  void refuseCut(Fit fit, evidence::Cut cut) {
    fit.cut = cut;
    const bool isNotClear = cut == evidence::Cut::NotClear;
    const CatalogueText reason = isNotClear
                                     ? GLISSADE_TEXT("overlap by %1, and which of the two is cut is not clear")
                                     : GLISSADE_TEXT("overlap by %1, and neither can be cut and stay in one piece");
    const Message named{GLISSADE_TEXT("Name the one that is cut (--cut \"%1\" or --cut \"%2\"), or mend the parts."),
                        {object_.shown(), body(fit.obstacle).shown()}};
    refuse(fit, {reason, {Depth{fit.overlap}}}, isNotClear ? named : Message(GLISSADE_TEXT("Mend the parts.")));
  }

  /// True if nothing is refused of the pair where a person accepts its clash.
  bool isFreeIfAccepted(std::size_t obstacle, const FoundContact& found) {
    ObjectFits kept = std::exchange(fits_, {});
    const double most = std::exchange(words_.acceptedClash, kAdvisedClashes);
    resolve(obstacle, found);
    const ObjectFits accepted = std::exchange(fits_, std::move(kept));
    words_.acceptedClash = most;
    for (const Fit& fit : accepted.allowed) forget(fit.thinned);
    return accepted.clashes.empty();
  }

  /// One body alone gives way where that frees the pair. Of a shaft in a hole it has to free the way along the axis,
  /// too, and the one goes first that also frees the turn about it: corners between faces that move and faces that stay
  /// move less, and a shaft that is taken thinner may be thicker at its end. Else both give way. So do two bodies of
  /// which one is below a part of a face of the other one: while they slide past each other, the part meets the rest of
  /// the face.
  void takeThinner(const Fit& fit, const evidence::PairBounds& bounds, const FoundContact& found, bool accepted) {
    const RigidBody& other = body(fit.obstacle);
    const bool isInPatches = bounds.one.mesh || bounds.other.mesh;
    std::vector<bool> order = inTurn(fit.obstacle);
    // A shaft that is thinned in a patch only does not slide out.
    if (isInPatches && hasShaft(found.contact) && !hookYields(fit.obstacle)) {
      order = {fit.role == Fit::Role::Shaft, fit.role != Fit::Role::Shaft};
    }
    std::vector<Fit> alone;
    Freedom freedom = Freedom::None;
    for (const bool yields : order) {
      if (freedom == Freedom::All) break;
      std::vector<Fit> taken = takenAlone(fit, yields, bounds, found.at);
      const Freedom own = freedomOf(taken, fit.obstacle, found);
      if (alone.empty() || own > freedom) alone.swap(taken);
      freedom = std::max(freedom, own);
      for (const Fit& unused : taken) forget(unused.thinned);
    }
    const bool needsBoth = isInPatches && !hasShaft(found.contact);
    // A pair that may be a thread has to turn. For others it is enough that the one is pulled out of the other.
    const Freedom wanted = mayBeThread(found.contact) ? Freedom::All : Freedom::Slides;
    const bool isEnough = freedom >= wanted && !needsBoth;
    const std::vector<Fit> both = isEnough ? std::vector<Fit>() : bothThinner(fit, bounds, found.at);
    const bool takesBoth =
        !both.empty() && (alone.empty() || needsBoth || freedomOf(both, fit.obstacle, found) > freedom);
    const std::vector<Fit>& taken = takesBoth ? both : alone;
    for (const Fit& unused : takesBoth ? alone : both) forget(unused.thinned);
    fits_.allowed.insert(fits_.allowed.end(), taken.begin(), taken.end());
    if (!taken.empty() || (accepted && takeHollow(fit, found, bounds.depth))) return;
    if (bounds.depth > 0.0 && cutOf(fit.obstacle, found) != evidence::Cut::NotWhole) {
      refuseClash(fit, found, bounds.depth);
      return;
    }
    const auto ownOpening = openBeside(object_, bounds.one);
    const auto othersOpening = openBeside(other, bounds.other);
    if (ownOpening && othersOpening) {
      refuse(fit, openOnBothSides(*ownOpening, *othersOpening), GLISSADE_TEXT("Close the surface of one of them."));
      return;
    }
    // The smaller allowance is reported.
    const bool fromOther = bounds.one.most <= 0.0 || (bounds.other.most > 0.0 && bounds.other.most < bounds.one.most);
    Fit lacking = fit;
    lacking.allowance = fromOther ? bounds.other.most : bounds.one.most;
    const auto opening = ownOpening ? ownOpening : othersOpening;
    refuse(lacking, opening ? noRoomBeside(lacking.allowance, *opening) : noRoom(lacking.allowance),
           GLISSADE_TEXT("Mend the parts."));
  }

  static bool mayBeThread(const Contact& contact) {
    const bool isTight = contact.kind == ContactKind::Thread || contact.kind == ContactKind::Press;
    return isTight && contact.axis &&
           isThreadDepth(std::max(contact.axis->radiusA, contact.axis->radiusB), contact.overlap);
  }

  evidence::Cut cutOf(std::size_t obstacle, const FoundContact& found) const {
    const evidence::Body own = question_.product.measured(question_.object);
    const evidence::Body other = question_.product.measured(obstacle);
    return tools_.placed.cutOf({own, found.measuredAt}, {other, other.X_WB}, words_, stop_);
  }

  /// Takes the volume of one body away from the other one, which is cut. `depth`: depth of the overlap, metres.
  bool takeHollow(const Fit& fit, const FoundContact& found, double depth) {
    if (fit.thread || !words_.accepts(wordAbout(fit.obstacle), depth)) return false;
    const evidence::Cut cut = cutOf(fit.obstacle, found);
    if (cut != evidence::Cut::One && cut != evidence::Cut::Other) return false;
    return takeHollow(fit, found, cut == evidence::Cut::Other, depth);
  }

  /// Handles a screw, by its name, in a body that is drawn without a tapped hole: the pair is a thread, and the volume
  /// of the screw is taken away from the body. A person's statement about the pair has priority.
  bool takeScrewHole(Fit fit, const FoundContact& found, double depth) {
    if (editAbout(fit.obstacle) != nullptr) return false;
    fit.kind = ContactKind::Thread;
    for (const bool yields : {true, false}) {
      const evidence::Body own = question_.product.measured(question_.object);
      const evidence::Body other = question_.product.measured(fit.obstacle);
      const evidence::Placement moving{own, found.measuredAt};
      const evidence::Placement fixed{other, other.X_WB};
      const auto screw = evidence::screwInSolid(yields ? moving : fixed, yields ? fixed : moving, tools_.placed, stop_);
      if (!screw || !takeHollow(fit, found, yields, depth)) continue;
      fits_.contacts.back().kind = ContactKind::Thread;
      fits_.contacts.back().isPlainOverlap = false;
      return true;
    }
    return false;
  }

  /// `yields`: the obstacle is the one that is cut.
  bool takeHollow(Fit host, const FoundContact& found, bool yields, double depth) {
    const auto taken = hollowFit(host.obstacle, found, yields);
    if (!taken) return false;
    Fit guest = host;
    host.hollow = true;
    host.yields = yields;
    host.thinned = taken->host;
    host.allowance = host.evidence.overlap = depth;
    guest.yields = !yields;
    guest.thinned = taken->guest;
    guest.allowance = taken->room;
    guest.evidence = {0.0, taken->surface, taken->spacing, taken->room - taken->surface - taken->spacing};
    const bool free = yields ? isFree(guest.thinned, host.obstacle, host.thinned, found.at)
                             : isFree(host.thinned, host.obstacle, guest.thinned, found.at);
    if (!free) {
      forget(host.thinned);
      forget(guest.thinned);
      return false;
    }
    fits_.allowed.push_back(std::move(host));
    fits_.allowed.push_back(std::move(guest));
    return true;
  }

  /// `yields`: the obstacle is the hollow body.
  std::optional<HollowFit> hollowFit(std::size_t obstacle, const FoundContact& found, bool yields) const {
    const evidence::Body ownBody = question_.product.measured(question_.object);
    const evidence::Body otherBody = question_.product.measured(obstacle);
    const evidence::Placement own{ownBody, found.measuredAt};
    const evidence::Placement other{otherBody, otherBody.X_WB};
    return hollowFitOf(yields ? other : own, yields ? own : other, tools_.placed, tools_.thinnable, stop_);
  }

  /// Takes away a thread that is modelled on the shaft, unless a person states something else about the pair: it comes
  /// apart by turning only.
  bool takeWithoutThread(const Fit& fit, const FoundContact& found) {
    const FitEdit* edit = editAbout(fit.obstacle);
    const bool other = edit != nullptr && edit->kind.value_or(ContactKind::Thread) != ContactKind::Thread;
    if (other || (edit != nullptr && edit->allowance)) return false;
    return takeWithoutThread(fit, found, edit, false) || takeWithoutThread(fit, found, edit, true);
  }

  bool takeWithoutThread(Fit fit, FoundContact found, const FitEdit* edit, bool yields) {
    const RigidBody& other = body(fit.obstacle);
    auto pitch = tools_.pitches.of(yields ? other.mesh : object_.mesh);
    if (!pitch) return false;
    if (edit != nullptr && edit->pitch) pitch = edit->pitch;
    evidence::PairWord accepted{object_.id, other.id};
    accepted.accepted = true;
    const evidence::PairBounds bounds = boundsWith(fit.obstacle, words_, &accepted);
    const evidence::Body ownBody = question_.product.measured(question_.object);
    const evidence::Body otherBody = question_.product.measured(fit.obstacle);
    const CoreSide own{contactBody(object_, found.measuredAt), tools_.placed.at({ownBody, found.measuredAt}),
                       bounds.one};
    const CoreSide others{contactBody(other, other.X_WB), tools_.placed.at({otherBody, other.X_WB}), bounds.other};
    const auto taken = coreFitOf(yields ? others : own, yields ? own : others, *pitch, tools_.thinnable);
    if (!taken) return false;
    if (!isFree(yields ? object_.mesh : taken->mesh, fit.obstacle, yields ? taken->mesh : other.mesh, found.at)) {
      forget(taken->mesh);
      return false;
    }
    fit.yields = yields;
    fit.thinned = taken->mesh;
    fit.allowance = taken->core.depth();
    fit.evidence = {fit.allowance - taken->core.spacing - taken->core.margin, 0.0, taken->core.spacing,
                    taken->core.margin};
    found.contact.kind = fit.kind = ContactKind::Thread;
    found.contact.axis = yields ? taken->axis : exchanged(taken->axis);
    fit.role = roleOf(found.contact);
    fit.thread = threadOf(found, edit);
    if (*pitch != fit.thread->rule.pitch) fit.thread->size.clear();
    fit.thread->rule.pitch = fit.pitch = *pitch;
    fit.core = statedThread(fit.thread->rule);
    fit.thread->rule.mayTurn = edit == nullptr || edit->turned.empty() || edit->turned == object_.id;
    fits_.contacts.back() = found.contact;
    fits_.allowed.push_back(std::move(fit));
    return true;
  }

  /// Order in which the bodies are tried for thinning; true is the obstacle. A hook that bends has no alternative.
  std::vector<bool> inTurn(std::size_t obstacle) const {
    if (const auto hook = hookYields(obstacle)) return {*hook};
    const bool otherFirst = givesWayFirst(body(obstacle), object_);
    return {otherFirst, !otherFirst};
  }

  /// Distance from the contact to an opening of the body's surface, metres, if the opening is so near that the inside
  /// is unknown.
  std::optional<double> openBeside(const RigidBody& body, const evidence::AllowanceBound& bound) const {
    const ThinnableMesh* thinnable =
        bound.most > 0.0 ? tools_.thinnable.of(bound.mesh ? bound.mesh : body.mesh) : nullptr;
    return thinnable != nullptr ? thinnable->openBeside(bound.atMost) : std::nullopt;
  }

  /// Thins one of the two bodies by its evidence, or by less if it has less room, because the deviation of free
  /// surfaces is an estimate. The least allowance is the measured overlap plus the gap.
  std::vector<Fit> takenAlone(const Fit& fit, bool yields, const evidence::PairBounds& bounds,
                              const std::vector<Pose>& ends) {
    constexpr double kShare = 0.25;
    const evidence::AllowanceBound& bound = yields ? bounds.other : bounds.one;
    const bool bends = bound.share == evidence::kHookShare;
    const double least = bends ? bound.most : std::min(bound.most, bound.largest.overlap + gap_);
    for (double allowance = bound.most;; allowance = std::max(least, kShare * allowance)) {
      if (const auto taken = thinned(fit, yields, bound, allowance)) {
        const MeshPtr& object = yields ? object_.mesh : taken->thinned;
        const MeshPtr& other = yields ? taken->thinned : body(fit.obstacle).mesh;
        if (isFree(object, fit.obstacle, other, ends)) return {*taken};
        forget(taken->thinned);
      }
      if (allowance <= least) return {};
    }
  }

  /// Empty if one of them has no room, or if thinning both does not free the pair.
  std::vector<Fit> bothThinner(const Fit& fit, const evidence::PairBounds& bounds, const std::vector<Pose>& ends) {
    const auto own = thinned(fit, false, bounds.one, bounds.one.most);
    const auto others = thinned(fit, true, bounds.other, bounds.other.most);
    if (!own || !others) return {};
    if (isFree(own->thinned, fit.obstacle, others->thinned, ends)) return {*own, *others};
    forget(own->thinned);
    forget(others->thinned);
    return {};
  }

  /// Drops unused thinned bodies, whose trees were more than half of the memory of the fits.
  void forget(const MeshPtr& thinned) {
    if (tools_.prepared) tools_.prepared->forget(thinned);
  }

  Box3 boxOf(std::size_t obstacle) const { return boundingBox(*body(obstacle).mesh, body(obstacle).X_WB); }

  /// How the object may move along the axis of the pair, and about it: a screw has to turn.
  enum class Freedom { None, Slides, All };

  Freedom freedomOf(const std::vector<Fit>& taken, std::size_t obstacle, const FoundContact& found) {
    if (taken.empty()) return Freedom::None;
    if (!hasShaft(found.contact)) return Freedom::All;
    const CollisionWorldPtr pair = pairTaken(taken, obstacle);
    if (!slides(*pair, obstacle, found)) return Freedom::None;
    return turns(*pair, found) ? Freedom::All : Freedom::Slides;
  }

  CollisionWorldPtr pairTaken(const std::vector<Fit>& taken, std::size_t obstacle) const {
    MeshPtr object = object_.mesh;
    MeshPtr other = body(obstacle).mesh;
    for (const Fit& fit : taken) (fit.yields ? other : object) = fit.thinned;
    return pairOf(object, obstacle, other);
  }

  /// The object is free at each of some angles about the axis of the pair.
  bool turns(const CollisionWorld& pair, const FoundContact& found) const {
    constexpr int kAngles = 13;  // a prime number: no polygon has so many sides
    const auto query = pair.makeQuery();
    const Vector3 axis = found.contact.axis->direction.normalized();
    const Vector3& point = found.contact.axis->point;
    for (int i = 1; i < kAngles; ++i) {
      const Quaternion turn(Eigen::AngleAxisd(2.0 * std::numbers::pi * i / kAngles, axis));
      const Vector3 arm = found.measuredAt.position - point;
      const Pose at{point + turn * arm, (turn * found.measuredAt.orientation).normalized()};
      if (!query->clearAbove(at, kPathShare * gap_)) return false;
    }
    return true;
  }

  /// The object moves along the axis of the pair, the one way or the other, until it is past the obstacle.
  bool slides(const CollisionWorld& pair, std::size_t obstacle, const FoundContact& found) const {
    const auto query = pair.makeQuery();
    const Pose& from = found.measuredAt;
    const Vector3 axis = found.contact.axis->direction.normalized();
    const double way = (boundingBox(*object_.mesh, from).sizes() + boxOf(obstacle).sizes()).norm();
    const double required = kPathShare * gap_;
    const Vector3 apart = boundingBox(*object_.mesh, from).center() - boxOf(obstacle).center();
    const double likely = apart.dot(axis) < 0.0 ? -way : way;  // to the side where the object protrudes
    return std::any_of(kBothWays.begin(), kBothWays.end(), [&](double sense) {
      Pose to = from;
      to.position += sense * likely * axis;
      return query->checkMotion(from, to, required, SeekViolation::Any, stop_).status == CertificateStatus::Certified;
    });
  }

  /// Nothing if the body has no room for the allowance.
  std::optional<Fit> thinned(Fit fit, bool yields, const evidence::AllowanceBound& bound, double allowance) const {
    if (allowance <= 0.0) return std::nullopt;
    const MeshPtr& own = yields ? body(fit.obstacle).mesh : object_.mesh;
    const MeshPtr& whole = bound.mesh ? bound.mesh : own;
    fit.thinned = tools_.thinnable.thinned(whole, limited(bound.atMost, allowance), bound.share);
    if (!fit.thinned) return std::nullopt;
    fit.yields = yields;
    fit.allowance = allowance;
    fit.evidence = bound.largest;
    return fit;
  }

  const FitQuestion& question_;
  const StopToken& stop_;
  const RigidBody& object_;
  std::vector<Pose> ends_;
  FitTools ownTools_;
  FitTools& tools_;
  double gap_;
  evidence::FitWords words_;
  ObjectFits fits_;
};

}  // namespace

Result<ObjectFits> findObjectFits(const FitQuestion& question, const StopToken& stop) {
  return FitFinder(question, stop).find();
}

double assembledGap(double objectRadius) { return evidence::assembledMargin(objectRadius); }

}  // namespace glissade
