#pragma once

#include <string>

#include "engine/check/evidence.h"
#include "engine/product/contact_report.h"

namespace glissade {

/// What a person says about a pair, in either order; null where nothing.
const FitEdit* editOf(const FitSettings& settings, const std::string& a, const std::string& b);

/// What becomes of a contact.
struct FitDecision {
  ContactKind kind = ContactKind::Contact;
  double allowance = 0.0;  ///< metres; of a refused clash, what it would take
  bool refused = false;    ///< a clash that nobody accepted
  bool given = false;      ///< a person gave the allowance
};

/// A person's kind and allowance go before what was measured. `bound` is what the evidence gives for the body that is
/// taken thinner; a refused clash says what its overlap would take.
FitDecision decideFit(const Contact& contact, const FitEdit* edit, const FitSettings& settings,
                      const check::AllowanceBound& bound);

/// What a person says of fits, as evidence is measured with it.
check::FitWords wordsOf(const FitSettings& settings);

}  // namespace glissade
