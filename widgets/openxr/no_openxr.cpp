// Replaces openxr_headset.cpp in a program that is built without OpenXR.
#include "widgets/openxr/openxr_headset.h"

namespace glissade {

std::unique_ptr<Headset> makeHeadset(SceneView& /*view*/) { return nullptr; }

}  // namespace glissade
