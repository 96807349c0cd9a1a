#pragma once

#include <optional>

#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/stereo_mode.h"

namespace glissade {

/// The screen, and the distance of a person straight before it; metres.
struct ScreenGeometry {
  double width = 0.53;           ///< width of the whole screen: 24 inches at 16:9
  double distance = 0.65;        ///< distance of the eyes
  double eyeSeparation = 0.063;  ///< mean of adults (Dodgson 2004)

  friend bool operator==(const ScreenGeometry&, const ScreenGeometry&) = default;
};

/// The least value of each length, metres.
inline constexpr ScreenGeometry kLeastScreen{0.05, 0.1, 0.0};
inline constexpr ScreenGeometry kMostScreen{20.0, 20.0, 0.2};

/// The pose of a head before the picture, from the picture's middle; metres; x right, y up, z towards the person.
struct HeadPose {
  Vector3 position = Vector3::Zero();
  Quaternion orientation = Quaternion::Identity();  ///< identity if the head looks straight at the screen
};

/// The head of a person who does not move.
HeadPose restingHead(const ScreenGeometry& screen);

/// Vertical angle at which a picture of this height is seen from straight before it, radians: a camera with this angle
/// shows depth and width at one scale.
double fieldOfView(const ScreenGeometry& screen, double pictureHeight);

/// The place of an eye, or of the middle between both, for a picture of this height. The picture's plane is left open.
EyePlace eyePlaceOf(const ScreenGeometry& screen, double pictureHeight, const HeadPose& head, std::optional<Eye> eye);

}  // namespace glissade
