#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/pair_fit.h"

namespace glissade::check {

/// "'knob' and 'lip'".
Message pairInWords(const std::string& one, const std::string& other);

/// "'knob', 'lip'".
Message namesInWords(const std::vector<std::string>& names);

/// "overlap 0.8 mm, deflection 0 mm, spacing 0 mm, gap 0.001 mm", or that a person allows it.
Message inWords(const Evidence& evidence);

/// "'nut' is taken 0.021 mm thinner against 'bolt': overlap ...", with the pitch of a thread.
Message inWords(const AppliedAllowance& allowance);

/// The reason why an allowance of a file is refused: the pair, both numbers, what is missing, and a remedy. `reason`
/// may be empty.
Message allowanceRefused(const AppliedAllowance& allowance, const Message& reason);

}  // namespace glissade::check
