#pragma once

#include <optional>

#include "engine/planning/contact/interaction_settings.h"
#include "engine/planning/planner.h"

namespace glissade {

/// Optional interface of planners that share their iterations with an operator.
class ReportsInteraction {
 public:
  virtual ~ReportsInteraction() = default;
  /// Author of the configuration that was tried last.
  virtual Author authority() const = 0;
  /// True while contact samples are drawn.
  virtual bool inContactMode() const = 0;
  /// The settings that the tuner has chosen; nothing where no setting is automatic.
  virtual std::optional<TuningReport> tuning() const { return std::nullopt; }
};

inline Author authorityOf(const Planner& planner) {
  const auto* report = reportOf<ReportsInteraction>(planner);
  return report != nullptr ? report->authority() : Author::Computer;
}

inline bool contactModeOf(const Planner& planner) {
  const auto* report = reportOf<ReportsInteraction>(planner);
  return report != nullptr && report->inContactMode();
}

inline std::optional<TuningReport> tuningOf(const Planner& planner) {
  const auto* report = reportOf<ReportsInteraction>(planner);
  return report != nullptr ? report->tuning() : std::nullopt;
}

}  // namespace glissade
