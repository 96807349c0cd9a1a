#pragma once

#include <string>

#include "engine/import/asset_path.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// The scenario as it has to be written into another file: its assets are named as seen from there.
/// `oldFile` is empty where the scenario was never saved.
Scenario movedTo(const std::string& newFile, Scenario scenario, const std::string& oldFile);

}  // namespace glissade
