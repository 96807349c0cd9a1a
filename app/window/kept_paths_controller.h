#pragma once

#include <set>

#include "app/window/workbench.h"
#include "widgets/bridge/background_task.h"
#include "widgets/panels/compare_paths_dialog.h"
#include "widgets/panels/kept_paths_panel.h"

namespace glissade {

/// The paths that are kept in the scenario: kept, renamed, pinned, removed, shown together, compared, and proved again
/// in the background whenever the scenario is opened or arranged.
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
  /// What is known of a path; Unknown where it was not examined yet.
  KeptPathProof proofOf(const KeptPath& path);
  /// Proves the paths that were not examined yet, one after the other.
  void proveNext();
  void startProof(const KeptPathPtr& path);
  void takeProof(const KeptPath& path, const KeptPathProof& proof);
  /// After a scenario was opened: the pinned or newest path that holds becomes the current one.
  void openHeldPath();
  /// It becomes the current path, which the session proves.
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
  Proofs proofs_;                  ///< in the scenario as it is
  std::vector<PlaceEdit> places_;  ///< what the proofs are about, too
  std::set<std::string> shown_;    ///< names of the paths that are drawn
  bool opening_ = false;           ///< the paths of a scenario that was opened are not all proved yet
};

}  // namespace glissade
