#pragma once

#include <QString>

#include "engine/scenario/scenario.h"
#include "engine/session/session.h"

namespace glissade {

/// What happens, in words for the status line.
QString statusText(const SessionSnapshot& snapshot);
/// How long the run takes or took, and its limit where it has one: "3.2 s of 60 s".
QString elapsedText(const SessionSnapshot& snapshot);

}  // namespace glissade
