#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/documents/instruction/instruction_template.h"
#include "engine/documents/instruction/work_instruction.h"

namespace glissade {

/// Pictures of an instruction; each is the content of a PNG file.
struct InstructionPictures {
  std::string finished;                              ///< picture of the finished product
  std::vector<std::string> panels;                   ///< one picture for each panel
  std::map<std::vector<BodyId>, std::string> parts;  ///< pictures of parts, by the ids of the drawn bodies
};

/// The 3D view of an instruction.
struct InstructionScene {
  std::string glb;      ///< planAsGlb() in the order of assembly
  std::string library;  ///< script of three.js with its loader and its controls
};

/// An instruction as one HTML page for a tablet. It needs no other file and no network. It shows one panel at a time
/// and has large buttons, arrow keys and swipes. `scene`: adds a 3D view of each step of the product; null: pictures
/// only. Errors: a logo that cannot be read.
Result<std::string> instructionHtml(const WorkInstruction& instruction, const InstructionTemplate& look,
                                    const InstructionPictures& pictures, const InstructionScene* scene);

}  // namespace glissade
