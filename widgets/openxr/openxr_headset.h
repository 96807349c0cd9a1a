#pragma once

#include <memory>

#include "widgets/openxr/headset.h"

namespace glissade {

class SceneView;

/// Makes a headset that uses OpenXR; null if the program was built without OpenXR. It is in the library glissade_openxr
/// and needs a display.
std::unique_ptr<Headset> makeHeadset(SceneView& view);

}  // namespace glissade
