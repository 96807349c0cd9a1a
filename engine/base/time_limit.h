#pragma once

#include <algorithm>
#include <chrono>

#include "engine/base/stop_token.h"

namespace glissade {

/// The token with a deadline in `seconds`; 0 sets none.
inline StopToken withTimeLimit(const StopToken& stop, double seconds) {
  constexpr double kLongest = 1e9;
  if (seconds <= 0.0) return stop;
  const std::chrono::duration<double> limit(std::min(seconds, kLongest));
  return stop.withDeadline(StopToken::Clock::now() + std::chrono::duration_cast<StopToken::Clock::duration>(limit));
}

}  // namespace glissade
