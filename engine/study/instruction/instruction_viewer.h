#pragma once

#include "engine/study/instruction/instruction_html.h"

namespace glissade {

/// Where Debian's libjs-three is.
inline constexpr const char* kThreeFolder = "/usr/share/javascript/three";

/// The 3D view of an instruction, of the animation and of three.js in this folder. Errors: FileUnreadable where the
/// library is not there, with the package that has it; LimitReached where the animation is too large for a tablet.
Result<InstructionScene> instructionScene(const std::string& glb, const std::string& folder = kThreeFolder);

}  // namespace glissade
