#pragma once

#include <QImage>
#include <QString>

#include "engine/base/file_save.h"

namespace glissade {

/// Saves a picture as a whole or not at all (saveFile of file_save.h), in the format of the name's extension, or in
/// `format` ("PNG") whatever the name is. Errors: an extension for which Qt writes no pictures, or a file that cannot
/// be written.
SaveResult savePicture(const QImage& picture, const QString& file, const char* format = nullptr);

}  // namespace glissade
