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
  ThinnedMeshes meshes;
  for (Moving& moving : found.moving_) {
    for (const Fit& fit : moving.allowed) moving.thinned.push_back(meshes.thinned(moving.whole, fit.allowance));
  }
  return found;
}

std::vector<Fit> ProductFits::fitsOf(std::size_t body, const BodySet& present) const {
  std::vector<Fit> fits;
  for (const Fit& fit : moving_[body].allowed) {
    if (present[fit.obstacle]) fits.push_back(fit);
  }
  return fits;
}

const MeshPtr& ProductFits::meshAgainst(std::size_t body, std::size_t other) const {
  const Moving& moving = moving_[body];
  for (std::size_t i = 0; i < moving.allowed.size(); ++i) {
    if (moving.allowed[i].obstacle == other) return moving.thinned[i];
  }
  return moving.whole;
}

bool ProductFits::isThread(std::size_t body, std::size_t other) const {
  const auto& allowed = moving_[body].allowed;
  return std::any_of(allowed.begin(), allowed.end(),
                     [&](const Fit& fit) { return fit.obstacle == other && fit.thread; });
}

}  // namespace glissade
