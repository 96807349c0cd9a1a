#include "app/cli/path_output.h"

#include <filesystem>

namespace glissade::cli {

Outcome writePath(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                  const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".json") return writePathJson(path, scenario, provenance, file);
  if (ending == ".path") return writePathOmpl(path, file);
  return writePathCsv(path, scenario, file);
}

}  // namespace glissade::cli
