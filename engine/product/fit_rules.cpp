#include "engine/product/fit_rules.h"

#include <algorithm>

namespace glissade {

const FitEdit* editOf(const FitSettings& settings, const std::string& a, const std::string& b) {
  const auto found = std::find_if(settings.pairs.begin(), settings.pairs.end(), [&](const FitEdit& edit) {
    return (edit.a == a && edit.b == b) || (edit.a == b && edit.b == a);
  });
  return found == settings.pairs.end() ? nullptr : &*found;
}

FitDecision decideFit(const Contact& contact, const FitEdit* edit, const FitSettings& settings,
                      const check::AllowanceBound& bound) {
  FitDecision decision;
  decision.kind = edit != nullptr && edit->kind ? *edit->kind : contact.kind;
  if (decision.kind == ContactKind::Clearance) return decision;
  decision.allowance = bound.most;
  if (edit != nullptr && edit->allowance) {
    decision.given = true;
    return decision;
  }
  const bool small = settings.acceptedClash > 0.0 && contact.overlap <= settings.acceptedClash;
  const bool accepted = small || (edit != nullptr && edit->accepted);
  decision.refused = !bound.refused.empty() || (decision.kind == ContactKind::Clash && !accepted);
  if (decision.refused) decision.allowance = std::max(bound.most, contact.overlap + contact.deviation);
  return decision;
}

check::FitWords wordsOf(const FitSettings& settings) {
  check::FitWords words{settings.on, settings.acceptedClash, {}};
  for (const FitEdit& edit : settings.pairs) {
    check::PairWord word{edit.a, edit.b};
    if (edit.kind) word.kind = kindName(*edit.kind);
    word.allowance = edit.allowance;
    word.accepted = edit.accepted;
    word.pitch = edit.pitch;
    word.turned = edit.turned;
    words.pairs.push_back(std::move(word));
  }
  return words;
}

}  // namespace glissade
