#include "widgets/scene3d/navigation_style.h"

namespace glissade {
namespace {

CameraDrag dragOfMiddle(bool pans, bool zooms) {
  if (pans) return CameraDrag::Pan;
  return zooms ? CameraDrag::Zoom : CameraDrag::Orbit;
}

/// `orbit`: the motion by the left button alone.
CameraDrag dragOfLeft(Qt::MouseButtons buttons, Qt::KeyboardModifiers keys, CameraDrag orbit) {
  const bool left = buttons.testFlag(Qt::LeftButton);
  if (buttons.testFlag(Qt::MiddleButton) || (left && keys.testFlag(Qt::ShiftModifier))) return CameraDrag::Pan;
  if (left) return orbit;
  return buttons.testFlag(Qt::RightButton) ? CameraDrag::Zoom : CameraDrag::None;
}

CameraDrag dragOfGesture(Qt::MouseButtons buttons) {
  const bool left = buttons.testFlag(Qt::LeftButton);
  const bool right = buttons.testFlag(Qt::RightButton);
  if (left && right) return CameraDrag::Roll;
  if (left) return CameraDrag::Orbit;
  return right || buttons.testFlag(Qt::MiddleButton) ? CameraDrag::Pan : CameraDrag::None;
}

}  // namespace

CameraDrag cameraDragOf(NavigationStyle style, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys) {
  const bool middle = buttons.testFlag(Qt::MiddleButton);
  const bool shift = keys.testFlag(Qt::ShiftModifier);
  const bool control = keys.testFlag(Qt::ControlModifier);
  switch (style) {
    case NavigationStyle::Standard: return dragOfLeft(buttons, keys, CameraDrag::Orbit);
    case NavigationStyle::Trackball: return dragOfLeft(buttons, keys, CameraDrag::Tumble);
    case NavigationStyle::Cad: return middle ? dragOfMiddle(control, shift) : CameraDrag::None;
    case NavigationStyle::Blender: return middle ? dragOfMiddle(shift, control) : CameraDrag::None;
    case NavigationStyle::Gesture: return dragOfGesture(buttons);
  }
  return CameraDrag::None;
}

}  // namespace glissade
