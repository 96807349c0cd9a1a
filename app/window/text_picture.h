#pragma once

#include <QImage>
#include <QPalette>
#include <QString>

#include "widgets/headset/flat_picture.h"

namespace glissade {

/// For the scene of a headset. The image has the format RGBA8888_Premultiplied.
FlatPicturePtr flatPicture(const QImage& image);

/// A text on a ground of its own, in the size of the panel's, as labels over the scene are.
FlatPicturePtr textPicture(const QString& text, const QPalette& palette, bool strong);

}  // namespace glissade
