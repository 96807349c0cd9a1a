#pragma once

#include <QImage>

#include "engine/environment/rigid_body.h"

namespace glissade {

/// A small picture of a body as it lies in the product, from a corner above, on a transparent ground. Drawn by the
/// processor, without OpenGL, so that any thread can draw it. `pixels`: width and height.
QImage partPicture(const RigidBody& body, int pixels);

}  // namespace glissade
