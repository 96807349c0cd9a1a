#pragma once

#include <string>

#include "engine/check/pair_fit.h"

namespace glissade::check {

/// "'knob' and 'lip'".
std::string pairInWords(const std::string& one, const std::string& other);

/// "overlap 0.8 mm, deflection 0 mm, spacing 0 mm, gap 0.001 mm", or that a person allows it.
std::string inWords(const Evidence& evidence);

/// "'nut' is taken 0.021 mm thinner against 'bolt': overlap ...", with the pitch of a thread.
std::string inWords(const AppliedAllowance& allowance);

/// The reason why an allowance of a file is refused: the pair, both numbers, what is missing, and a remedy. `reason`
/// may be empty.
std::string allowanceRefused(const AppliedAllowance& allowance, const std::string& reason);

}  // namespace glissade::check
