#pragma once

#include <QObject>

#include <array>
#include <functional>
#include <optional>

#include "widgets/scene3d/scene_widget.h"
#include "widgets/scene3d/screen_geometry.h"

namespace glissade {

/// Keeps the camera of the scene at the person's eyes: for two eyes, for a tracked head, or both. With neither, the
/// camera is the usual one.
class EyePlaceKeeper final : public QObject {
  Q_OBJECT

 public:
  /// The point of the scene that lies in the plane of the screen; nothing: the camera's focus.
  using PlanePoint = std::function<std::optional<Vector3>()>;

  /// `screenPixels`: the width of the whole screen, in the pixels of widgets.
  EyePlaceKeeper(SceneWidget& scene, std::function<int()> screenPixels, QObject* parent);

  void setScreen(const ScreenGeometry& screen);
  const ScreenGeometry& screen() const { return screen_; }
  void setStereo(bool stereo);
  void setPlanePoint(PlanePoint planePoint);
  /// Sets the pose of the head; nothing: the head is not tracked.
  void setHead(const std::optional<HeadPose>& head);

  /// The present places of the left and the right eye.
  std::array<EyePlace, 2> eyes() const;
  /// The size of the scene on the screen, metres.
  QSizeF pictureSize() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  EyePlace eyePlace(std::optional<Eye> eye) const;
  void apply();

  SceneWidget& scene_;
  std::function<int()> screenPixels_;
  ScreenGeometry screen_;
  bool stereo_ = false;
  std::optional<HeadPose> head_;
  PlanePoint planePoint_;
};

}  // namespace glissade
