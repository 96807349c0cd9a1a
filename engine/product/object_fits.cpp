#include "engine/product/object_fits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "engine/base/tolerances.h"
#include "engine/geometry/thinned_mesh.h"
#include "engine/product/common_axis.h"
#include "engine/product/fit_rules.h"
#include "engine/product/loose_nut.h"
#include "engine/product/modelled_thread.h"
#include "engine/product/thread_pitch.h"

namespace glissade {
namespace {

/// Tries of an allowance: factors of what was measured, and what is added, metres. Fitted surfaces that are within 3
/// micrometres touch, and deflections are estimates.
struct Raise {
  double factor;
  double addition;
};
constexpr std::array<Raise, 4> kRaises{{{1.0, 0.0}, {1.0, 3e-6}, {1.5, 6e-6}, {2.0, 6e-6}}};

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
      : question_(question), stop_(stop), gap_(assembledGap(radiusAboutOrigin(*question.object.mesh))) {}

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

  void decide(std::size_t obstacle, const FoundContact& found) {
    const FitEdit* edit = editOf(question_.settings, question_.object.id, question_.obstacles[obstacle].id);
    const FitDecision decision = decideFit(found.contact, edit, question_.settings, gap_);
    Fit fit{obstacle, decision.kind, roleOf(found.contact), found.contact.overlap, decision.allowance};
    const bool marked = edit != nullptr && edit->kind == ContactKind::Thread;
    if (marked && found.contact.axis) fit.thread = threadOf(found, edit);
    if (decision.refused) {
      refuse(fit, "overlap by " + millimetres(fit.overlap) + ", which is a clash",
             "Accept it (--accept-clashes " + millimetresUp(fit.overlap) + "), or mend the parts.");
    } else if (found.contact.kind == ContactKind::Clearance) {
      fit.allowance = 0.0;
      fits_.allowed.push_back(fit);
    } else if (!decision.given && !isClearInThread(fit, found)) {
      raiseUntilFree(fit, found.at);
    } else if (decision.given && fit.allowance > 0.0) {
      fits_.allowed.push_back(fit);
    }
  }

  /// The object moves clear in a thread that is modelled: it is taken as it is.
  bool isClearInThread(const Fit& fit, const FoundContact& found) {
    if (fit.kind != ContactKind::Contact) return false;
    Fit whole = fit;
    whole.allowance = 0.0;
    const RigidBody& other = question_.obstacles[fit.obstacle];
    return isFree(whole, found.at) &&
           !findModelledThreads(*question_.object.mesh, found.measuredAt, other, found.contact.gap).empty();
  }

  /// Taken so, and alone with its obstacle.
  bool isFree(const Fit& fit, const std::vector<Pose>& ends) {
    const auto query = queryOf(fit);
    return query &&
           std::all_of(ends.begin(), ends.end(), [&](const Pose& end) { return query->clearAbove(end, 0.5 * gap_); });
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

  void raiseUntilFree(Fit fit, const std::vector<Pose>& ends) {
    if (thinnable() == nullptr) {
      refuse(fit, "touch, and the object cannot be taken thinner because its surface is not closed",
             "Close the object's surface.");
      return;
    }
    const double usual = fit.allowance;
    for (const Raise& raise : kRaises) {
      fit.allowance = raise.factor * usual + raise.addition;
      if (!isFree(fit, ends)) continue;
      allow(fit);
      return;
    }
    const double refused = fit.allowance;
    if (lowerUntilFree(fit, usual, ends)) return;
    fit.allowance = refused;
    refuse(fit,
           "fit so that the object would have to be taken " + millimetres(fit.allowance) +
               " thinner, which its local thickness or its shape does not give: it counts as a clash",
           "Mend the parts.");
  }

  /// One that the object was thinned for.
  void allow(Fit fit) {
    fit.thinned = thinned_.at(fit.allowance);
    fits_.allowed.push_back(std::move(fit));
  }

  /// The deviation of free surfaces is an estimate. Where the object has no place for it, less of it is taken, down to
  /// the overlap as measured and the gap.
  bool lowerUntilFree(Fit fit, double usual, const std::vector<Pose>& ends) {
    constexpr double kShare = 0.25;
    const double least = fit.overlap + gap_;
    for (double allowance = kShare * usual; fit.allowance > least; allowance *= kShare) {
      fit.allowance = std::max(least, allowance);
      if (!isFree(fit, ends)) continue;
      allow(fit);
      return true;
    }
    return false;
  }

  /// Of the thinned object against its obstacle alone; null where the object cannot be thinned so.
  std::unique_ptr<CollisionQuery> queryOf(const Fit& fit) {
    MeshPtr& thinned = thinned_[fit.allowance];
    if (fit.allowance <= 0.0) thinned = question_.object.mesh;
    if (!thinned) {
      auto mesh = thinnable()->thinned(fit.allowance);
      if (!mesh) return nullptr;
      thinned = std::make_shared<const TriangleMesh>(std::move(*mesh));
    }
    auto& [obstacle, world] = alone_;
    const bool known = world && obstacle == fit.obstacle;
    world = known ? world->withObject(thinned) : worldOf(question_.obstacles[fit.obstacle], thinned);
    obstacle = fit.obstacle;
    return world->makeQuery();
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
  std::map<double, MeshPtr> thinned_;                  ///< by allowance
  std::pair<std::size_t, CollisionWorldPtr> alone_{};  ///< an obstacle alone with the object, as it was last asked of
  ObjectFits fits_;
};

}  // namespace

Result<ObjectFits> findObjectFits(const FitQuestion& question, const StopToken& stop) {
  return FitFinder(question, stop).find();
}

namespace {

/// The fits as variants of the object. `screwed`: those of threads, too.
std::vector<ObjectVariant> variantsOf(const std::vector<Fit>& fits, const TriangleMesh& mesh, bool screwed) {
  std::map<double, ObjectVariant> byAllowance;
  for (const Fit& fit : fits) {
    if (fit.allowance <= 0.0 || (fit.thread && !screwed)) continue;
    ObjectVariant& variant = byAllowance[fit.allowance];
    variant.obstacles.push_back(static_cast<int>(fit.obstacle));
    if (fit.thinned) variant.object = fit.thinned;
  }
  const bool known = std::all_of(byAllowance.begin(), byAllowance.end(),
                                 [](const auto& entry) { return entry.second.object != nullptr; });
  const auto object = known ? std::nullopt : ThinnableMesh::of(mesh);
  std::vector<ObjectVariant> variants;
  for (auto& [allowance, variant] : byAllowance) {
    if (!variant.object) {
      auto thinned = object ? object->thinned(allowance) : std::nullopt;
      if (thinned) variant.object = std::make_shared<const TriangleMesh>(std::move(*thinned));
    }
    if (variant.object) variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace

CollisionWorldPtr withFits(const CollisionWorldPtr& world, const std::vector<Fit>& fits) {
  CollisionWorldPtr screwed = world->withVariants(variantsOf(fits, world->object(), true));
  const std::vector<ThreadRule> rules = threadRulesOf(fits);
  if (rules.empty()) return screwed;
  std::vector<ThreadPair> pairs;
  for (const ThreadRule& rule : rules) {
    pairs.emplace_back(rule, world->object(), world->obstacles()[static_cast<std::size_t>(rule.obstacle)]);
  }
  return screwed->withThreads(std::move(pairs), world->withVariants(variantsOf(fits, world->object(), false)));
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

std::vector<double> allowancesOf(const std::vector<Fit>& fits, std::size_t count) {
  std::vector<double> allowances(fits.empty() ? 0 : count, 0.0);
  for (const Fit& fit : fits) allowances[fit.obstacle] = fit.allowance;
  return allowances;
}

double assembledGap(double objectRadius) {
  constexpr double kLeast = 1e-6;
  constexpr double kClearances = 4.0;
  return std::max(kLeast, kClearances * tolerance::kRequiredClearance * objectRadius);
}

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
