#pragma once

#include <cstddef>
#include <string>

#include "engine/planning/planner.h"

namespace glissade {

/// Optional interface of planners that run members.
class ReportsMembers {
 public:
  virtual ~ReportsMembers() = default;
  /// Names of the members that have the turn, or the name of the member that found the path.
  virtual std::string member() const = 0;
  /// Processor time of the planner's own threads, without the thread that calls solve(), in seconds.
  virtual double helpersCpuSeconds() const = 0;
};

/// Optional interface of planners that work in stages.
class ReportsStages {
 public:
  virtual ~ReportsStages() = default;
  /// Number of completed stages. A portfolio gives more time to a member that has completed another stage.
  virtual std::size_t stagesDone() const = 0;
};

/// Names of the members of a planner; empty for planners without members.
inline std::string memberOf(const Planner& planner) {
  const auto* report = reportOf<ReportsMembers>(planner);
  return report != nullptr ? report->member() : std::string();
}

inline double helpersCpuSecondsOf(const Planner& planner) {
  const auto* report = reportOf<ReportsMembers>(planner);
  return report != nullptr ? report->helpersCpuSeconds() : 0.0;
}

inline std::size_t stagesDoneOf(const Planner& planner) {
  const auto* report = reportOf<ReportsStages>(planner);
  return report != nullptr ? report->stagesDone() : 0;
}

}  // namespace glissade
