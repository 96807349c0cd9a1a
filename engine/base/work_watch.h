#pragma once

#include <functional>
#include <utility>

#include "engine/base/stop_token.h"

namespace glissade {

/// What long work asks and tells while it goes on: whether to stop, and how far it has come. A stop
/// token alone is one, too. `progressed` is called on the working thread, often, with shares in [0, 1]
/// that are estimates of the work, not of the time.
struct WorkWatch {
  using Progressed = std::function<void(double share)>;

  WorkWatch() = default;
  WorkWatch(StopToken token, Progressed report = {}) : stop(std::move(token)), progressed(std::move(report)) {}

  void report(double share) const {
    if (progressed) progressed(share);
  }
  /// The same work as the part between two shares of a larger one.
  WorkWatch part(double from, double to) const {
    if (!progressed) return *this;
    return {stop, [whole = progressed, from, to](double share) { whole(from + share * (to - from)); }};
  }

  StopToken stop;
  Progressed progressed;
};

}  // namespace glissade
