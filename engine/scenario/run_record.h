#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/file_save.h"
#include "engine/base/work_watch.h"
#include "engine/operator/run_log.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// One run as a file: enough to grow the same roadmap again, bit by bit, also where a person steered.
struct RunRecord {
  struct AssetHash {
    std::string id;
    std::string sha256;
  };

  /// What a damaged journal does not tell any more.
  struct Loss {
    std::size_t lines = 0;        ///< how many of its lines are damaged or cut off
    std::uint64_t afterStep = 0;  ///< up to here nothing is missing
  };

  int version = 2;            ///< of the file; 1 knows no semantic edits and no checkpoints
  std::string program;        ///< "Glissade 0.1.0"
  std::string build;          ///< compiler, processor, flags
  std::string scenario;       ///< its file; in the record relative to the record's folder
  std::string problemSha256;  ///< problemSha256(scenario); empty in version 1
  std::vector<AssetHash> assets;
  std::map<ParameterId, double> parameters;  ///< at the start
  RunLog log;                                ///< its start.parameters are set by replayLog()
  std::optional<Loss> loss;                  ///< nothing: the record is whole
};

/// The record of a run of this scenario. Errors: an asset can no longer be read.
Result<RunRecord> makeRunRecord(const LoadedScenario& scenario, RunLog log);

/// Another run of the same scenario.
void setLog(RunLog log, RunRecord& record);

/// SHA-256 of what a scenario says about the problem: bodies, object, start, goal, workspace, environment and rules.
/// What a record holds itself (edits, planner, parameters, seed) is left out, and so are kept paths.
std::string problemSha256(const Scenario& scenario);

/// Version 2 with a checksum, saved atomically.
SaveResult writeRunRecord(const RunRecord& record, const std::string& file);
/// Version 1 or 2, or a journal (run_journal.h). Strict; at most 256 MiB, which take seconds. A checksum that
/// does not fit is an error; a record without one is read as it is. Of a journal only the damaged lines are lost.
Result<RunRecord> readRunRecord(const std::string& file, const WorkWatch& watch = {});

/// What a damaged journal costs; nothing where the record is whole.
std::optional<Diagnostic> lossWarning(const RunRecord& record, const std::string& file);

/// The record's log for this scenario, its parameters and edits checked. Refused (MalformedInput, or
/// Usage where the scenario is another): what would not be the recorded run.
Result<RunLog> replayLog(const RunRecord& record, const LoadedScenario& scenario, const std::string& file);

}  // namespace glissade
