#pragma once

#include <string>
#include <vector>

#include "app/cli/report.h"

namespace glissade::cli {

struct InfoOptions {
  std::string file;
  bool places = false;              ///< build the environment model, too
  bool saveRegions = false;         ///< write where the forbidden places are into the scenario file
  std::vector<std::string> open{};  ///< parts of several solids that are taken as their solids
  Format format = Format::Text;
};

/// glissade-cli info: bodies, triangles, units, what the meshes are worth as solids, and on
/// request octree, places and borders. Of a part file its bodies.
int runInfo(const InfoOptions& options);

}  // namespace glissade::cli
