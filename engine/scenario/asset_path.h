#pragma once

#include <string>

#include "engine/scenario/scenario.h"

namespace glissade {

/// The file of an asset of a scenario in `folder`. An asset may lie outside the scenario's
/// folder, since a scenario that is saved elsewhere leaves its assets where they are; what a URDF file
/// names itself may not leave the folder of that file.
std::string assetFile(const Asset& asset, const std::string& folder);

/// How a scenario in `folder` names a file. What lies below the folder, or shares more than the root with
/// it, is named relatively, so that a common folder can be moved as a whole; the rest absolutely, because
/// a way through the root would break with any move.
std::string assetPathFrom(const std::string& folder, const std::string& file);

/// The scenario as it has to be written into another file: its assets are named as seen from there.
/// `oldFile` is empty where the scenario was never saved.
Scenario movedTo(const std::string& newFile, Scenario scenario, const std::string& oldFile);

}  // namespace glissade
