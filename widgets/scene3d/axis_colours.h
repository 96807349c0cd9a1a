#pragma once

#include <QRgb>

#include <array>

namespace glissade {

/// Of the axes x, y, z wherever they are drawn; a letter goes with each.
inline constexpr std::array<QRgb, 3> kAxisColours{0xffd55e00, 0xff009e73, 0xff2f7fd0};

}  // namespace glissade
