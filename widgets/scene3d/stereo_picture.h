#pragma once

#include <QImage>
#include <QPointF>

#include "widgets/scene3d/stereo_mode.h"

namespace glissade {

/// Composes the pictures of two eyes, of one size, into a picture of that size. `corner`: its upper left pixel on the
/// screen, in device pixels, because interlaced pictures follow the screen. RightEye gives the right picture, the other
/// modes that compose nothing the left one.
QImage composeStereo(StereoMode mode, const QImage& left, const QImage& right, const QPoint& corner);

/// A point of the picture of an eye.
struct EyePoint {
  Eye eye;
  QPointF at;
};

/// Whether each eye has its own part of the picture, so that a point of it belongs to one of them.
constexpr bool hasParts(StereoMode mode) { return mode == StereoMode::SideBySide || mode == StereoMode::TopBottom; }

/// The eye's point that is shown at a point of a composed picture of this size. If both eyes see the same pixels, it is
/// that of the left eye.
EyePoint eyePointAt(StereoMode mode, const QPointF& at, const QSizeF& size);
/// The point that is shown there to a known eye, also for points beyond its part.
QPointF pointOfEye(StereoMode mode, Eye eye, const QPointF& at, const QSizeF& size);

}  // namespace glissade
