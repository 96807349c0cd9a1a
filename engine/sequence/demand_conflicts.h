#pragma once

#include "engine/sequence/order_rules.h"

namespace glissade {

// Demands that exclude each other. A new demand removes no earlier one: the user is asked which one to keep.

/// Earlier demands that a new demand excludes.
struct DemandConflict {
  std::vector<DemandedMotion> motions;        ///< motions that begin in a direction that is now forbidden
  std::vector<ForbiddenDirection> forbidden;  ///< forbidden directions in which the newly demanded motion begins
  std::vector<std::pair<std::string, std::string>> before;  ///< orders that are now demanded in reverse

  bool isNone() const { return motions.empty() && forbidden.empty() && before.empty(); }
};

/// Conflicts between demands that both arguments contain and demands that only `after` contains. Both name bodies
/// alike.
DemandConflict conflictBetween(const SequenceDemands& before, const SequenceDemands& after);

/// The demands without those that the conflict lists.
SequenceDemands withoutEarlier(const DemandConflict& conflict, SequenceDemands demands);

/// One sentence for each demand of the conflict, for people: "'bracket' may not leave by 0 0 1".
Diagnostic inWords(const DemandConflict& conflict);

/// True if the motion begins in this direction, which is forbidden to one of its bodies.
bool excludes(const ForbiddenDirection& direction, const DemandedMotion& motion);

}  // namespace glissade
