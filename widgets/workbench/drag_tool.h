#pragma once

#include <QObject>
#include <QPointF>

#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Lets a person drag something in the 3D view with the left button: press grips, drag moves, Ctrl+drag turns, release
/// drops. The derived tool decides what is gripped; if it grips nothing, the view handles the mouse.
class DragTool : public QObject {
 protected:
  DragTool(SceneWidget& scene, QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

  /// False if there is nothing to grip.
  virtual bool grip(const QPointF& position) = 0;
  virtual bool holds() const = 0;
  virtual void moveTo(const QPointF& position) = 0;
  /// Moves on while Ctrl is held. `by`: motion of the pointer in fractions of the view's height.
  virtual void turn(const QPointF& position, const QPointF& by) = 0;
  virtual void drop() = 0;

  SceneWidget& scene_;

 private:
  void follow(const QPointF& position, bool turning);

  QPointF last_;
};

}  // namespace glissade
