#pragma once

#include <QString>

#include "engine/base/file_save.h"
#include "engine/sequence/plan_bodies.h"
#include "widgets/sequence/sequence_panel.h"

namespace glissade {

/// Writes a plan in the format of the file's ending: .json as the command line does, .csv, .glb. `product`: the plan's
/// product file, or a name if there is none. Errors: Usage for another ending; those of writing.
SaveResult writeSequence(const ShownPlan& shown, PlanOrder order, const std::string& product, const std::string& name,
                         const QString& file);

/// Whether the file is a document: .html or .pdf.
bool isDocument(const QString& file);

}  // namespace glissade
