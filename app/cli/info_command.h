#pragma once

#include <string>

#include "app/cli/report.h"

namespace glissade::cli {

struct InfoOptions {
  std::string scenario;
  Format format = Format::Text;
};

/// glissade-cli info: bodies, triangles, units and what the meshes are worth as solids.
int runInfo(const InfoOptions& options);

}  // namespace glissade::cli
