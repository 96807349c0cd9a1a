#pragma once

#include <QString>

#include "engine/base/file_save.h"
#include "engine/base/work_watch.h"
#include "engine/documents/instruction/instruction_html.h"
#include "engine/documents/instruction/instruction_layout.h"
#include "widgets/instruction/step_drawer.h"

namespace glissade {

/// Writes an instruction as PDF: pages of instructionPages(), with searchable text. May be called on any thread; needs
/// a QGuiApplication for its fonts. Errors: Interrupted after a stop; a file that cannot be written; a logo that cannot
/// be read.
SaveResult writeInstructionPdf(const WorkInstruction& instruction, const InstructionTemplate& look, Paper paper,
                               const StepDrawer& drawer, const QString& file, const WorkWatch& watch = {});

/// The pictures of an instruction as HTML; fewer after a stop.
InstructionPictures instructionPictures(const WorkInstruction& instruction, const StepDrawer& drawer,
                                        const WorkWatch& watch = {});

}  // namespace glissade
