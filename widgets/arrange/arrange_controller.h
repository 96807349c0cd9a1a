#pragma once

#include "widgets/arrange/align_tool.h"
#include "widgets/arrange/arrange_bar.h"
#include "widgets/arrange/arrange_tool.h"
#include "widgets/measure/measure_controller.h"
#include "widgets/product/assembly_controller.h"

namespace glissade {

/// The mode in which items are arranged in the view, with its bar, its tool, snapping and alignments. Esc, another
/// scenario, a run or measuring end the mode.
class ArrangeController final : public QObject {
  Q_OBJECT

 public:
  ArrangeController(const Workbench& bench, AssemblyController& assembly, MeasureController& measure);

  ArrangeTool& tool() { return tool_; }
  AlignTool& align() { return align_; }
  ArrangeBar& bar() { return *bar_; }
  /// Sets the tool's steps to the bar's steps.
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
  /// Resumes the arranging that an alignment interrupted. The alignment was made or left.
  void resume();
  void enableActions();

  /// The last alignment, as long as the item stays there.
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
