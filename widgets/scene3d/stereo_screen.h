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

/// Covers the widget of a scene with a picture for two eyes: the scene as each eye sees it, with all widgets over it,
/// composed by a mode. If each eye has a part of the picture, the mouse works in both parts.
class StereoScreen final : public QWidget {
  Q_OBJECT

 public:
  /// The places of the left and of the right eye, called before each picture.
  using Eyes = std::function<std::array<EyePlace, 2>()>;

  StereoScreen(SceneWidget& scene, Eyes eyes);

  /// Sets the mode; off hides the widget. `swapped`: the picture of the left eye is shown to the right one. QuadBuffer
  /// does nothing if the driver has no such buffers.
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
  std::unique_ptr<QuadBuffer> quadBuffer_;  ///< in QuadBuffer only
  Eye pointerEye_ = Eye::Left;    ///< the eye to which the pointer is shown; the camera of the scene is at this eye
  QPointF pointer_;               ///< in the picture of the eye
  QPointer<QWidget> under_;       ///< the widget under the pointer
  std::optional<Eye> pressedIn_;  ///< while a button is held: the eye in whose part it was pressed
};

}  // namespace glissade
