#pragma once

#include <string>
#include <vector>

#include "engine/operator/device_shaping.h"

namespace glissade {

/// What a person holds.
enum class InputKind { Keyboard, Mouse6D, Gamepad, LeftController, RightController };

/// A shaping to begin from.
struct ShapingPreset {
  std::string id;
  std::string label;  ///< English; listed for translation
  DeviceShaping shaping;
};

/// "standard" first. Dead zones suit the kind of device: keys have none, sticks rest inexactly.
std::vector<ShapingPreset> shapingPresets(InputKind kind);

/// The preset "standard".
DeviceShaping standardShaping(InputKind kind);

}  // namespace glissade
