#pragma once

#include <QString>

#include <array>

#include "widgets/scene3d/screen_geometry.h"

namespace glissade {

/// What of the scene lies in the plane of the screen: neither before it nor behind it.
enum class Convergence {
  Focus,   ///< what the view turns about
  Object,  ///< the object that moves
  Pointer  ///< what the pointer rested on last
};

/// Under these names, in the order of Convergence, settings keep them.
inline constexpr std::array<const char*, 3> kConvergenceNames{"focus", "object", "pointer"};

/// A user's choices about pictures for two eyes, and about the screen. WindowMemory keeps them.
struct StereoSettings {
  StereoMode mode = StereoMode::Off;
  bool swapped = false;  ///< the picture of the left eye is shown to the right one
  Convergence convergence = Convergence::Focus;
  ScreenGeometry screen;
  QString display;  ///< name of the one that a full screen is shown on; empty: that of the window
};

}  // namespace glissade
