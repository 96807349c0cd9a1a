#pragma once

#include <mutex>
#include <vector>

#include "engine/planning/coarse/coarse_plan_report.h"
#include "engine/planning/contact/interaction_report.h"

namespace glissade {

/// How far a replayed run was after every step, so that any step can be shown once it was replayed.
/// Long runs are thinned out: every second, fourth, ... step is kept. Safe to use from any thread.
class ReplayTrack {
 public:
  struct Row {
    std::uint64_t step = 0;
    std::size_t nodes = 0;
    std::size_t edges = 0;  ///< undirected, dropped ones with them
    std::size_t droppedEdges = 0;
    PlannerCounts counts;
    Author authority = Author::Computer;
    bool contactMode = false;
    CoarsePlanPtr coarsePlan;
    std::optional<TuningReport> tuning;
  };

  void add(std::uint64_t step, const Planner& planner);
  /// The last row at or before a step; an empty roadmap where there is none.
  Row at(std::uint64_t step) const;
  /// The last step replayed, kept or not.
  std::uint64_t lastStep() const;
  /// Steps between two rows.
  std::uint64_t stride() const;

 private:
  mutable std::mutex mutex_;
  std::vector<Row> rows_;
  std::uint64_t stride_ = 1;
  std::uint64_t lastStep_ = 0;
};

}  // namespace glissade
