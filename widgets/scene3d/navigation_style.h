#pragma once

#include <Qt>
#include <QtGlobal>

#include <array>

namespace glissade {

/// The buttons and keys that move the camera, as in other programs.
enum class NavigationStyle {
  Standard,   ///< left orbits, middle or Shift + left pans, right zooms
  Cad,        ///< middle orbits, Ctrl + middle pans, Shift + middle zooms, as in SolidWorks
  Blender,    ///< middle orbits, Shift + middle pans, Ctrl + middle zooms
  Gesture,    ///< left orbits, right pans, both roll, as in FreeCAD's gesture navigation
  Trackball,  ///< as Standard, but the horizon does not stay level
};

/// The motion of the camera by a drag of the mouse.
enum class CameraDrag { None, Orbit, Tumble, Roll, Pan, Zoom };

/// The motion for a drag with these buttons and keys. The wheel zooms and a double click fits in every style.
CameraDrag cameraDragOf(NavigationStyle style, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys);

struct NavigationStyleEntry {
  NavigationStyle style;
  const char* action;  ///< id of the action that selects it
};

inline constexpr std::array<NavigationStyleEntry, 5> kNavigationStyles{
    {{NavigationStyle::Standard, "navigation.standard"},
     {NavigationStyle::Cad, "navigation.cad"},
     {NavigationStyle::Blender, "navigation.blender"},
     {NavigationStyle::Gesture, "navigation.gesture"},
     {NavigationStyle::Trackball, "navigation.trackball"}}};

}  // namespace glissade
