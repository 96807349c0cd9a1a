#include "engine/product/product_fits.h"

namespace glissade {
namespace {

/// Of the allowances that are reported: the least gap that is left between two bodies that touch, metres.
constexpr double kReportedGap = 1e-6;

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
  std::vector<PairFit> fits;
  for (const Contact& contact : findContacts(bodies, limits, stop).contacts) {
    const std::string& a = bodies[contact.a].id;
    const std::string& b = bodies[contact.b].id;
    fits.push_back({a, b, contact, decideFit(contact, editOf(settings, a, b), settings, kReportedGap)});
  }
  return fits;
}

std::map<std::string, int> countsByKind(const std::vector<PairFit>& fits) {
  std::map<std::string, int> counts;
  for (const PairFit& fit : fits) ++counts[kindName(fit.decision.kind)];
  return counts;
}

}  // namespace glissade
