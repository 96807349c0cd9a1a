#pragma once

#include "widgets/scene3d/gizmo_drag.h"
#include "widgets/scene3d/scene_overlay.h"

namespace glissade {

/// The gizmo that is drawn.
struct GizmoPicture {
  /// A handle that is dragged.
  struct Held {
    GizmoHandle handle;
    Pose from;          ///< X_WG at the beginning of the drag
    Vector3 grippedAt;  ///< for a ring, as GizmoDrag::grippedAt()
    double angle;       ///< for a ring, radians
    QString amount;     ///< text of the amount, beside the pointer
    QPointF pointer;
  };
  Pose X_WG;
  std::optional<GizmoHandle> hovered{};
  std::optional<Held> held{};
};

/// The gizmo, painted over the widget that shows the scene: it has a constant size on the screen, nothing hides it, and
/// pictures and films of the scene do not contain it. It ignores mouse and keys; its owner asks for the handle under
/// the pointer.
class GizmoOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// The overlay covers `scene`, which shows `view`, and follows its size.
  GizmoOverlay(const SceneView& view, QWidget* scene);

  /// Sets the gizmo; nothing: no gizmo is drawn.
  void setPicture(const std::optional<GizmoPicture>& picture);
  const std::optional<GizmoPicture>& picture() const { return picture_; }

  /// The drawn gizmo. Precondition: there is a picture.
  Gizmo gizmo() const;
  std::optional<GizmoHandle> handleAt(const QPointF& position) const;
  /// A point of the widget at which this handle can be taken; nothing if there is none.
  std::optional<QPointF> pointOn(const GizmoHandle& handle) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Gizmo gizmoOf(const Pose& X_WG) const;
  bool isMarked(const GizmoHandle& handle) const;
  void paintRing(QPainter& painter, const GizmoHandle& handle) const;
  void paintSquare(QPainter& painter, const GizmoHandle& handle) const;
  void paintArrow(QPainter& painter, const GizmoHandle& handle) const;
  void paintLetter(QPainter& painter, int axis, bool marked) const;
  void paintTurn(QPainter& painter, const GizmoPicture::Held& held) const;

  std::optional<GizmoPicture> picture_;
};

}  // namespace glissade
