#pragma once

#include <QObject>

#include <array>
#include <functional>
#include <optional>

#include "widgets/scene3d/scene_widget.h"
#include "widgets/scene3d/screen_geometry.h"

namespace glissade {

/// Keeps the camera of the scene where the eyes of the person are: for two eyes, for a tracked head, or both. As long
/// as there is neither, the camera is the usual one.
class EyePlaceKeeper final : public QObject {
  Q_OBJECT

 public:
  /// The point of the scene that lies in the plane of the screen; nothing: the focus.
  using PlanePoint = std::function<std::optional<Vector3>()>;

  /// `screenPixels`: the width of the whole screen, in the pixels of widgets.
  EyePlaceKeeper(SceneWidget& scene, std::function<int()> screenPixels, QObject* parent);

  void setScreen(const ScreenGeometry& screen);
  const ScreenGeometry& screen() const { return screen_; }
  void setStereo(bool stereo);
  void setPlanePoint(PlanePoint planePoint);
  /// Nothing: the head is not tracked.
  void setHead(const std::optional<HeadPose>& head);

  /// The places of the left and of the right eye, as they are now.
  std::array<EyePlace, 2> eyes() const;
  /// What the scene measures on the screen, metres.
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
