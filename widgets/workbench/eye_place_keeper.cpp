#include "widgets/workbench/eye_place_keeper.h"

#include <QEvent>

#include <algorithm>
#include <utility>

namespace glissade {

EyePlaceKeeper::EyePlaceKeeper(SceneWidget& scene, std::function<int()> screenPixels, QObject* parent)
    : QObject(parent), scene_(scene), screenPixels_(std::move(screenPixels)) {
  scene.widget()->installEventFilter(this);
}

void EyePlaceKeeper::setScreen(const ScreenGeometry& screen) {
  screen_ = screen;
  apply();
}

void EyePlaceKeeper::setStereo(bool stereo) {
  stereo_ = stereo;
  apply();
}

void EyePlaceKeeper::setPlanePoint(PlanePoint planePoint) {
  planePoint_ = std::move(planePoint);
  apply();
}

void EyePlaceKeeper::setHead(const std::optional<HeadPose>& head) {
  head_ = head;
  apply();
}

bool EyePlaceKeeper::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) apply();
  return QObject::eventFilter(watched, event);
}

QSizeF EyePlaceKeeper::pictureSize() const {
  return QSizeF(scene_.widget()->size().expandedTo(QSize(1, 1))) * screen_.width / std::max(1, screenPixels_());
}

EyePlace EyePlaceKeeper::eyePlace(std::optional<Eye> eye) const {
  EyePlace eyePlace = eyePlaceOf(screen_, pictureSize().height(), head_.value_or(restingHead(screen_)), eye);
  if (planePoint_) eyePlace.plane_W = planePoint_();
  return eyePlace;
}

std::array<EyePlace, 2> EyePlaceKeeper::eyes() const { return {eyePlace(Eye::Left), eyePlace(Eye::Right)}; }

void EyePlaceKeeper::apply() {
  CameraController& camera = scene_.view().camera();
  if (stereo_ || head_) {
    camera.setFieldOfView(fieldOfView(screen_, pictureSize().height()));
    camera.setEyePlace(eyePlace(stereo_ ? std::make_optional(Eye::Left) : std::nullopt));
  } else {
    camera.setFieldOfView(CameraController::usualFieldOfView());
    camera.setEyePlace({});
  }
  scene_.refresh();
}

}  // namespace glissade
