#pragma once

#include "app/window/measure_controller.h"
#include "app/window/section_tool.h"
#include "app/window/workbench.h"
#include "widgets/bridge/background_task.h"
#include "widgets/panels/section_panel.h"

namespace glissade {

/// The sections of the view: their panel, and their handles in the scene. They are a property of the view, which has
/// no undo; a scenario is opened without any.
class SectionController final : public QObject {
  Q_OBJECT

 public:
  /// To be made after all other tools of the scene: the handles of sections come first.
  SectionController(const Workbench& bench, const MeasureController& measure);

  SectionPanel* panel() const { return panel_; }
  /// The section of a hand: through this point; what lies along the normal is cut away. It is moved when this is called
  /// again, and added where it is not there any more.
  void cutByHand(const Vector3& normal, const Vector3& through);

 private:
  void connectActions();
  void follow(Changes what);
  void addAcross(int axis);
  void addAlong(const MeasureFeature& face);
  /// At a place along its direction; what is nearer to the viewer is cut away, so that the cut faces are seen.
  void add(const Vector3& direction, double place);
  void show();
  void makeCaps();

  void addCommands();
  Outcome setByScript(const ScriptCommands::Words& words);
  Outcome dragByScript(const ScriptCommands::Words& words);

  const Workbench& bench_;
  SectionPanel* panel_;
  SectionTool tool_;
  BackgroundTask caps_;
  std::optional<SectionPlane> byHand_;  ///< as the hand left it
  bool moreCaps_ = false;               ///< sections have moved since the caps were begun
};

}  // namespace glissade
