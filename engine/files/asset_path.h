#pragma once

#include <string>

#include "engine/files/scenario.h"
#include "engine/import/asset_path.h"

namespace glissade {

/// The scenario for writing into another file: the paths of its assets are relative to that file. `oldFile` is empty
/// where the scenario was never saved.
Scenario movedTo(const std::string& newFile, Scenario scenario, const std::string& oldFile);

}  // namespace glissade
