#pragma once

#include <QColor>
#include <QIcon>

namespace glissade {

/// A square of one colour, for rows of trees and tables. It is painted each time it is needed, so that temporary
/// swatches leave nothing in Qt's cache of pixmaps.
QIcon colourSwatch(const QColor& colour);

}  // namespace glissade
