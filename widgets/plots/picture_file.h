#pragma once

#include <QImage>
#include <QString>

#include "engine/base/file_save.h"

namespace glissade {

/// Saves a picture as a whole or not at all (saveFile of file_save.h), in the format that the name's ending says, or
/// in `format` ("PNG") whatever the name is.
/// Errors: an ending that Qt writes no pictures for, or a file that cannot be written.
SaveResult savePicture(const QImage& picture, const QString& file, const char* format = nullptr);

}  // namespace glissade
