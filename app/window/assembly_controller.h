#pragma once

#include <set>

#include "app/window/arrange_tool.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/model/assembly_document.h"
#include "widgets/panels/placement_panel.h"
#include "widgets/panels/scene_panel.h"

namespace glissade {

/// Arranges the product: parts come and go, one of them moves, bodies and the ends of the motion are put
/// somewhere with the mouse or by numbers. Keeps the scene panel, the tool and the document in step. Part of
/// the main window.
class AssemblyController final : public QObject {
  Q_OBJECT

 public:
  AssemblyController(SemanticDocument& semantics, const ActionCatalogue& actions, SceneWidget& scene, QWidget* window);

  AssemblyDocument& document() { return document_; }
  ScenePanel* scenePanel() const { return scenePanel_; }
  /// The scene panel with the placement of what is selected in it.
  QWidget* panel() const { return panel_; }

  /// A scenario was opened, rearranged, or saved elsewhere.
  void show(const ScenarioPtr& scenario);
  /// Whether there may be edits now, and the session that they are made beside (null: none).
  void setState(bool editable, const SnapshotPtr& snapshot);

 signals:
  void failed(const glissade::Diagnostic& why);
  /// What was done, where it is not seen.
  void told(const QString& text);
  void addPartsWanted();

 private:
  void connectActions();
  void carryOut(const Outcome& outcome);
  void editScenario(const QString& text, const std::function<Outcome(Scenario&)>& change);
  void removeSelected();
  void markSelected();
  void freeEnds();
  void choose(const std::optional<AssemblyItem>& item);
  void takeSelection();
  void showPlacement();
  void enableActions();
  std::set<std::string> selectedBodies() const;

  SemanticDocument& semantics_;
  const ActionCatalogue& actions_;
  AssemblyDocument document_;
  ArrangeTool tool_;
  QWidget* panel_;
  ScenePanel* scenePanel_;
  PlacementPanel* placement_;
  std::optional<AssemblyItem> chosen_;  ///< what the placement panel shows
  bool editable_ = false;
  SnapshotPtr snapshot_;
};

}  // namespace glissade
