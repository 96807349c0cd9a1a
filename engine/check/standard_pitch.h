#pragma once

#include <string>

namespace glissade::check {

/// True if a standard thread that is drawn as a shaft of this diameter has this pitch: metric threads of ISO 261,
/// unified threads (ASME B1.1), pipe threads (ISO 228), trapezoidal threads (ISO 2904), tapping screws (ISO 1478). The
/// shaft may be drawn anywhere from the core to a tenth outside of the nominal diameter. Metres.
bool isStandardPitch(double diameter, double pitch);

/// True if the name of a part says that its thread is left-handed: "M10x1.5 LH", "left hand screw".
bool saysLeftHanded(const std::string& name);

}  // namespace glissade::check
