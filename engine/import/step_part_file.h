#pragma once

#include <string>

#include "engine/base/message.h"

namespace glissade {

/// The result of a search for a file that a STEP file names for a part.
struct FoundStepPart {
  std::string name;  ///< relative to the product's folder, '/' as separator
  std::string file;  ///< path for opening; empty: the file does not exist
  Message whyNot;    ///< "is not there"
};

/// Searches a file that is named in a file of the folder `inFolder` below `productFolder` (empty: that folder). Names
/// may contain '\\' for '/'. Only the last name of an absolute path or one with a drive is used, because it is from
/// another machine. Files outside of the product's folder are not found, even through symbolic links.
FoundStepPart findStepPart(const std::string& productFolder, const std::string& inFolder, const std::string& named);

}  // namespace glissade
