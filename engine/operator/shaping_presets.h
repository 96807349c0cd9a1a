#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/operator/device_shaping.h"

namespace glissade {

/// Kind of an input device.
enum class InputKind { Keyboard, Mouse6D, Gamepad, LeftController, RightController };

/// A predefined shaping.
struct ShapingPreset {
  std::string id;
  CatalogueText label;
  DeviceShaping shaping;
};

/// The presets for a kind; "standard" comes first. Dead zones suit the kind of device: keys have none, sticks rest
/// inexactly.
std::vector<ShapingPreset> shapingPresets(InputKind kind);

/// The preset "standard" of a kind.
DeviceShaping standardShaping(InputKind kind);

}  // namespace glissade
