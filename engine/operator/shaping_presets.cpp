#include "engine/operator/shaping_presets.h"

namespace glissade {
namespace {

double deadZoneOf(InputKind kind) {
  switch (kind) {
    case InputKind::Keyboard: return 0.0;
    case InputKind::Mouse6D: return 0.05;
    case InputKind::Gamepad:
    case InputKind::LeftController:
    case InputKind::RightController: return 0.15;
  }
  return 0.0;
}

DeviceShaping withCurve(DeviceShaping shaping, double exponent) {
  for (AxisShaping& axis : shaping.axes) axis.exponent = exponent;
  return shaping;
}

/// For placing a part exactly: fine about the centre.
DeviceShaping cad(const DeviceShaping& standard) { return withCurve(standard, 2.0); }

/// One axis at a time, slowly, and without the trembling of a hand.
DeviceShaping beginner(const DeviceShaping& standard) {
  DeviceShaping shaping = withCurve(standard, 1.5);
  for (AxisShaping& axis : shaping.axes) axis.deadZone *= 2.0;
  shaping.dominantAxis = true;
  shaping.linearSpeed = 0.5;
  shaping.angularSpeed = 0.5;
  return shaping;
}

/// For narrow passages.
DeviceShaping precise(const DeviceShaping& standard) {
  DeviceShaping shaping = withCurve(standard, 2.5);
  shaping.linearSpeed = 0.25;
  shaping.angularSpeed = 0.4;
  return shaping;
}

/// Like an aeroplane's stick: in the object's own axes, pushing forward moves down.
DeviceShaping flight(const DeviceShaping& standard) {
  DeviceShaping shaping = withCurve(standard, 1.5);
  shaping.frame = MotionFrame::Object;
  shaping.axes[3].inverted = true;
  return shaping;
}

}  // namespace

DeviceShaping standardShaping(InputKind kind) {
  DeviceShaping shaping;
  for (AxisShaping& axis : shaping.axes) axis.deadZone = deadZoneOf(kind);
  return shaping;
}

std::vector<ShapingPreset> shapingPresets(InputKind kind) {
  const DeviceShaping standard = standardShaping(kind);
  return {{"standard", GLISSADE_TEXT("Standard"), standard},
          {"cad", GLISSADE_TEXT("As in CAD"), cad(standard)},
          {"beginner", GLISSADE_TEXT("Beginner"), beginner(standard)},
          {"precise", GLISSADE_TEXT("Precise"), precise(standard)},
          {"flight", GLISSADE_TEXT("Flight"), flight(standard)}};
}

}  // namespace glissade
