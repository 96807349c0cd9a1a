#pragma once

#include <QPalette>

#include "widgets/controls/dark_ground.h"

namespace glissade {

/// Whether the windows of a theme are dark.
inline bool isDark(const QPalette& palette) {
  const QColor& ground = palette.color(QPalette::Window);
  return isDarkGround(ground.redF(), ground.greenF(), ground.blueF());
}

}  // namespace glissade
