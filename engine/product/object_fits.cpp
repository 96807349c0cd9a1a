#include "engine/product/object_fits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "engine/geometry/thinned_mesh.h"
#include "engine/product/common_axis.h"
#include "engine/product/fit_rules.h"
#include "engine/product/loose_nut.h"
#include "engine/product/modelled_thread.h"
#include "engine/product/thread_pitch.h"

namespace glissade {
namespace {

std::string millimetres(double metres) {
  std::ostringstream text;
  text.precision(3);
  text << metres * 1e3 << " mm";
  return text.str();
}

/// A contact of the object with an obstacle, and at which of the ends.
struct FoundContact {
  Contact contact;
  std::vector<Pose> at;
  Pose measuredAt{};  ///< the end that the contact was measured at
};

/// Those of the ends in which the object's axis is the same line as in the first one. Its thread may be in another
/// hole of the obstacle in the others.
std::vector<Pose> onAxis(const ContactAxis& axis, const Pose& first, const std::vector<Pose>& ends) {
  constexpr double kSame = 1e-5;
  const Vector3 point_B = inverse(first) * axis.point;
  std::vector<Pose> same{first};
  for (const Pose& end : ends) {
    const Vector3 p = end * point_B - axis.point;
    const Vector3 direction = end.orientation * (first.orientation.conjugate() * axis.direction);
    const bool isSame = p.cross(axis.direction).norm() < kSame && direction.cross(axis.direction).norm() < kSame;
    if (isSame && end != first) same.push_back(end);
  }
  return same;
}

double measured(const Contact& contact) { return contact.overlap + contact.deviation; }

/// The object's place in the coaxial pair; it is `b`, as the last of all bodies.
Fit::Role roleOf(const Contact& contact) {
  if (!contact.axis) return Fit::Role::Other;
  return contact.axis->shaftIsA ? Fit::Role::Hole : Fit::Role::Shaft;
}

class FitFinder {
 public:
  FitFinder(const FitQuestion& question, const StopToken& stop)
      : question_(question),
        stop_(stop),
        gap_(assembledGap(radiusAboutOrigin(*question.object.mesh))),
        words_(wordsOf(question.settings)) {}

  Result<ObjectFits> find() {
    if (const Outcome known = checkBodies(); !known) return known.error();
    findContactsAtEnds();
    if (const Outcome marked = addMarkedThreads(); !marked) return marked.error();
    if (const Outcome sound = checkAllowances(); !sound) return sound.error();
    for (const auto& [obstacle, found] : contacts_) {
      if (stop_.stopRequested()) break;
      decide(obstacle, found);
    }
    return std::move(fits_);
  }

 private:
  const std::vector<FitEdit>& edits() const { return question_.settings.pairs; }

  static Diagnostic refused(std::size_t edit, const std::string& reason, const std::string& advice) {
    return {ErrorKind::MalformedInput, "", "/fits/pairs/" + std::to_string(edit), reason, advice};
  }

  Outcome checkBodies() const {
    for (std::size_t i = 0; i < edits().size(); ++i) {
      for (const std::string& id : {edits()[i].a, edits()[i].b}) {
        const bool known =
            id == question_.object.id || std::any_of(question_.obstacles.begin(), question_.obstacles.end(),
                                                     [&](const RigidBody& body) { return body.id == id; });
        if (!known) {
          return refused(i, "names the body '" + id + "', which is not there",
                         "See 'glissade-cli fits' for the names.");
        }
      }
    }
    return Done{};
  }

  void findContactsAtEnds() {
    if (question_.contacts != nullptr) {
      for (const Contact& contact : *question_.contacts) {
        contacts_.emplace(contact.a, FoundContact{contact, {question_.ends.front()}, question_.ends.front()});
      }
      return;
    }
    std::vector<ContactBody> bodies;
    for (std::size_t i = 0; i < question_.obstacles.size(); ++i) {
      const RigidBody& body = question_.obstacles[i];
      bodies.push_back({body.id, body.mesh, body.X_WB, question_.deflections[i]});
    }
    bodies.push_back({question_.object.id, question_.object.mesh, {}, question_.deflections.back()});
    ContactLimits limits;
    limits.only = bodies.size() - 1;
    for (const Pose& end : question_.ends) {
      bodies.back().X_WB = end;
      for (const Contact& contact : findContacts(bodies, limits, stop_).contacts) {
        FoundContact& found = contacts_.try_emplace(contact.a, FoundContact{contact, {}, end}).first->second;
        if (measured(contact) > measured(found.contact)) found = {contact, std::move(found.at), end};
        found.at.push_back(end);
      }
    }
  }

  Outcome checkAllowances() {
    for (std::size_t i = 0; i < edits().size(); ++i) {
      const FitEdit& edit = edits()[i];
      if (!edit.allowance || *edit.allowance == 0.0) continue;
      if (edit.a != question_.object.id && edit.b != question_.object.id) continue;
      const std::string& other = edit.a == question_.object.id ? edit.b : edit.a;
      const bool touches = std::any_of(contacts_.begin(), contacts_.end(),
                                       [&](const auto& entry) { return question_.obstacles[entry.first].id == other; });
      if (!touches) {
        return refused(i,
                       "allows for '" + edit.a + "' and '" + edit.b + "', which do not touch where they are assembled",
                       "Remove the allowance.");
      }
      const double most = thinnable() ? kMostThinning * thinnable()->thickness() : 0.0;
      if (*edit.allowance > most) {
        return refused(i,
                       "allows " + millimetres(*edit.allowance) + ", more than the thickness of '" +
                           question_.object.id + "' gives",
                       "Give at most " + millimetres(most) + ".");
      }
    }
    return Done{};
  }

  ContactBody contactBody(const RigidBody& body, const Pose& X_WB) const { return {body.id, body.mesh, X_WB, 0.0}; }

  /// Pairs that a person calls a thread need not touch.
  Outcome addMarkedThreads() {
    for (std::size_t obstacle = 0; obstacle < question_.obstacles.size(); ++obstacle) {
      const RigidBody& other = question_.obstacles[obstacle];
      const FitEdit* edit = editOf(question_.settings, question_.object.id, other.id);
      if (edit == nullptr || edit->kind != ContactKind::Thread) continue;
      const auto known = contacts_.find(obstacle);
      if (known != contacts_.end() && known->second.contact.axis) continue;
      FoundContact found{
          Contact{obstacle, question_.obstacles.size(), ContactKind::Clearance, 0, 0, 0, 0, 0, {}}, {}, {}};
      if (known != contacts_.end()) found = known->second;
      for (const Pose& end : question_.ends) {
        const auto axis = commonAxisOf(contactBody(other, other.X_WB), contactBody(question_.object, end));
        if (!axis) continue;
        if (!found.contact.axis) found.measuredAt = end;
        if (!found.contact.axis) found.contact.axis = axis;
        if (known == contacts_.end()) found.at.push_back(end);
      }
      if (!found.contact.axis) {
        return refused(static_cast<std::size_t>(edit - edits().data()),
                       "calls '" + edit->a + "' and '" + edit->b +
                           "' a thread, but no shaft of the one is on the axis of a hole of the other",
                       "Give another kind.");
      }
      contacts_[obstacle] = std::move(found);
    }
    return Done{};
  }

  const ThinnableMesh* thinnable() {
    if (!measuredObject_) {
      measuredObject_ = true;
      thinnable_ = ThinnableMesh::of(*question_.object.mesh);
    }
    return thinnable_ ? &*thinnable_ : nullptr;
  }

  check::Body measuredBody(const RigidBody& body, std::size_t number) const {
    const double spacing = question_.spacings.empty() ? 0.0 : question_.spacings[number];
    return {body.id, body.name, body.mesh, body.X_WB, spacing, question_.deflections[number]};
  }

  check::PairBounds boundsWith(std::size_t obstacle) {
    check::PlacedBodies& placed = question_.placed != nullptr ? *question_.placed : placed_;
    const RigidBody& other = question_.obstacles[obstacle];
    const check::Body own = measuredBody(question_.object, question_.obstacles.size());
    const check::Body fixed = measuredBody(other, obstacle);
    const check::PairWord* word = words_.about(question_.object.id, other.id);
    std::optional<check::PairBounds> bounds;
    for (const Pose& end : question_.ends) {
      const check::PairBounds found = placed.boundsOf({own, end}, {fixed, other.X_WB}, words_, word, stop_);
      bounds = bounds ? check::PairBounds{united(bounds->one, found.one), united(bounds->other, found.other)} : found;
    }
    return *bounds;
  }

  void decide(std::size_t obstacle, const FoundContact& found) {
    const FitEdit* edit = editOf(question_.settings, question_.object.id, question_.obstacles[obstacle].id);
    const auto bounds = std::make_shared<const check::PairBounds>(boundsWith(obstacle));
    const FitDecision decision = decideFit(found.contact, edit, question_.settings, bounds->one);
    Fit fit{obstacle, decision.kind, roleOf(found.contact), found.contact.overlap, decision.allowance};
    fit.evidence = bounds->one.largest;
    const bool marked = edit != nullptr && edit->kind == ContactKind::Thread;
    if (marked && found.contact.axis) fit.thread = threadOf(found, edit);
    if (decision.refused) {
      refuse(fit, "overlap by " + millimetres(fit.overlap) + ", which is a clash",
             "Accept it (--accept-clashes " + millimetresUp(fit.overlap) + "), or mend the parts.");
    } else if (found.contact.kind == ContactKind::Clearance || bounds->one.most <= 0.0) {
      fit.allowance = 0.0;
      if (fit.thread) fits_.allowed.push_back(fit);
    } else if (decision.given || !isClearInThread(fit, found)) {
      fit.bounds = bounds;
      takeThinner(fit, found.at);
    }
  }

  /// The object moves clear in a thread that is modelled: it is taken as it is.
  bool isClearInThread(const Fit& fit, const FoundContact& found) {
    if (fit.kind != ContactKind::Contact) return false;
    const RigidBody& other = question_.obstacles[fit.obstacle];
    return isFree(question_.object.mesh, fit.obstacle, found.at) &&
           !findModelledThreads(*question_.object.mesh, found.measuredAt, other, found.contact.gap).empty();
  }

  /// The object taken so, and alone with its obstacle.
  bool isFree(const MeshPtr& object, std::size_t obstacle, const std::vector<Pose>& ends) {
    auto& [known, world] = alone_;
    world = world && known == obstacle ? world->withObject(object) : worldOf(question_.obstacles[obstacle], object);
    known = obstacle;
    const auto query = world->makeQuery();
    return std::all_of(ends.begin(), ends.end(), [&](const Pose& end) { return query->clearAbove(end, 0.5 * gap_); });
  }

  FitThread threadOf(const FoundContact& found, const FitEdit* edit) const {
    const ContactAxis& axis = *found.contact.axis;
    FitThread thread;
    ThreadRule& rule = thread.rule;
    rule.obstacle = static_cast<int>(found.contact.a);
    rule.point_W = axis.point;
    rule.axis_W = axis.direction.normalized();
    rule.radiusOfObstacle = axis.radiusA;
    rule.radiusOfObject = axis.radiusB;
    rule.objectIsShaft = !axis.shaftIsA;
    rule.assembled = onAxis(axis, found.measuredAt, found.at);
    rule.mayTurn = mayTurn(rule, axis, edit);
    if (edit != nullptr && edit->pitch) {
      rule.pitch = *edit->pitch;
      return thread;
    }
    const ThreadPitch coarse = isoCoarsePitch(rule.objectIsShaft ? axis.radiusB : axis.radiusA);
    rule.pitch = coarse.pitch;
    thread.size = coarse.size;
    return thread;
  }

  bool mayTurn(const ThreadRule& rule, const ContactAxis& axis, const FitEdit* edit) const {
    if (edit != nullptr && !edit->turned.empty()) return edit->turned == question_.object.id;
    if (!rule.objectIsShaft) return true;
    std::vector<const RigidBody*> others;
    for (std::size_t i = 0; i < question_.obstacles.size(); ++i) {
      if (static_cast<int>(i) != rule.obstacle) others.push_back(&question_.obstacles[i]);
    }
    return !isLooseNut(question_.obstacles[static_cast<std::size_t>(rule.obstacle)], axis, others, stop_);
  }

  /// An option's value that is not below it.
  static std::string millimetresUp(double metres) {
    std::ostringstream text;
    text << std::ceil(metres * 1e5) / 1e2 << "mm";
    return text.str();
  }

  void refuse(const Fit& fit, const std::string& reason, const std::string& advice) {
    fits_.clashes.push_back(fit);
    fits_.warnings.push_back({ErrorKind::InCollision, "",
                              "'" + question_.object.name + "' and '" + question_.obstacles[fit.obstacle].name + "'",
                              reason, advice});
  }

  /// What the evidence gives, or less of it where the object has no place for that: the deviation of free surfaces is
  /// an estimate. Down to the overlap as measured and the gap.
  void takeThinner(Fit fit, const std::vector<Pose>& ends) {
    if (thinnable() == nullptr) {
      refuse(fit, "touch, and the object cannot be taken thinner because its surface is not closed",
             "Close the object's surface.");
      return;
    }
    constexpr double kShare = 0.25;
    const double most = fit.allowance;
    const double least = std::min(most, fit.evidence.overlap + gap_);
    for (double allowance = most;; allowance = std::max(least, kShare * allowance)) {
      auto mesh = thinnable()->thinned(limited(fit.bounds->one.atMost, allowance));
      if (mesh) {
        fit.thinned = std::make_shared<const TriangleMesh>(std::move(*mesh));
        fit.allowance = allowance;
        if (isFree(fit.thinned, fit.obstacle, ends)) {
          fits_.allowed.push_back(std::move(fit));
          return;
        }
      }
      if (allowance <= least) break;
    }
    fit.allowance = most;
    fit.thinned = nullptr;
    refuse(fit,
           "fit so that the object would have to be taken " + millimetres(fit.allowance) +
               " thinner, which its local thickness or its shape does not give: it counts as a clash",
           "Mend the parts.");
  }

  CollisionWorldPtr worldOf(const RigidBody& obstacle, const MeshPtr& object) const {
    return question_.world ? question_.world->updated({obstacle}, object) : CollisionWorld::build({obstacle}, object);
  }

  const FitQuestion& question_;
  const StopToken& stop_;
  double gap_;
  std::map<std::size_t, FoundContact> contacts_;  ///< by obstacle
  bool measuredObject_ = false;
  std::optional<ThinnableMesh> thinnable_;
  std::pair<std::size_t, CollisionWorldPtr> alone_{};  ///< an obstacle alone with the object, as it was last asked of
  check::FitWords words_;
  check::PlacedBodies placed_;
  ObjectFits fits_;
};

}  // namespace

Result<ObjectFits> findObjectFits(const FitQuestion& question, const StopToken& stop) {
  return FitFinder(question, stop).find();
}

namespace {

/// The fits as variants of the object. `screwed`: those of threads, too.
std::vector<ObjectVariant> variantsOf(const std::vector<Fit>& fits, bool screwed) {
  std::vector<ObjectVariant> variants;
  for (const Fit& fit : fits) {
    if (!fit.thinned || (fit.thread && !screwed)) continue;
    ObjectVariant variant;
    variant.object = fit.thinned;
    variant.obstacles.push_back(static_cast<int>(fit.obstacle));
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace

std::vector<double> limited(std::vector<double> allowances, double most) {
  for (double& each : allowances) each = std::min(each, most);
  return allowances;
}

CollisionWorldPtr withFits(const CollisionWorldPtr& world, const std::vector<Fit>& fits) {
  CollisionWorldPtr screwed = world->withVariants(variantsOf(fits, true));
  const std::vector<ThreadRule> rules = threadRulesOf(fits);
  if (rules.empty()) return screwed;
  std::vector<ThreadPair> pairs;
  for (const ThreadRule& rule : rules) {
    pairs.emplace_back(rule, world->object(), world->obstacles()[static_cast<std::size_t>(rule.obstacle)]);
  }
  return screwed->withThreads(std::move(pairs), world->withVariants(variantsOf(fits, false)));
}

std::vector<ThreadRule> threadRulesOf(const std::vector<Fit>& fits) {
  std::vector<ThreadRule> rules;
  for (const Fit& fit : fits) {
    if (!fit.thread) continue;
    rules.push_back(fit.thread->rule);
    rules.back().obstacle = static_cast<int>(fit.obstacle);
  }
  return rules;
}

double assembledGap(double objectRadius) { return check::assembledMargin(objectRadius); }

std::string inWords(const Fit& fit, const std::string& object, const std::string& obstacle) {
  std::string where = " against " + obstacle;
  if (fit.role == Fit::Role::Shaft) {
    where = (fit.kind == ContactKind::Thread ? " in the tapped hole of " : " in the hole of ") + obstacle;
  } else if (fit.role == Fit::Role::Hole) {
    where = (fit.kind == ContactKind::Thread ? " on the thread of " : " on the shaft of ") + obstacle;
  }
  std::string words =
      object + " taken " + millimetres(fit.allowance) + " thinner" + where + " (" + kindName(fit.kind) + ")";
  if (!fit.thread) return words;
  words += ", pitch " + millimetres(fit.thread->rule.pitch);
  return fit.thread->size.empty() ? words : words + " (ISO coarse, " + fit.thread->size + ")";
}

std::string turnsInWords(double turns) {
  if (turns <= 0.0) return {};
  std::ostringstream text;
  text.precision(3);
  text << ", " << turns << " turns";
  return text.str();
}

}  // namespace glissade
