#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/product/contact_report.h"
#include "engine/product/fit_rules.h"

namespace glissade {

/// What a pair means for planning.
enum class FitStatus {
  Clear,     ///< apart
  Allowed,   ///< one body is taken thinner against the other
  Accepted,  ///< a clash that a person has accepted: allowed, too
  Clash      ///< an overlap that stops a motion of either body
};

/// "clear", "allowed", "accepted", "clash"
const char* statusName(FitStatus status);

/// Two bodies of a product that are near each other, and what becomes of them.
struct PairFit {
  std::string a;  ///< id of the body
  std::string b;
  Contact contact;
  FitDecision decision;
  check::Evidence evidence{};  ///< for the allowance of `a`

  FitStatus status() const;
  /// Metres; 0 for a clash that nobody accepted.
  double allowance() const { return decision.refused ? 0.0 : decision.allowance; }
};

/// All pairs of a product's bodies that findContacts() reports, with what a person says about them. After a stop they
/// are incomplete.
std::vector<PairFit> findProductFits(const std::vector<ContactBody>& bodies, const FitSettings& settings,
                                     const ContactLimits& limits = {}, const StopToken& stop = {});

/// How many pairs there are of each kind, by the name of the kind.
std::map<std::string, int> countsByKind(const std::vector<PairFit>& fits);

}  // namespace glissade
