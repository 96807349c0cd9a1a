#pragma once

#include "widgets/help/log_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Writes events into the log (scenarios, runs, failures), shows the log, and copies it for a bug report.
class LogController final : public QObject {
  Q_OBJECT

 public:
  explicit LogController(const Workbench& bench);

  LogPanel* panel() const { return panel_; }
  /// Versions, machine, scenario, settings and the log, as plain text. It is in English, except the messages.
  QString bugReport() const;

 private:
  void followRun(const SnapshotPtr& snapshot);
  void addCommands();

  const Workbench& bench_;
  LogPanel* panel_;
  std::uint64_t run_ = 0;
  SessionState state_ = SessionState::Idle;
  std::string problem_;
};

}  // namespace glissade
