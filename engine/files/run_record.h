#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/file_save.h"
#include "engine/base/work_watch.h"
#include "engine/files/scenario.h"
#include "engine/operator/run_log.h"
#include "engine/planning/planner.h"

namespace glissade {

/// A run as a file. It suffices to grow the same roadmap again, bit by bit, also where a person steered.
struct RunRecord {
  struct AssetHash {
    std::string id;
    std::string sha256;
  };

  /// Parts that a damaged journal has lost.
  struct Loss {
    std::size_t lines = 0;        ///< number of lines that are damaged or cut off
    std::uint64_t afterStep = 0;  ///< the record is complete up to this step
  };

  int version = 2;            ///< version of the file; version 1 has no semantic edits and no checkpoints
  std::string program;        ///< for example "Glissade 0.1.0"
  std::string build;          ///< compiler, processor, flags
  std::string scenario;       ///< the scenario's file; in the record relative to the record's folder
  std::string problemSha256;  ///< of the problem that was planned; empty in version 1
  std::vector<AssetHash> assets;
  std::map<ParameterId, double> parameters;  ///< parameters at the start
  RunLog log;                                ///< replayLog() sets its start.parameters
  std::optional<Loss> loss;                  ///< nothing: the record is complete
};

/// The record of a run of this scenario. Errors: an asset can no longer be read.
Result<RunRecord> makeRunRecord(const LoadedScenario& scenario, RunLog log);

/// The JSON schema of records of version 2: resources/schema/run-2.schema.json.
nlohmann::ordered_json runRecordSchema();

/// Replaces the run by another run of the same scenario.
void setLog(RunLog log, RunRecord& record);

/// Saves a record of version 2 with a checksum, atomically.
SaveResult writeRunRecord(const RunRecord& record, const std::string& file);
/// Reads a record of version 1 or 2, or a journal (run_journal.h). Strict; at most 256 MiB, which take seconds. A wrong
/// checksum is an error; a record without one is accepted. Of a journal only the damaged lines are lost.
Result<RunRecord> readRunRecord(const std::string& file, const WorkWatch& watch = {});

/// A warning about the lines that a damaged journal has lost; nothing where the record is complete.
std::optional<Diagnostic> lossWarning(const RunRecord& record, const std::string& file);

/// The record's log for this scenario, with checked parameters and edits. `planners`: those that the replay can use.
/// Errors: MalformedInput where the replay would not be the recorded run, Usage where the scenario is another one.
Result<RunLog> replayLog(const RunRecord& record, const LoadedScenario& scenario, const std::string& file,
                         const PlannerRegistry& planners = makePlannerRegistry());

}  // namespace glissade
