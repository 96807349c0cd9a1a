#pragma once

#include <optional>
#include <string>

#include "engine/base/enum_names.h"
#include "engine/base/result.h"
#include "engine/model/drive_kind.h"

namespace glissade {

/// Kinds of standard parts.
enum class StandardPart { Screw, SetScrew, Nut, Washer, Insert, Pin, Bearing, Ring, Belt, Seal };

/// Names for people.
inline constexpr EnumNames<StandardPart, 10> kStandardPartNames{
    {GLISSADE_TEXT("screw").english, GLISSADE_TEXT("set screw").english, GLISSADE_TEXT("nut").english,
     GLISSADE_TEXT("washer").english, GLISSADE_TEXT("insert").english, GLISSADE_TEXT("pin").english,
     GLISSADE_TEXT("bearing").english, GLISSADE_TEXT("retaining ring").english, GLISSADE_TEXT("belt").english,
     GLISSADE_TEXT("seal").english}};

/// A standard part as a name states it: "ISO 4762 M3x8", "M3x8 SHCS", "608ZZ".
struct Designation {
  StandardPart part = StandardPart::Screw;
  std::string text{};     ///< standard or abbreviation with the size: "DIN 912 M4x12"
  double diameter = 0.0;  ///< metres, outer diameter of a thread, bore of a bearing; 0: not stated
  double length = 0.0;    ///< metres; 0: not stated
  double pitch = 0.0;     ///< metres, below 0: left-handed; 0: coarse pitch of ISO 261, or no thread
  DriveKind drive = DriveKind::None;
  double driveSize = 0.0;  ///< metres, from the standard and the diameter; 0: not known
};

/// The standard part that a body's name states; nothing if it states none.
std::optional<Designation> designationIn(const std::string& name);

/// True if the last word of the name is one for a rod, an axle or a pin: "spring rod". Rods may have threads.
bool isShaftName(const std::string& name);

/// designationIn() for the text of a person. Errors, Usage: an unknown standard, a text that states no part.
Result<Designation> designationOf(const std::string& text);

/// The key or wrench for the drive of a thread of this diameter, by its standards, metres; 0: not known.
double usualDriveSize(DriveKind drive, double diameter);

}  // namespace glissade
