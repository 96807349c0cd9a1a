#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace glissade {

/// The ways to compose one picture from the pictures of two eyes.
enum class StereoMode {
  Off,
  Anaglyph,      ///< red of the left eye, green and blue of the right one
  SideBySide,    ///< each at half its width
  TopBottom,     ///< each at half its height
  Interlaced,    ///< rows of the screen in turn, the uppermost of the left eye
  Checkerboard,  ///< pixels of the screen in turn, the first one of the left eye
  QuadBuffer,    ///< each in a separate buffer of the driver
  LeftEye,       ///< one eye only
  RightEye
};

enum class Eye { Left, Right };

constexpr Eye otherEye(Eye eye) { return eye == Eye::Left ? Eye::Right : Eye::Left; }

struct StereoModeEntry {
  StereoMode mode;
  const char* name;    ///< on the command line and in settings
  const char* action;  ///< id in the action catalogue
};

/// The modes in the order of StereoMode.
inline constexpr std::array kStereoModes{
    StereoModeEntry{StereoMode::Off, "off", "stereo.off"},
    StereoModeEntry{StereoMode::Anaglyph, "anaglyph", "stereo.anaglyph"},
    StereoModeEntry{StereoMode::SideBySide, "side-by-side", "stereo.side-by-side"},
    StereoModeEntry{StereoMode::TopBottom, "top-bottom", "stereo.top-bottom"},
    StereoModeEntry{StereoMode::Interlaced, "interlaced", "stereo.interlaced"},
    StereoModeEntry{StereoMode::Checkerboard, "checkerboard", "stereo.checkerboard"},
    StereoModeEntry{StereoMode::QuadBuffer, "quad-buffer", "stereo.quad-buffer"},
    StereoModeEntry{StereoMode::LeftEye, "left-eye", "stereo.left-eye"},
    StereoModeEntry{StereoMode::RightEye, "right-eye", "stereo.right-eye"}};

constexpr const StereoModeEntry& entryOf(StereoMode mode) { return kStereoModes[static_cast<std::size_t>(mode)]; }

/// Nothing if no mode has this name.
constexpr std::optional<StereoMode> stereoModeNamed(std::string_view name) {
  for (const StereoModeEntry& entry : kStereoModes) {
    if (name == entry.name) return entry.mode;
  }
  return std::nullopt;
}

}  // namespace glissade
