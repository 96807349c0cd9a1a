#pragma once

#include <QString>

#include "engine/base/result.h"
#include "widgets/help/manual_facts.h"

namespace glissade {

/// Writes the manual as HTML: FOLDER/LANGUAGE/PAGE.html and FOLDER/manual.css. The build puts the pictures into
/// FOLDER/pictures/NAME.png. Missing folders are made. Errors: those of manualPages(), and files that cannot be
/// written.
Outcome writeManual(const ManualFacts& facts, const QString& folder);

}  // namespace glissade
