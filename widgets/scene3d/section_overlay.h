#pragma once

#include <optional>
#include <vector>

#include "widgets/scene3d/scene_overlay.h"
#include "widgets/scene3d/section_drag.h"

namespace glissade {

/// The outlines and the handles of sections, painted over the widget that shows the scene: pictures and films of the
/// scene do not contain them. It ignores mouse and keys.
class SectionOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// A handle that is dragged, and the text of its place beside the pointer.
  struct Held {
    std::size_t section;
    QString place;
    QPointF pointer;
  };

  /// The overlay covers `scene`, which shows `view`, and follows its size.
  SectionOverlay(const SceneView& view, QWidget* scene);

  /// Sets the sections; those that are off have no handle. `box`: of the drawn scene.
  void setSections(const std::vector<SectionPlane>& sections, const Box3& box);
  void setHovered(const std::optional<std::size_t>& section);
  const std::optional<std::size_t>& hovered() const { return hovered_; }
  void setHeld(const std::optional<Held>& held);

  SectionHandle handle(std::size_t section) const { return handleOf(sections_[section], box_); }
  /// The section whose handle is at this position.
  std::optional<std::size_t> sectionAt(const QPointF& position) const;
  /// A point at which a handle can be taken; nothing if it is not drawn.
  std::optional<QPointF> pointOn(std::size_t section) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// The line from the middle to the tip; both ends of a knob are the middle.
  std::optional<QLineF> shaftOf(std::size_t section) const;
  bool isMarked(std::size_t section) const;
  void paintOutline(QPainter& painter, std::size_t section) const;
  void paintHandle(QPainter& painter, std::size_t section) const;

  std::vector<SectionPlane> sections_;
  Box3 box_;
  std::optional<std::size_t> hovered_;
  std::optional<Held> held_;
};

}  // namespace glissade
