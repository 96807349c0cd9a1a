#pragma once

#include <Qt>
#include <QtGlobal>

#include <array>

namespace glissade {

/// Which buttons and keys move the camera, as other programs have them.
enum class NavigationStyle {
  Standard,   ///< left orbits, middle or Shift + left pans, right zooms
  Cad,        ///< middle orbits, Ctrl + middle pans, Shift + middle zooms: as SolidWorks
  Blender,    ///< middle orbits, Shift + middle pans, Ctrl + middle zooms
  Gesture,    ///< left orbits, right pans, both tilt: as FreeCAD's gesture navigation
  Trackball,  ///< as Standard, but the horizon does not stay level
};

/// What a drag of the mouse does to the camera.
enum class CameraDrag { None, Orbit, Tumble, Roll, Pan, Zoom };

/// What a drag with these buttons and keys does. The wheel zooms and a double click fits in every style.
CameraDrag cameraDragOf(NavigationStyle style, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys);

struct NavigationStyleEntry {
  NavigationStyle style;
  const char* action;  ///< id of the action that chooses it
};

inline constexpr std::array<NavigationStyleEntry, 5> kNavigationStyles{
    {{NavigationStyle::Standard, "navigation.standard"},
     {NavigationStyle::Cad, "navigation.cad"},
     {NavigationStyle::Blender, "navigation.blender"},
     {NavigationStyle::Gesture, "navigation.gesture"},
     {NavigationStyle::Trackball, "navigation.trackball"}}};

}  // namespace glissade
