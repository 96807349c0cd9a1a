#pragma once

namespace glissade {

/// Style sheet of an instruction's page.
extern const char* const kInstructionStyle;
/// Script that shows a panel at a time.
extern const char* const kInstructionScript;
/// Script of the 3D view; it needs three.js.
extern const char* const kInstructionSceneScript;

}  // namespace glissade
