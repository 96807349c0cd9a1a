#pragma once

#include <cstdint>
#include <optional>

#include "engine/planning/planner.h"

namespace glissade {

/// Configurations that a hand has shown in a run, and their effect.
struct HandReport {
  std::uint64_t shown = 0;           ///< configurations that were tried
  std::uint64_t collided = 0;        ///< number of them that touched or penetrated
  std::uint64_t movedToContact = 0;  ///< number of the collided ones that were retracted and tried there
  bool joined = false;               ///< its way joined start and goal
  double followed = 0.0;             ///< share of the path's length that runs along the hand's way; 0 without a path

  friend bool operator==(const HandReport& a, const HandReport& b) {
    return a.shown == b.shown && a.collided == b.collided && a.movedToContact == b.movedToContact &&
           a.joined == b.joined && a.followed == b.followed;
  }
};

/// Optional interface of planners that follow a hand.
class ReportsHand {
 public:
  virtual ~ReportsHand() = default;
  virtual const HandReport& handReport() const = 0;
};

/// The planner's hand report; nothing for planners without one, and while nothing has been shown.
inline std::optional<HandReport> handReportOf(const Planner& planner) {
  const auto* report = reportOf<ReportsHand>(planner);
  if (report == nullptr || report->handReport().shown == 0) return std::nullopt;
  return report->handReport();
}

}  // namespace glissade
