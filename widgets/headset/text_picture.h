#pragma once

#include <QImage>
#include <QPalette>
#include <QString>

#include "widgets/openxr/flat_picture.h"

namespace glissade {

/// The picture in the format of a headset's scene. The image has the format RGBA8888_Premultiplied.
FlatPicturePtr flatPicture(const QImage& image);

/// A text on a background, as labels over the scene have it, in the size of the headset's panel.
FlatPicturePtr textPicture(const QString& text, const QPalette& palette, bool strong);

}  // namespace glissade
