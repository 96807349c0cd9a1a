#pragma once

#include <QImage>
#include <QPointF>

#include "widgets/scene3d/stereo_mode.h"

namespace glissade {

/// The pictures of two eyes, of one size, as one picture of that size. `corner`: where its upper left pixel is on the
/// screen, in device pixels: what is interlaced follows the screen. Modes that compose
/// nothing have the left one.
QImage composeStereo(StereoMode mode, const QImage& left, const QImage& right, const QPoint& corner);

/// A point of what an eye sees.
struct EyePoint {
  Eye eye;
  QPointF at;
};

/// Both eyes have their own part of the picture, so that a point of it belongs to one of them.
constexpr bool hasParts(StereoMode mode) { return mode == StereoMode::SideBySide || mode == StereoMode::TopBottom; }

/// What a point of a composed picture of this size shows. Where both eyes see the same pixels, it is that of the left
/// eye.
EyePoint eyePointAt(StereoMode mode, const QPointF& at, const QSizeF& size);
/// The same of a known eye, also for points beyond its part.
QPointF pointOfEye(StereoMode mode, Eye eye, const QPointF& at, const QSizeF& size);

}  // namespace glissade
