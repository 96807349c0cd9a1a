#pragma once

#include <string>

#include "engine/import/asset.h"

namespace glissade {

/// The file of an asset of a scenario in `folder`. An asset may lie outside the scenario's
/// folder, since a scenario that is saved elsewhere leaves its assets where they are; what a URDF file
/// names itself may not leave the folder of that file.
std::string assetFile(const Asset& asset, const std::string& folder);

/// How a scenario in `folder` names a file. What lies below the folder, or shares more than the root with
/// it, is named relatively, so that a common folder can be moved as a whole; the rest absolutely, because
/// a way through the root would break with any move.
std::string assetPathFrom(const std::string& folder, const std::string& file);

/// One name for a file, whichever folder it is named from: absolute and without symbolic links, because ".." of a
/// linked folder is not the folder that holds the link.
std::string withoutLinks(const std::string& path);

}  // namespace glissade
