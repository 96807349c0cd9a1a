#include "engine/product/product_fits.h"

#include "engine/check/placed_bodies.h"

namespace glissade {
namespace {

/// What the evidence gives for taking body `a` of the contact thinner.
check::AllowanceBound boundOf(const Contact& contact, const std::vector<ContactBody>& bodies,
                              const check::FitWords& words, check::PlacedBodies& placed, const StopToken& stop) {
  const auto measured = [&](const ContactBody& body) {
    return check::Body{body.id, body.id, body.mesh, body.X_WB, 0.0, body.deflection};
  };
  const check::Body a = measured(bodies[contact.a]);
  const check::Body b = measured(bodies[contact.b]);
  return placed.boundsOf({a, a.X_WB}, {b, b.X_WB}, words, words.about(a.id, b.id), stop).one;
}

}  // namespace

const char* statusName(FitStatus status) {
  switch (status) {
    case FitStatus::Clear: return "clear";
    case FitStatus::Allowed: return "allowed";
    case FitStatus::Accepted: return "accepted";
    case FitStatus::Clash: break;
  }
  return "clash";
}

FitStatus PairFit::status() const {
  if (decision.kind == ContactKind::Clearance) return FitStatus::Clear;
  if (decision.refused) return FitStatus::Clash;
  return decision.kind == ContactKind::Clash ? FitStatus::Accepted : FitStatus::Allowed;
}

std::vector<PairFit> findProductFits(const std::vector<ContactBody>& bodies, const FitSettings& settings,
                                     const ContactLimits& limits, const StopToken& stop) {
  const check::FitWords words = wordsOf(settings);
  check::PlacedBodies placed;
  std::vector<PairFit> fits;
  for (const Contact& contact : findContacts(bodies, limits, stop).contacts) {
    const std::string& a = bodies[contact.a].id;
    const std::string& b = bodies[contact.b].id;
    if (stop.stopRequested()) break;
    const check::AllowanceBound bound = boundOf(contact, bodies, words, placed, stop);
    fits.push_back({a, b, contact, decideFit(contact, editOf(settings, a, b), settings, bound), bound.largest});
  }
  return fits;
}

std::map<std::string, int> countsByKind(const std::vector<PairFit>& fits) {
  std::map<std::string, int> counts;
  for (const PairFit& fit : fits) ++counts[kindName(fit.decision.kind)];
  return counts;
}

}  // namespace glissade
