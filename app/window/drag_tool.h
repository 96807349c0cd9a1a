#pragma once

#include <QObject>
#include <QPointF>

#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Lets a person take something in the 3D view with the left button: press grips, drag moves, Ctrl+drag turns,
/// release drops. What is gripped is for the derived tool to say; where it grips nothing, the view has the mouse.
class DragTool : public QObject {
 protected:
  DragTool(SceneWidget& scene, QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

  /// False: there is nothing to take.
  virtual bool grip(const QPointF& position) = 0;
  virtual bool holds() const = 0;
  virtual void moveTo(const QPointF& position) = 0;
  /// The same while Ctrl is held; the pointer went by this, in fractions of the view's height.
  virtual void turn(const QPointF& position, const QPointF& by) = 0;
  virtual void drop() = 0;

  SceneWidget& scene_;

 private:
  void follow(const QPointF& position, bool turning);

  QPointF last_;
};

}  // namespace glissade
