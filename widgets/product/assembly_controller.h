#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "widgets/product/end_clearance.h"
#include "widgets/product/part_import.h"
#include "widgets/product/placement_panel.h"
#include "widgets/product/scene_panel.h"

namespace glissade {

/// Arranges the product: adds and removes parts, chooses the moving part, and places bodies and the ends of the motion
/// with the mouse or by numbers, in the scene panel and in the view.
class AssemblyController final : public QObject {
  Q_OBJECT

 public:
  AssemblyController(const Workbench& bench, PartImport& parts);

  ScenePanel* scenePanel() const { return scenePanel_; }
  /// The scene panel, which contains the placement of the selected item.
  QWidget* panel() const { return panel_; }
  bool isEditable() const { return editable_; }
  /// Selects the item to arrange.
  void choose(const std::optional<AssemblyItem>& item);
  /// Places an item as one undoable edit, and shows the reason if that fails. `mergeKey`: as
  /// WorkbenchDocument::place().
  void place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey = {});
  /// Places a body by this frame of its mesh. For a body of the object it places an end of the motion.
  void placeByFrame(const RigidBody& body, const Pose& X_MF);

 signals:
  /// The placement panel shows this item with its points: it was selected or moved, or the numbers are about another
  /// point.
  void placementShown(const std::optional<glissade::AssemblyItem>& item, const glissade::PlacementPoints& points);
  void editableChanged(bool editable);

 private:
  void connectActions();
  void addKey(Qt::Key key, const char* action, QWidget* widget);
  void followDocument(Changes what);
  /// The arrangement cannot be edited during a run or while a replay is shown.
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
  std::set<BodyId> selectedOfAll() const;
  std::set<BodyId> selectedBodies() const;
  /// Ids of the selected bodies, first those of the object.
  std::vector<BodyId> selectedToMove() const;

  const Workbench& bench_;
  WorkbenchDocument& document_;
  QWidget* panel_;
  ScenePanel* scenePanel_;
  PlacementPanel* placement_;
  std::optional<AssemblyItem> chosen_;  ///< the item that the placement panel shows
  std::optional<AssemblyItem> placed_;  ///< the item that the panel showed last
  bool editable_ = false;
  std::map<BodyId, Pose> picked_;  ///< X_BF by the body's id; "": the object's
};

}  // namespace glissade
