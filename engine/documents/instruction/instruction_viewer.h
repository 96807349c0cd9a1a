#pragma once

#include "engine/documents/instruction/instruction_html.h"

namespace glissade {

/// Folder of Debian's package libjs-three.
inline constexpr const char* kThreeFolder = "/usr/share/javascript/three";

/// The 3D view of an instruction from the animation and from three.js in `folder`. Errors: FileUnreadable where the
/// library is missing, with the name of its package; LimitReached where the animation is too large for a tablet.
Result<InstructionScene> instructionScene(const std::string& glb, const std::string& folder = kThreeFolder);

}  // namespace glissade
