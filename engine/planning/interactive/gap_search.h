#pragma once

#include "engine/planning/fine/sub_planner.h"
#include "engine/planning/interactive/shown_configuration.h"
#include "engine/planning/interactive/shown_way.h"

namespace glissade {

/// Local planning between two configurations of a way: two trees that slide on in contact. Their configurations are
/// drawn from a tube between both ends and made free, so that they lie in contact where the passage is narrow.
class GapSearch {
 public:
  /// `deviation`: deviation of the tube, metres of the metric.
  GapSearch(const Problem& problem, const Pose& from, const Pose& to, double deviation, std::uint64_t seed,
            std::shared_ptr<ErodedWorlds> worlds);

  /// Does one step. Returns the way from end to end, once it is found.
  std::optional<std::vector<Pose>> step(PlannerHost& host);
  std::uint64_t steps() const { return search_.planner().counts().steps; }
  const Pose& target() const { return target_; }
  /// Counts of all its queries.
  QueryCounts queries() const;

 private:
  Pose target_;
  std::shared_ptr<ShownConfiguration> configuration_;
  SubPlanner search_;
};

}  // namespace glissade
