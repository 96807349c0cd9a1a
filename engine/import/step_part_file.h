#pragma once

#include <string>

namespace glissade {

/// Where a file is that a STEP file names for a part.
struct FoundStepPart {
  std::string name;    ///< below the product's folder, '/' separated
  std::string file;    ///< to open; empty: it is not there
  std::string whyNot;  ///< "is not there"
};

/// Looks for a file that is named in a file of the folder `inFolder` below `productFolder` (empty: that folder itself).
/// Names may have '\\' for '/'. What is named with a drive or from the root is looked for by its last name, because it
/// is from another machine. Nothing outside the product's folder is found, also not through symbolic links.
FoundStepPart findStepPart(const std::string& productFolder, const std::string& inFolder, const std::string& named);

}  // namespace glissade
