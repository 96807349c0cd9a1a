#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/base/stop_token.h"
#include "engine/files/scenario.h"
#include "engine/model/fit_options.h"

namespace glissade {

/// Parses scenario JSON (any version; migrated) without touching assets. Errors are MalformedInput
/// with the JSON pointer as location; unknown keys are errors. `file` is used in messages only.
Result<Scenario> parseScenario(const std::string& text, const std::string& file);

/// Canonical JSON (fixed key order, shortest round-trip numbers, two-space indent, final newline):
/// parse then write of a canonical file is byte-identical.
std::string writeScenario(const Scenario& scenario);

/// The JSON schema of scenario files: resources/schema/scenario-1.schema.json.
nlohmann::ordered_json scenarioSchema();

/// Reads a scenario file or an OMPL.app .cfg (by its ending), imports all geometry, checks it, and builds the problem.
/// Start and goal in collision are not errors here; a session reports them at its start. Reading a STEP file may take
/// long. Error after a stop: Interrupted.
/// Fits that the options turn off are not searched for.
Result<LoadedScenario> loadScenario(const std::string& file, const StopToken& stop = {}, const FitOptions& fits = {});

/// Time at which the fits of a scenario are found, if it has them on.
enum class FindFits {
  Now,
  LaterIfLarge,  ///< later where preparing the world takes seconds: LoadedScenario::fitsPending
};

/// Loads the geometry of a scenario value whose assets are relative to `folder`. Geometry in `known` (of a scenario
/// loaded before) is not read again. Preparations of `before` (null: none) for collision queries are reused.
Result<LoadedScenario> loadGeometry(Scenario scenario, const std::string& folder, const std::string& file,
                                    const GeometryCache& known = {}, const StopToken& stop = {},
                                    const LoadedScenario* before = nullptr, FindFits fits = FindFits::Now);

/// SHA-256 of the loaded asset; of its present file where it was not loaded. Errors: it cannot be read.
Result<std::string> assetSha256(const Asset& asset, const std::string& scenarioFile);

/// Fills in the content hashes of assets that were not loaded, then saves atomically (write, fsync, read back,
/// rename, fsync the folder). The old file survives any failure.
Outcome saveScenario(const Scenario& scenario, const std::string& file);

}  // namespace glissade
