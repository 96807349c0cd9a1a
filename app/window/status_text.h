#pragma once

#include <QString>

#include "engine/scenario/scenario.h"
#include "engine/session/session.h"

namespace glissade {

/// What happens, in words for the status line.
QString statusText(const SessionSnapshot& snapshot);

}  // namespace glissade
