#pragma once

#include <functional>
#include <utility>

#include "engine/base/stop_token.h"

namespace glissade {

/// Control of long work: a request to stop, and reports of progress. A stop token converts to one. `progressed` is
/// called on the working thread, often, with shares in [0, 1] that are estimates of the work, not of the time.
struct WorkWatch {
  using Progressed = std::function<void(double share)>;

  WorkWatch() = default;
  WorkWatch(StopToken token, Progressed report = {}) : stop(std::move(token)), progressed(std::move(report)) {}

  void report(double share) const {
    if (progressed) progressed(share);
  }
  /// The watch for a part of the work, between two shares of the whole.
  WorkWatch part(double from, double to) const {
    if (!progressed) return *this;
    return {stop, [whole = progressed, from, to](double share) { whole(from + share * (to - from)); }};
  }

  StopToken stop;
  Progressed progressed;
};

}  // namespace glissade
