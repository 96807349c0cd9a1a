#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/product/joint.h"

namespace glissade {

/// What a standard part is.
enum class StandardPart { Screw, SetScrew, Nut, Washer, Insert, Pin, Bearing, Ring, Belt, Seal };

/// "screw", "set screw", "nut", ... for people.
const char* standardPartName(StandardPart part);

/// A standard part as a name states it: "ISO 4762 M3x8", "M3x8 SHCS", "608ZZ".
struct Designation {
  StandardPart part = StandardPart::Screw;
  std::string text{};     ///< the standard or the abbreviation, and the size: "DIN 912 M4x12"
  double diameter = 0.0;  ///< metres, of the thread outside, of a bearing inside; 0: not stated
  double length = 0.0;    ///< metres; 0: not stated
  double pitch = 0.0;     ///< metres, below 0: left-handed; 0: the coarse one of ISO 261, or no thread
  DriveKind drive = DriveKind::None;
  double driveSize = 0.0;  ///< metres, by the standard and the diameter; 0: not known
};

/// What the name of a body says; nothing where it names no standard part.
std::optional<Designation> designationIn(const std::string& name);

/// Whether the last word of a name is one of a rod, an axle or a pin: "spring rod". Rods may have threads.
bool isShaftName(const std::string& name);

/// As designationIn(), of what a person says. Errors, Usage: an unknown standard, nothing that is known.
Result<Designation> designationOf(const std::string& text);

/// The key or wrench for a drive of a thread of this diameter, by its standards: metres; 0: none is known.
double usualDriveSize(DriveKind drive, double diameter);

}  // namespace glissade
