#pragma once

#include "app/window/align_tool.h"
#include "app/window/arrange_tool.h"
#include "app/window/assembly_controller.h"
#include "app/window/measure_controller.h"
#include "widgets/panels/arrange_bar.h"

namespace glissade {

/// The mode in which things are arranged in the view: its bar, its tool, snapping, and alignments. Esc, another
/// scenario, a run or measuring end it.
class ArrangeController final : public QObject {
  Q_OBJECT

 public:
  ArrangeController(const Workbench& bench, AssemblyController& assembly, MeasureController& measure);

  ArrangeTool& tool() { return tool_; }
  AlignTool& align() { return align_; }
  ArrangeBar& bar() { return *bar_; }
  /// Gives the bar's steps to the tool.
  void takeSteps();

 private:
  void connectTool();
  void connectAlignments();
  void setOn(bool on);
  void setAligning(bool on);
  void leaveModes();
  void followDocument(Changes what);
  void showItem(const std::optional<AssemblyItem>& item, const PlacementPoints& points);
  void takeAlignment(const AssemblyItem& item, const MeasureFeature& moving, const MeasureFeature& fixed);
  void flip();
  void placeAligned();
  /// An alignment was made or left. Arranging goes on where it was interrupted.
  void resume();
  void enableActions();

  /// What was aligned last, as long as it stays there.
  struct Aligned {
    AssemblyItem item;
    Pose before;
    MeasureFeature moving;
    MeasureFeature fixed;
    bool flipped = false;
    Pose after{};
  };

  const Workbench& bench_;
  AssemblyController& assembly_;
  ArrangeSnapping snapping_;
  ArrangeTool tool_;
  AlignTool align_;
  ArrangeBar* bar_;
  std::optional<Aligned> aligned_;
  int alignments_ = 0;
  bool interrupted_ = false;
};

}  // namespace glissade
