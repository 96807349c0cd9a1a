#pragma once

#include <QString>

#include "engine/base/enum_names.h"
#include "widgets/scene3d/screen_geometry.h"

namespace glissade {

/// The point of the scene that lies in the plane of the screen.
enum class Convergence {
  Focus,   ///< the point about which the view turns
  Object,  ///< the object
  Pointer  ///< the point on which the pointer rested last
};

inline constexpr EnumNames<Convergence, 3> kConvergenceNames{{"focus", "object", "pointer"}};

/// A user's settings of stereo and of the screen. WindowMemory keeps them.
struct StereoSettings {
  StereoMode mode = StereoMode::Off;
  bool swapped = false;  ///< the right eye sees the left picture
  Convergence convergence = Convergence::Focus;
  ScreenGeometry screen;
  QString display;  ///< name of the display for full screen; empty: the window's display
};

}  // namespace glissade
