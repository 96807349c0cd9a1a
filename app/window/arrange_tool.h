#pragma once

#include "app/window/drag_tool.h"
#include "widgets/document/workbench_document.h"
#include "widgets/scene3d/pose_drag.h"

namespace glissade {

/// While it is on, a person takes bodies, and the object's ghosts at its start and its goal, with the mouse:
/// they move in the plane of the view, and turn about its axes. Bodies and ghosts are only drawn elsewhere
/// until they are dropped.
class ArrangeTool final : public DragTool {
  Q_OBJECT

 public:
  ArrangeTool(const WorkbenchDocument& document, SceneWidget& scene, QObject* parent);

  void setOn(bool on);
  /// What is selected is gripped also behind other bodies.
  void setSelected(const std::optional<AssemblyItem>& item) { selected_ = item; }

 signals:
  void gripped(const glissade::AssemblyItem& item);
  void dropped(const glissade::AssemblyItem& item, const glissade::Pose& X_WB);

 private:
  bool grip(const QPointF& position) override;
  bool holds() const override { return inHand_.has_value(); }
  void moveTo(const QPointF& position) override;
  void turn(const QPointF& by) override;
  void drop() override;
  void draw(const Pose& X_WB);

  struct InHand {
    AssemblyItem item;
    Pose before;
    PoseDrag drag;
  };

  const WorkbenchDocument& document_;
  bool on_ = false;
  std::optional<AssemblyItem> selected_;
  std::optional<InHand> inHand_;
};

}  // namespace glissade
