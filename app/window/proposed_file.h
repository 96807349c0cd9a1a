#pragma once

#include <QString>

#include "engine/scenario/scenario.h"

namespace glissade {

/// The name that a dialog proposes for a file about the product of the scenario, without a folder: "pump-path.mp4" of
/// "path.mp4"; "pump.json" of ".json".
QString proposedFile(const LoadedScenario& scenario, const QString& what);

}  // namespace glissade
