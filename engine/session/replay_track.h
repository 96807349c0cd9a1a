#pragma once

#include <mutex>
#include <vector>

#include "engine/planning/coarse/coarse_plan_report.h"
#include "engine/planning/contact/interaction_report.h"

namespace glissade {

/// State of a replayed run after every step, so that any replayed step can be displayed. In long runs only every
/// second, fourth, ... step is kept. Thread-safe.
class ReplayTrack {
 public:
  struct Row {
    std::uint64_t step = 0;
    std::size_t nodes = 0;
    std::size_t edges = 0;  ///< undirected edges, including dropped ones
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
