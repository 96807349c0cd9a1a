#pragma once

#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct InfoOptions {
  std::string scenario;
  bool places = false;  ///< build the environment model, too
  Format format = Format::Text;
};

/// glissade-cli info: bodies, triangles, units, what the meshes are worth as solids, and on
/// request octree, places and borders.
int runInfo(const InfoOptions& options);

}  // namespace glissade::cli
