#pragma once

#include <array>
#include <cstdint>

namespace glissade {

/// Colours of the axes x, y, z wherever they are drawn, as 0xAARRGGBB; each axis also has its letter.
inline constexpr std::array<std::uint32_t, 3> kAxisColours{0xffd55e00, 0xff009e73, 0xff2f7fd0};

}  // namespace glissade
