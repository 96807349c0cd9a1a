#pragma once

#include <optional>

#include "app/window/drag_tool.h"
#include "widgets/scene3d/section_overlay.h"

namespace glissade {

/// Lets a person drag sections by their handles in the scene. Esc puts one back that is held.
class SectionTool final : public DragTool {
  Q_OBJECT

 public:
  SectionTool(SceneWidget& scene, QObject* parent);

  /// `box` is that of what is drawn. Those that are off have no handle.
  void setSections(const std::vector<SectionPlane>& sections, const Box3& box);
  const SectionOverlay& overlay() const { return *overlay_; }

 signals:
  /// The pointer has put a section there, metres along its direction.
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
  QCursor cursorBefore_;  ///< of the scene, before a handle was under the pointer
};

}  // namespace glissade
