#pragma once

#include <QPointer>
#include <QWidget>

#include <array>
#include <functional>

#include "widgets/scene3d/scene_widget.h"
#include "widgets/scene3d/stereo_picture.h"

class QHelpEvent;
class QMouseEvent;

namespace glissade {

/// Covers the widget of a scene with a picture for two eyes: the scene as each eye sees it, with all that lies over
/// it, composed by a mode. Where each eye has a part of the picture, the mouse works in both parts.
class StereoScreen final : public QWidget {
  Q_OBJECT

 public:
  /// The places of the left and of the right eye, asked for before each picture.
  using Eyes = std::function<std::array<EyePlace, 2>()>;

  StereoScreen(SceneWidget& scene, Eyes eyes);

  /// Off hides it. `swapped`: the picture of the left eye is shown to the right one.
  /// QuadBuffer does nothing where the driver has none.
  void setMode(StereoMode mode, bool swapped);
  StereoMode mode() const { return mode_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::array<QImage, 2> picturesOfEyes();
  void paintOver(QImage& picture, const EyePlace& eyePlace);
  QPoint cornerOnScreen() const;
  void watch(QObject* child);
  EyePoint point(const QPointF& at);
  QWidget* widgetAt(const QPointF& at) const;
  void enter(QWidget* target);
  void forwardMouse(const QMouseEvent& event);
  void forwardWheel(const QWheelEvent& event);
  void forwardHelp(const QHelpEvent& event);

  SceneWidget& scene_;
  Eyes eyes_;
  StereoMode mode_ = StereoMode::Off;
  bool swapped_ = false;
  QImage composed_;
  std::unique_ptr<QuadBuffer> quadBuffer_;  ///< in that mode only
  Eye pointerEye_ = Eye::Left;    ///< which the pointer is shown to; the camera of the scene is where this eye is
  QPointF pointer_;               ///< in what the eyes see
  QPointer<QWidget> under_;       ///< the pointer
  std::optional<Eye> pressedIn_;  ///< a button is held: it was pressed in the part of this eye
};

}  // namespace glissade
