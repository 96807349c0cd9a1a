#pragma once

#include <QString>

#include "engine/files/scenario.h"

namespace glissade {

/// The name, without a folder, that a dialog proposes for a file about the scenario's product. `what` "path.mp4" gives
/// "pump-path.mp4"; ".json" gives "pump.json".
QString proposedFile(const LoadedScenario& scenario, const QString& what);

}  // namespace glissade
