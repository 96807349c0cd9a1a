#pragma once

#include <QString>

#include "engine/files/scenario.h"
#include "engine/session/session.h"

namespace glissade {

/// The state of the run in words for the status line.
QString statusText(const SessionSnapshot& snapshot);
/// The duration of the run, with its limit if it has one: "3.2 s of 60 s".
QString elapsedText(const SessionSnapshot& snapshot);

}  // namespace glissade
