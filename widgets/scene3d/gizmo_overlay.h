#pragma once

#include "widgets/scene3d/gizmo_drag.h"
#include "widgets/scene3d/scene_overlay.h"

namespace glissade {

/// What is drawn of the gizmo.
struct GizmoPicture {
  /// A handle in the pointer's grip.
  struct Held {
    GizmoHandle handle;
    Pose from;          ///< X_WG when it was gripped
    Vector3 grippedAt;  ///< of a ring, as GizmoDrag::grippedAt()
    double angle;       ///< of a ring, radians
    QString amount;     ///< how far it was dragged, beside the pointer
    QPointF pointer;
  };
  Pose X_WG;
  std::optional<GizmoHandle> hovered{};
  std::optional<Held> held{};
};

/// The gizmo, painted over the widget that shows the scene: it has one size on the screen, nothing hides it, and
/// pictures and films of the scene do not have it. Takes no part in mouse and keys: what is under the pointer is for
/// its owner to ask.
class GizmoOverlay final : public SceneOverlay {
  Q_OBJECT

 public:
  /// Covers `scene`, which shows `view`, and follows its size.
  GizmoOverlay(const SceneView& view, QWidget* scene);

  /// Nothing: no gizmo is drawn.
  void setPicture(const std::optional<GizmoPicture>& picture);
  const std::optional<GizmoPicture>& picture() const { return picture_; }

  /// The gizmo as it is drawn. Precondition: there is a picture.
  Gizmo gizmo() const;
  std::optional<GizmoHandle> handleAt(const QPointF& position) const;
  /// A point of the widget where this handle can be taken; nothing where it cannot.
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
