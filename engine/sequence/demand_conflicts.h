#pragma once

#include "engine/sequence/order_rules.h"

namespace glissade {

// Demands that exclude each other. None goes because another one comes: a person is asked which is to stay.

/// What a person said earlier, and cannot be kept with what they say now.
struct DemandConflict {
  std::vector<DemandedMotion> motions;                      ///< they begin in a direction that is now forbidden
  std::vector<ForbiddenDirection> forbidden;                ///< the motion that is now demanded leads there
  std::vector<std::pair<std::string, std::string>> before;  ///< the order is now demanded the other way round

  bool isNone() const { return motions.empty() && forbidden.empty() && before.empty(); }
};

/// Between what both demands have and what only `after` has. Bodies by the same names in both.
DemandConflict conflictBetween(const SequenceDemands& before, const SequenceDemands& after);

/// The demands without what a person has given up.
SequenceDemands withoutEarlier(const DemandConflict& conflict, SequenceDemands demands);

/// "'bracket' may not leave by 0 0 1", one sentence for each, for people.
Diagnostic inWords(const DemandConflict& conflict);

/// The motion begins in this direction, which is forbidden to one of its bodies.
bool excludes(const ForbiddenDirection& direction, const DemandedMotion& motion);

}  // namespace glissade
