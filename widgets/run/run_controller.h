#pragma once

#include <QLabel>

#include "widgets/run/counts_panel.h"
#include "widgets/run/interaction_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Keeps session and document in step, and steers and shows the run: actions, the interaction panel, the figures, the
/// status line.
class RunController final : public QObject {
  Q_OBJECT

 public:
  explicit RunController(const Workbench& bench);

  InteractionPanel* interactionPanel() const { return interaction_; }
  CountsPanel* countsPanel() const { return counts_; }

 private:
  void connectActions();
  /// Updates the session from the document.
  void updateSession(Changes what);
  /// Updates the document from the session.
  void takeSnapshot(const SessionSnapshot& snapshot);
  void showRun(const SnapshotPtr& snapshot);
  void enableActions(const SessionSnapshot* snapshot);
  void chooseDevice(const std::string& id);
  void restart(std::uint64_t seed);
  /// Shows the rules of the strategy. Changed rules become the scenario's own.
  void editRules();

  const Workbench& bench_;
  InteractionPanel* interaction_;
  CountsPanel* counts_;
  QLabel* status_;
  QLabel* elapsed_;
};

}  // namespace glissade
