#include "engine/import/input_file.h"
#include "engine/import/sha256.h"
#include "engine/scenario/atomic_file.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {

Outcome saveScenario(const Scenario& scenario, const std::string& file) {
  Scenario saved = scenario;
  for (Asset& asset : saved.assets) {
    const Result<std::string> path = resolveInside(folderOf(file), asset.path);
    if (!path) return path.error();
    const Result<std::string> content = readInputFile(*path, kLargestMeshFile);
    if (!content) return content.error();
    asset.sha256 = sha256(*content);
  }
  const std::string text = writeScenario(saved);
  if (const Result<Scenario> readBack = parseScenario(text, file); !readBack) return readBack.error();
  return writeFileAtomically(file, text);
}

}  // namespace glissade
