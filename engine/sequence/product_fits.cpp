#include "engine/sequence/product_fits.h"

#include <algorithm>
#include <cmath>
#include <map>
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

/// Meshes of a product thinned by what fits allow, each once.
class ThinnedMeshes {
 public:
  /// The mesh itself where it cannot be thinned so.
  const MeshPtr& thinned(const MeshPtr& mesh, double allowance) {
    MeshPtr& known = thinned_[{mesh, allowance}];
    if (known) return known;
    auto& thinnable = thinnable_.try_emplace(mesh).first->second;
    if (!thinnable) thinnable = ThinnableMesh::of(*mesh);
    auto thinner = thinnable && allowance > 0.0 ? thinnable->thinned(allowance) : std::nullopt;
    known = thinner ? std::make_shared<const TriangleMesh>(std::move(*thinner)) : mesh;
    return known;
  }

 private:
  std::map<MeshPtr, std::optional<ThinnableMesh>> thinnable_;
  std::map<std::pair<MeshPtr, double>, MeshPtr> thinned_;
};

/// What both bodies of a clash have to be taken thinner by, so that they are free where they are assembled; nothing
/// where that is more than they have place for. The clash says what it would take of the body alone.
std::optional<double> sharedAllowance(const AssembledProduct& product, std::size_t body, const Fit& clash) {
  const RigidBody& own = product.bodies[body];
  RigidBody other = product.bodies[clash.obstacle];
  const auto thinnableOwn = ThinnableMesh::of(*own.mesh);
  const auto thinnableOther = ThinnableMesh::of(*other.mesh);
  if (!thinnableOwn || !thinnableOther) return std::nullopt;
  const double gap = assembledGap(radiusAboutOrigin(*own.mesh));
  for (const double share : {0.3, 0.4, 0.5, 0.75, 1.0}) {
    const double allowance = share * clash.allowance;
    auto thinOwn = thinnableOwn->thinned(allowance);
    auto thinOther = thinnableOther->thinned(allowance);
    if (!thinOwn || !thinOther) return std::nullopt;
    other.mesh = std::make_shared<const TriangleMesh>(std::move(*thinOther));
    const auto pair = CollisionWorld::build({other}, std::make_shared<const TriangleMesh>(std::move(*thinOwn)));
    if (pair->makeQuery()->clearAbove(own.X_WB, 0.5 * gap)) return allowance;
  }
  return std::nullopt;
}

}  // namespace

Result<ObjectFits> fitsOfBody(const AssembledProduct& product, std::size_t body, const ContactReport* contacts,
                              const StopToken& stop) {
  // The body itself is no obstacle: those behind it move up by one.
  std::vector<RigidBody> obstacles = product.bodies;
  std::vector<double> deflections = product.deflections;
  const auto place = static_cast<std::ptrdiff_t>(body);
  obstacles.erase(obstacles.begin() + place);
  deflections.erase(deflections.begin() + place);
  deflections.push_back(product.deflections[body]);
  FitQuestion question{obstacles, product.bodies[body], {product.bodies[body].X_WB}, deflections, product.fits};
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
  team.run(fits.size(), [&](std::size_t body) {
    Moving& moving = found.moving_[body];
    moving.whole = product.bodies[body].mesh;
    if (!on || stop.stopRequested()) return;
    moving.axes = glissade::axesOf(contactsOf(body, contacts));
    fits[body] = fitsOfBody(product, body, &contacts, stop);
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
  ThinnedMeshes meshes;
  for (Moving& moving : found.moving_) {
    for (const Fit& fit : moving.allowed) moving.thinned.push_back(meshes.thinned(moving.whole, fit.allowance));
    for (const Fit& fit : moving.yielding) {
      moving.thinnedOthers.push_back(meshes.thinned(product.bodies[fit.obstacle].mesh, fit.allowance));
    }
  }
  return found;
}

/// A nut's wall is too thin for what the bolt's shaft has place for. Which of the two is taken thinner makes no
/// difference to the gap between them. Where neither has place for all of it, both are taken thinner.
void ProductFits::resolveClashes(const AssembledProduct& product, const std::vector<Result<ObjectFits>>& fits,
                                 ThreadTeam& team) {
  std::vector<std::pair<std::size_t, Fit>> open;
  for (std::size_t body = 0; body < moving_.size(); ++body) {
    for (const Fit& clash : fits[body]->clashes) {
      const auto& others = fits[clash.obstacle]->allowed;
      const auto back =
          std::find_if(others.begin(), others.end(), [&](const Fit& fit) { return fit.obstacle == body; });
      if (back != others.end()) {
        Fit yielding = clash;
        yielding.allowance = back->allowance;
        yieldTo(body, yielding, product);
      } else if (clash.kind != ContactKind::Clash) {
        open.emplace_back(body, clash);
      }
    }
  }
  std::vector<std::optional<double>> shared(open.size());
  team.run(open.size(), [&](std::size_t i) { shared[i] = sharedAllowance(product, open[i].first, open[i].second); });
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!shared[i]) continue;
    auto& [body, fit] = open[i];
    fit.allowance = *shared[i];
    moving_[body].allowed.push_back(fit);
    yieldTo(body, fit, product);
  }
}

void ProductFits::yieldTo(std::size_t body, const Fit& fit, const AssembledProduct& product) {
  moving_[body].yielding.push_back(fit);
  const std::string pair = "'" + product.bodies[body].name + "' and '" + product.bodies[fit.obstacle].name + "'";
  std::erase_if(warnings_, [&](const Diagnostic& warning) { return warning.location == pair; });
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
  for (std::size_t i = 0; i < moving.yielding.size(); ++i) {
    if (moving.yielding[i].obstacle == other) return moving.thinnedOthers[i];
  }
  return moving_[other].whole;
}

const MeshPtr& ProductFits::meshAgainst(std::size_t body, std::size_t other) const {
  const Moving& moving = moving_[body];
  for (std::size_t i = 0; i < moving.allowed.size(); ++i) {
    if (moving.allowed[i].obstacle == other) return moving.thinned[i];
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
