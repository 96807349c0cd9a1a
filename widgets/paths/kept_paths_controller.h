#pragma once

#include <set>

#include "widgets/controls/background_task.h"
#include "widgets/paths/compare_paths_dialog.h"
#include "widgets/paths/kept_paths_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The paths that the scenario keeps: keeps, renames, pins, removes, shows and compares them, and proves them again in
/// the background when the scenario is opened or arranged.
class KeptPathsController final : public QObject {
  Q_OBJECT

 public:
  explicit KeptPathsController(const Workbench& bench);

  KeptPathsPanel* panel() const { return panel_; }

 private:
  void connectActions();
  void followDocument(Changes what);
  void showRows();
  void enableActions();
  using Proofs = std::vector<std::pair<KeptPathPtr, KeptPathProof>>;
  Proofs::iterator findProof(const KeptPath& path);
  /// The known proof of a path; Unknown if the path was not examined yet.
  KeptPathProof proofOf(const KeptPath& path);
  /// Proves the paths that were not examined yet, one after the other.
  void proveNext();
  void startProof(const KeptPathPtr& path);
  void takeProof(const KeptPath& path, const KeptPathProof& proof);
  /// Makes the pinned or newest path that holds the current one, after a scenario was opened.
  void openHeldPath();
  /// Makes the path the current one; the session proves it.
  void give(const KeptPath& path);
  KeptPathRow rowOf(const KeptPathPtr& path);
  Result<KeptPathPtr> named(const std::string& word) const;
  Outcome openPath(const std::string& name);
  void compareSelected();
  void showFailure(const Outcome& outcome);
  void addCommands();

  const Workbench& bench_;
  KeptPathsPanel* panel_;
  BackgroundTask proving_;
  Proofs proofs_;                  ///< for the present scenario
  std::vector<PlaceEdit> places_;  ///< edits of places for which the proofs hold
  std::set<std::string> shown_;    ///< names of the paths that are drawn
  bool opening_ = false;           ///< paths of a newly opened scenario are still being proved
};

}  // namespace glissade
