#pragma once

#include <QImage>
#include <QMainWindow>

namespace glissade {

/// The whole window as a picture, with the dialogs that lie over it.
QImage pictureOf(QMainWindow& window);

}  // namespace glissade
