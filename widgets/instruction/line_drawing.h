#pragma once

#include <QColor>
#include <QImage>

#include <vector>

#include "engine/environment/rigid_body.h"
#include "widgets/instruction/projection.h"

namespace glissade {

/// A body of a drawing.
struct DrawnBody {
  MeshPtr mesh;
  Pose X_WB;
  QColor fill;
  QColor line;
  bool strong = false;  ///< with thick lines
};

/// The bodies as a drawing on white: light shades, and lines where a body ends, where its surface has a sharp edge, and
/// where a part of it is in front of another. Drawn by the processor, so that any thread can draw it.
QImage lineDrawing(const std::vector<DrawnBody>& bodies, const Projection& projection, const QSize& pixels);

}  // namespace glissade
