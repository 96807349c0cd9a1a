#pragma once

#include <optional>
#include <string>

#include "engine/base/file_save.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {

/// Scenarios as files that people open, edit and save again. scenario_io.h has what needs no file.

/// A loaded scenario together with what its file held then.
struct ScenarioFile {
  LoadedScenario scenario;
  std::string sha256;  ///< of the file's content; empty: it is an OMPL.app file, which is never saved
};

/// loadScenario for who will save the scenario into its file again.
Result<ScenarioFile> openScenarioFile(const std::string& file, const StopToken& stop = {},
                                      FindFits fits = FindFits::Now);

/// Fills in the content hashes of the assets, then saves as saveFile does (file_save.h), with kKeptVersions earlier
/// versions. `replaces` is the SHA-256 of the only content that may be replaced (ScenarioFile::sha256); nothing:
/// any content, whose earlier version is then kept or nothing is saved.
SaveResult saveScenarioFile(const Scenario& scenario, const std::string& file,
                            const std::optional<std::string>& replaces);

/// parseScenario with its warnings: a checksum that does not fit is one, because people edit scenarios by hand. A
/// text without a checksum is read as it is.
Result<Scenario> parseScenario(const std::string& text, const std::string& file, Warnings& warnings);

/// writeScenario without the checksum: what records and studies hash. It stays the same whatever checksums become.
std::string scenarioText(const Scenario& scenario);

}  // namespace glissade
