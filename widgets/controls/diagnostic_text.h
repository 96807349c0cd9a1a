#pragma once

#include <QString>

#include "engine/base/diagnostic.h"

namespace glissade {

/// The language of the window and the unit of its lengths, for texts of the engine.
MessageStyle windowStyle();

/// A text of the engine in the style of the window.
QString engineText(const Message& message);

/// The reason and the advice in the user's language, as sentences, without file and place.
QString diagnosticText(const Diagnostic& why);

/// The whole diagnostic on one line, as toString() writes it: file, place, reason, advice.
QString diagnosticLine(const Diagnostic& why);

}  // namespace glissade
