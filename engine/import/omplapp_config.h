#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// A problem file of OMPL.app (INI), without its geometry.
struct OmplAppConfig {
  std::string name;
  std::string robot;  ///< mesh file beside the .cfg; it is moved so that its vertex mean is the reference point
  std::string world;  ///< mesh file beside the .cfg; may be empty
  Pose start;
  Pose goal;
  Box3 volume;  ///< extended to contain start and goal, as in OMPL.app
};

/// Reads a .cfg file; errors are MalformedInput with the line or key as location.
Result<OmplAppConfig> readOmplAppConfig(const std::string& file);

}  // namespace glissade
