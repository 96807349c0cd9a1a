#pragma once

#include <QString>

#include "engine/base/result.h"
#include "widgets/manual/manual_facts.h"

namespace glissade {

/// Writes the manual as HTML: FOLDER/LANGUAGE/PAGE.html and FOLDER/manual.css. Pictures are FOLDER/pictures/NAME.png,
/// which the build puts there. Folders are made. Errors: as manualPages(), and files that cannot be written.
Outcome writeManual(const ManualFacts& facts, const QString& folder);

}  // namespace glissade
