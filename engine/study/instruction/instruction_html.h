#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/study/instruction/instruction_template.h"
#include "engine/study/instruction/work_instruction.h"

namespace glissade {

/// Pictures of an instruction, each a PNG file's bytes.
struct InstructionPictures {
  std::string finished;                                   ///< the product
  std::vector<std::string> panels;                        ///< of each panel
  std::map<std::vector<std::string>, std::string> parts;  ///< by the ids of what is drawn
};

/// The 3D view of an instruction.
struct InstructionScene {
  std::string glb;      ///< planAsGlb() in the order of assembly
  std::string library;  ///< script of three.js with its loader and its controls
};

/// An instruction as one HTML page for a tablet that needs nothing else and asks no network: a panel at a time, large
/// buttons, arrow keys, swipes. `scene`: with a 3D view of each step of the product; null: pictures only. Errors: a
/// logo that cannot be read.
Result<std::string> instructionHtml(const WorkInstruction& instruction, const InstructionTemplate& look,
                                    const InstructionPictures& pictures, const InstructionScene* scene);

}  // namespace glissade
