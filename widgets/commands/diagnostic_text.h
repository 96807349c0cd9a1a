#pragma once

#include <QString>

#include "engine/base/diagnostic.h"

namespace glissade {

/// A text of the engine in the user's language: where it is, or is made from, one of those that are known, else as it
/// is. What it says of names and numbers stays.
QString engineText(const std::string& text);

/// The same of a reason and the advice, as sentences. File and place are left out.
QString diagnosticText(const Diagnostic& why);

/// All of it on one line, as toString() has it: file, place, reason, advice.
QString diagnosticLine(const Diagnostic& why);

}  // namespace glissade
