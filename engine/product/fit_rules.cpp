#include "engine/product/fit_rules.h"

#include <algorithm>

namespace glissade {

const FitEdit* editOf(const FitSettings& settings, const std::string& a, const std::string& b) {
  const auto found = std::find_if(settings.pairs.begin(), settings.pairs.end(), [&](const FitEdit& edit) {
    return (edit.a == a && edit.b == b) || (edit.a == b && edit.b == a);
  });
  return found == settings.pairs.end() ? nullptr : &*found;
}

FitDecision decideFit(const Contact& contact, const FitEdit* edit, const FitSettings& settings, double gap) {
  FitDecision decision;
  decision.kind = edit != nullptr && edit->kind ? *edit->kind : contact.kind;
  if (decision.kind == ContactKind::Clearance) return decision;
  if (edit != nullptr && edit->allowance) {
    decision.allowance = *edit->allowance;
    decision.given = true;
    return decision;
  }
  decision.allowance = contact.overlap + contact.deviation + gap;
  const bool small = settings.acceptedClash > 0.0 && contact.overlap <= settings.acceptedClash;
  const bool accepted = small || (edit != nullptr && edit->accepted);
  decision.refused = decision.kind == ContactKind::Clash && !accepted;
  return decision;
}

}  // namespace glissade
