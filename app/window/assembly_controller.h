#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/window/end_clearance.h"
#include "app/window/part_import.h"
#include "widgets/panels/placement_panel.h"
#include "widgets/panels/scene_panel.h"

namespace glissade {

/// Arranges the product: parts come and go, one of them moves, bodies and the ends of the motion are put
/// somewhere with the mouse or by numbers, in the scene panel and in the view.
class AssemblyController final : public QObject {
  Q_OBJECT

 public:
  AssemblyController(const Workbench& bench, PartImport& parts);

  ScenePanel* scenePanel() const { return scenePanel_; }
  /// The scene panel with the placement of what is selected in it.
  QWidget* panel() const { return panel_; }
  bool isEditable() const { return editable_; }
  /// Selects what is arranged.
  void choose(const std::optional<AssemblyItem>& item);
  /// Puts it somewhere, as one undoable edit, and says why where that fails. As WorkbenchDocument::place().
  void place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey = {});
  /// The body, or where it is the object an end of its motion, is placed by this frame of its mesh.
  void placeByFrame(const RigidBody& body, const Pose& X_MF);

 signals:
  /// What can be placed now, with its points: it was selected, moved, or the numbers are about another point.
  void placementShown(const std::optional<glissade::AssemblyItem>& item, const glissade::PlacementPoints& points);
  void editableChanged(bool editable);

 private:
  void connectActions();
  void followDocument(Changes what);
  /// There are no edits of the arrangement while a run goes on or a replay is shown.
  void followRun(const SnapshotPtr& snapshot);
  void showFailure(const Outcome& outcome);
  void editScenario(const QString& text, const std::function<Outcome(Scenario&)>& change);
  void removeSelected();
  void leaveOutSelected();
  void putBackSelected();
  void markSelected();
  void moveEndsClear();
  void takeMovedEnds(const Result<std::vector<MovedEnd>>& moved);
  void takeSelection();
  void showPlacement();
  void enableActions();
  std::set<std::string> selectedOfAll() const;
  std::set<std::string> selectedBodies() const;
  /// Those of the object among them, which come first.
  std::vector<std::string> selectedToMove() const;

  const Workbench& bench_;
  WorkbenchDocument& document_;
  QWidget* panel_;
  ScenePanel* scenePanel_;
  PlacementPanel* placement_;
  std::optional<AssemblyItem> chosen_;  ///< what the placement panel shows
  std::optional<AssemblyItem> placed_;  ///< what it showed last
  bool editable_ = false;
  std::map<std::string, Pose> picked_;  ///< X_BF by body; "" of the object
};

}  // namespace glissade
