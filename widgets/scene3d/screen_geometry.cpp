#include "widgets/scene3d/screen_geometry.h"

#include <cmath>

namespace glissade {

HeadPose restingHead(const ScreenGeometry& screen) { return {Vector3(0.0, 0.0, screen.distance)}; }

double fieldOfView(const ScreenGeometry& screen, double pictureHeight) {
  return 2.0 * std::atan(0.5 * pictureHeight / screen.distance);
}

EyePlace eyePlaceOf(const ScreenGeometry& screen, double pictureHeight, const HeadPose& head, std::optional<Eye> eye) {
  EyePlace eyePlace;
  eyePlace.head = (head.position - restingHead(screen).position) / pictureHeight;
  if (eye) {
    const double aside = (*eye == Eye::Left ? -0.5 : 0.5) * screen.eyeSeparation;
    eyePlace.eye = head.orientation * Vector3(aside, 0.0, 0.0) / pictureHeight;
  }
  return eyePlace;
}

}  // namespace glissade
