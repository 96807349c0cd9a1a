#pragma once

#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct InfoOptions {
  std::string file;
  bool places = false;       ///< build the environment model, too
  bool saveRegions = false;  ///< write where the forbidden places are into the scenario file
  Format format = Format::Text;
};

/// glissade-cli info: bodies, triangles, units, what the meshes are worth as solids, and on
/// request octree, places and borders. Of a part file its bodies.
int runInfo(const InfoOptions& options);

}  // namespace glissade::cli
