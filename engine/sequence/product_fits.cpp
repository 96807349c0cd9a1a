#include "engine/sequence/product_fits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/geometry/thinned_mesh.h"

namespace glissade {
namespace {

/// The same contact with its bodies exchanged.
Contact exchanged(Contact contact) {
  std::swap(contact.a, contact.b);
  if (contact.axis) {
    std::swap(contact.axis->radiusA, contact.axis->radiusB);
    contact.axis->shaftIsA = !contact.axis->shaftIsA;
  }
  return contact;
}

/// Contacts of the body, which becomes `b`.
std::vector<Contact> contactsOf(std::size_t body, const ContactReport& report) {
  std::vector<Contact> own;
  for (const Contact& contact : report.contacts) {
    if (contact.b == body) own.push_back(contact);
    if (contact.a == body) own.push_back(exchanged(contact));
  }
  return own;
}

ContactReport contactsOf(const AssembledProduct& product, const StopToken& stop) {
  return findContacts(contactBodiesOf(product), {}, stop);
}

std::vector<Vector3> axesOf(const std::vector<Contact>& contacts) {
  constexpr double kAlike = 1.0 - 1e-6;
  std::vector<Vector3> axes;
  for (const Contact& contact : contacts) {
    if (!contact.axis) continue;
    const Vector3& axis = contact.axis->direction;
    const bool known =
        std::any_of(axes.begin(), axes.end(), [&](const Vector3& other) { return std::abs(other.dot(axis)) > kAlike; });
    if (!known) axes.push_back(axis);
  }
  return axes;
}

MeshPtr thinned(const MeshPtr& mesh, const check::AllowanceBound& bound) {
  const auto thinnable = bound.most > 0.0 ? ThinnableMesh::of(*mesh) : std::nullopt;
  auto thinner = thinnable ? thinnable->thinned(bound.atMost) : std::nullopt;
  return thinner ? std::make_shared<const TriangleMesh>(std::move(*thinner)) : nullptr;
}

/// Who gives way where the body alone has no place for the allowance.
struct GivingWay {
  std::optional<Fit> body;   ///< as well
  std::optional<Fit> other;  ///< nothing: there is no way
};

/// A nut's wall is too thin for what the bolt's shaft has place for. Which of the two is taken thinner makes no
/// difference to the gap between them. Where neither has place for all of it, both are taken thinner.
GivingWay givingWay(const AssembledProduct& product, std::size_t body, const Fit& clash) {
  const RigidBody& own = product.bodies[body];
  RigidBody other = product.bodies[clash.obstacle];
  Fit yielding = clash;
  yielding.thinned = thinned(other.mesh, clash.bounds->other);
  if (!yielding.thinned) return {};
  yielding.allowance = clash.bounds->other.most;
  yielding.evidence = clash.bounds->other.largest;
  other.mesh = yielding.thinned;
  const double gap = assembledGap(radiusAboutOrigin(*own.mesh));
  const auto pair = CollisionWorld::build({other}, own.mesh);
  if (pair->makeQuery()->clearAbove(own.X_WB, 0.5 * gap)) return {std::nullopt, yielding};
  Fit thinner = clash;
  thinner.thinned = thinned(own.mesh, clash.bounds->one);
  if (!thinner.thinned) return {};
  const bool free = pair->withObject(thinner.thinned)->makeQuery()->clearAbove(own.X_WB, 0.5 * gap);
  return free ? GivingWay{thinner, yielding} : GivingWay{};
}

}  // namespace

Result<ObjectFits> fitsOfBody(const AssembledProduct& product, std::size_t body, const ContactReport* contacts,
                              const StopToken& stop, check::PlacedBodies* placed) {
  // The body itself is no obstacle: those behind it move up by one.
  std::vector<RigidBody> obstacles = product.bodies;
  std::vector<double> deflections = product.deflections;
  const auto place = static_cast<std::ptrdiff_t>(body);
  obstacles.erase(obstacles.begin() + place);
  deflections.erase(deflections.begin() + place);
  deflections.push_back(product.deflections[body]);
  FitQuestion question{obstacles, product.bodies[body], {product.bodies[body].X_WB}, deflections, product.fits};
  question.placed = placed;
  std::vector<Contact> own;
  if (contacts != nullptr) {
    own = contactsOf(body, *contacts);
    for (Contact& contact : own) contact.a -= contact.a > body ? 1 : 0;
    question.contacts = &own;
  }
  auto fits = findObjectFits(question, stop);
  if (!fits) return fits.error();
  for (auto* list : {&fits->allowed, &fits->clashes}) {
    for (Fit& fit : *list) fit.obstacle += fit.obstacle >= body ? 1 : 0;
  }
  return fits;
}

Result<ProductFits> ProductFits::find(const AssembledProduct& product, ThreadTeam& team, const StopToken& stop) {
  ProductFits found;
  found.moving_.resize(product.bodies.size());
  const bool on = product.fits.on;
  const ContactReport contacts = on ? contactsOf(product, stop) : ContactReport();
  std::vector<Result<ObjectFits>> fits(product.bodies.size(), ObjectFits());
  check::PlacedBodies placed;
  team.run(fits.size(), [&](std::size_t body) {
    Moving& moving = found.moving_[body];
    moving.whole = product.bodies[body].mesh;
    if (!on || stop.stopRequested()) return;
    moving.axes = glissade::axesOf(contactsOf(body, contacts));
    fits[body] = fitsOfBody(product, body, &contacts, stop, &placed);
    if (fits[body]) moving.allowed = fits[body]->allowed;
  });
  if (stop.stopRequested()) {
    return Diagnostic{ErrorKind::Interrupted, "", "", "was stopped while fits were searched", "Start again."};
  }
  for (const Result<ObjectFits>& ofBody : fits) {
    if (!ofBody) return ofBody.error();
    for (const Diagnostic& warning : ofBody->warnings) found.warnings_.push_back(warning);
  }
  found.contacts_ = contacts.contacts;
  found.resolveClashes(product, fits, team);
  return found;
}

void ProductFits::resolveClashes(const AssembledProduct& product, const std::vector<Result<ObjectFits>>& fits,
                                 ThreadTeam& team) {
  std::vector<std::pair<std::size_t, Fit>> open;
  for (std::size_t body = 0; body < moving_.size(); ++body) {
    for (const Fit& clash : fits[body]->clashes) {
      if (clash.bounds) open.emplace_back(body, clash);
    }
  }
  std::vector<GivingWay> ways(open.size());
  team.run(open.size(), [&](std::size_t i) { ways[i] = givingWay(product, open[i].first, open[i].second); });
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto& [body, fit] = open[i];
    if (!ways[i].other) continue;
    if (ways[i].body) moving_[body].allowed.push_back(*ways[i].body);
    moving_[body].yielding.push_back(*ways[i].other);
    const std::string pair = "'" + product.bodies[body].name + "' and '" + product.bodies[fit.obstacle].name + "'";
    std::erase_if(warnings_, [&](const Diagnostic& warning) { return warning.location == pair; });
  }
}

std::vector<BodyFit> ProductFits::fitsOf(const BodyGroup& group, const BodySet& present) const {
  const BodySet others = without(present, group);
  std::vector<BodyFit> fits;
  for (const std::size_t body : group) {
    for (const Fit& fit : moving_[body].allowed) {
      if (others[fit.obstacle]) fits.push_back({body, fit, false});
    }
    for (const Fit& fit : moving_[body].yielding) {
      if (others[fit.obstacle]) fits.push_back({body, fit, true});
    }
  }
  return fits;
}

const MeshPtr& ProductFits::obstacleFor(std::size_t body, std::size_t other) const {
  const Moving& moving = moving_[body];
  for (const Fit& fit : moving.yielding) {
    if (fit.obstacle == other) return fit.thinned;
  }
  return moving_[other].whole;
}

const MeshPtr& ProductFits::meshAgainst(std::size_t body, std::size_t other) const {
  const Moving& moving = moving_[body];
  for (const Fit& fit : moving.allowed) {
    if (fit.obstacle == other && fit.thinned) return fit.thinned;
  }
  return moving.whole;
}

const FitThread* ProductFits::threadOf(std::size_t body, std::size_t other) const {
  for (const auto* fits : {&moving_[body].allowed, &moving_[body].yielding}) {
    for (const Fit& fit : *fits) {
      if (fit.obstacle == other && fit.thread) return &*fit.thread;
    }
  }
  return nullptr;
}

bool ProductFits::isInThread(const BodyGroup& group, const BodySet& present) const {
  const std::vector<BodyFit> fits = fitsOf(group, present);
  return std::any_of(fits.begin(), fits.end(), [](const BodyFit& each) { return each.fit.thread.has_value(); });
}

}  // namespace glissade
