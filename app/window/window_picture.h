#pragma once

#include <QImage>
#include <QMainWindow>

namespace glissade {

/// Picture of the whole window, with the dialogs over it.
QImage pictureOf(QMainWindow& window);

}  // namespace glissade
