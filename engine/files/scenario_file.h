#pragma once

#include <optional>
#include <string>

#include "engine/base/file_save.h"
#include "engine/files/scenario_io.h"

namespace glissade {

/// Scenarios as files that people open, edit and save again. Functions without files are in scenario_io.h.

/// A loaded scenario with the hash of its file.
struct ScenarioFile {
  LoadedScenario scenario;
  std::string sha256;  ///< hash of the file's content; empty: an OMPL.app file, which is never saved
};

/// loadScenario for a caller that will save the scenario into its file again.
Result<ScenarioFile> openScenarioFile(const std::string& file, const StopToken& stop = {},
                                      FindFits fits = FindFits::Now);

/// Fills in the content hashes of the assets, then saves as saveFile does (file_save.h), with kKeptVersions earlier
/// versions. `replaces` is the SHA-256 of the only content that may be replaced (ScenarioFile::sha256); nothing: any
/// content; it is kept as an earlier version, else nothing is saved.
SaveResult saveScenarioFile(const Scenario& scenario, const std::string& file,
                            const std::optional<std::string>& replaces);

/// parseScenario with warnings. A wrong checksum is a warning, because people edit scenarios by hand. A text without a
/// checksum is accepted.
Result<Scenario> parseScenario(const std::string& text, const std::string& file, Warnings& warnings);

/// writeScenario without the checksum: the text that records and studies hash. It does not depend on the method of the
/// checksum.
std::string scenarioText(const Scenario& scenario);

}  // namespace glissade
