#pragma once

#include "widgets/controls/background_task.h"
#include "widgets/measure/measure_controller.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_tool.h"
#include "widgets/workbench/workbench.h"

class QToolBar;

namespace glissade {

/// The sections of the view: their tool bar, and their handles in the scene. They belong to the view, which has no
/// undo. Opening a scenario removes them.
class SectionController final : public QObject {
  Q_OBJECT

 public:
  /// It must be made after all other tools of the scene, so that the handles of sections come first.
  SectionController(const Workbench& bench, const MeasureController& measure);

  /// Cuts the scene through this point and removes the side along the normal. Later calls move this section, or add it
  /// again if it was removed.
  void cutByHand(const Vector3& normal, const Vector3& through);

 private:
  void connectActions();
  void follow(Changes what);
  void addAcross(int axis);
  void addAlong(const MeasureFeature& face);
  /// Adds a section at a place along its direction. It removes the side that is nearer to the viewer, so that the cut
  /// faces are visible.
  void add(const Vector3& direction, double place);
  void show();
  void makeCaps();

  void addCommands();
  Outcome setByScript(const ScriptCommands::Words& words);
  Outcome dragByScript(const ScriptCommands::Words& words);

  const Workbench& bench_;
  SectionPanel* panel_;
  QToolBar* bar_;  ///< below the view; shown while there are sections, or when it is asked for
  SectionTool tool_;
  BackgroundTask caps_;
  std::optional<SectionPlane> byHand_;  ///< the section of the hand, at its last pose
  bool moreCaps_ = false;               ///< sections moved while caps were being made
};

}  // namespace glissade
