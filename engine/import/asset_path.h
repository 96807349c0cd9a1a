#pragma once

#include <string>

#include "engine/import/asset.h"

namespace glissade {

/// The file of an asset of a scenario in `folder`. An asset may be outside of the scenario's folder, because a scenario
/// that is saved elsewhere leaves its assets in place. Files that a URDF file names may not be outside of that file's
/// folder.
std::string assetFile(const Asset& asset, const std::string& folder);

/// The path by which a scenario in `folder` names a file. It is relative if the file is below the folder, or if they
/// share more than the root, so that a common folder can be moved; else it is absolute, because a relative path through
/// the root would break with any move.
std::string assetPathFrom(const std::string& folder, const std::string& file);

/// A unique name for a file: absolute and without symbolic links. The name does not depend on the folder from which it
/// is given, where ".." of a linked folder is not the folder of the link.
std::string withoutLinks(const std::string& path);

}  // namespace glissade
