#pragma once

#include <optional>

#include "widgets/scene3d/section_overlay.h"
#include "widgets/workbench/drag_tool.h"

namespace glissade {

/// Lets a person drag sections by their handles in the scene. Esc puts back a gripped section.
class SectionTool final : public DragTool {
  Q_OBJECT

 public:
  SectionTool(SceneWidget& scene, QObject* parent);

  /// Sets the sections with handles; sections that are off have none. `box`: the box of the drawn bodies.
  void setSections(const std::vector<SectionPlane>& sections, const Box3& box);
  const SectionOverlay& overlay() const { return *overlay_; }

 signals:
  /// The pointer moved a section to this place, metres along its direction.
  void dragged(std::size_t section, double place);

 private:
  struct InHand {
    std::size_t section;
    double before;
    SectionDrag drag;
  };

  bool eventFilter(QObject* watched, QEvent* event) override;
  bool grip(const QPointF& position) override;
  bool holds() const override { return inHand_.has_value(); }
  void moveTo(const QPointF& position) override;
  void turn(const QPointF& position, const QPointF& by) override;
  void drop() override;

  void hover(const QPointF& position);
  void showPlace(const QPointF& pointer);

  SectionOverlay* overlay_;
  std::vector<SectionPlane> sections_;
  Box3 box_;
  std::optional<InHand> inHand_;
  QCursor cursorBefore_;  ///< cursor of the scene while no handle was under the pointer
};

}  // namespace glissade
