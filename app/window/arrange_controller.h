#pragma once

#include "app/window/arrange_tool.h"
#include "app/window/assembly_controller.h"
#include "app/window/measure_controller.h"
#include "widgets/panels/arrange_bar.h"

namespace glissade {

/// The mode in which things are arranged in the view: its bar, its tool, snapping, and putting an axis onto an axis or
/// a face onto a face. Esc, another scenario, a run or measuring end it.
class ArrangeController final : public QObject {
  Q_OBJECT

 public:
  ArrangeController(const Workbench& bench, AssemblyController& assembly, MeasureController& measure);

  ArrangeTool& tool() { return tool_; }
  ArrangeBar& bar() { return *bar_; }
  /// Gives the bar's steps to the tool.
  void takeSteps();

 private:
  void connectTool();
  void connectMeasure(MeasureController& measure);
  void setOn(bool on);
  void followDocument(Changes what);
  void showItem(const std::optional<AssemblyItem>& item, const PlacementPoints& points);
  void align(const AssemblyItem& item, const MeasureFeature& moving, const MeasureFeature& fixed);
  void flip();
  void placeAligned();
  /// Arranging goes on where it was interrupted by an alignment.
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
  ArrangeTool tool_;
  ArrangeBar* bar_;
  std::optional<Aligned> aligned_;
  int alignments_ = 0;
  bool interrupted_ = false;
};

}  // namespace glissade
