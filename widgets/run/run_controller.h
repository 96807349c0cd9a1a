#pragma once

#include <QLabel>

#include <optional>
#include <string>

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

 protected:
  /// Writes the lengths of the status line in another unit.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connectActions();
  /// Updates the session from the document.
  void updateSession(Changes what);
  /// Updates the document from the session.
  void takeSnapshot(const SessionSnapshot& snapshot);
  void keepSettings(const SessionSnapshot& snapshot);
  void showRun(const SnapshotPtr& snapshot);
  void markFound(bool found);
  /// The state of the run, or the first thing to do with a product.
  QString stateText(const SessionSnapshot& snapshot) const;
  void enableActions(const SessionSnapshot* snapshot);
  void chooseDevice(const std::string& id);
  void restart(std::uint64_t seed);
  /// Starts a run, with its panel in front. A step by hand has the panel of its sequence.
  void start();
  /// Stops the run, or else the work in the background, such as the planning of a sequence.
  void stop();
  /// Gives the rest of the run to the automatic planners, at full speed. Once they have ended, the settings are as
  /// before.
  void finish();
  void setLater(ParameterId id, double value);
  void followFinish(const SessionSnapshot& snapshot);
  /// Sets the pace of a person as soon as their hand leads the search, and full speed once it does not. A pace that
  /// the person has set stays.
  void followHand(const SessionSnapshot& snapshot);
  /// Shows the rules of the strategy. Changed rules become the scenario's own.
  void editRules();

  const Workbench& bench_;
  InteractionPanel* interaction_;
  CountsPanel* counts_;
  QLabel* status_;
  QLabel* elapsed_;
  std::optional<RunSettings> finishing_;  ///< settings of a run by hand that the computer finishes
  std::uint64_t finishingRun_ = 0;        ///< number of the run that finishes it
  bool ledByPerson_ = false;              ///< at the last snapshot
};

}  // namespace glissade
