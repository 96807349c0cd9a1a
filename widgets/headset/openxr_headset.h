#pragma once

#include <memory>

#include "widgets/headset/headset.h"

namespace glissade {

class SceneView;

/// A headset through OpenXR, or null where the program was built without it. Library glissade_openxr; needs a display.
std::unique_ptr<Headset> makeHeadset(SceneView& view);

}  // namespace glissade
