#include "engine/files/run_record.h"
#include "engine/files/same_problem.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_io.h"
#include "engine/planning/planner.h"

namespace glissade {
namespace {

constexpr CatalogueText kOtherScenario =
    GLISSADE_TEXT("Name the scenario that the run was recorded on, as it was then.");

Outcome checkScenario(const RunRecord& record, const LoadedScenario& scenario, const std::string& file) {
  if (record.version == 1) return Done{};
  if (!isRecordOf(record, scenario)) {
    return Diagnostic{ErrorKind::Usage,
                      file,
                      "/problem_sha256",
                      {GLISSADE_TEXT("the run was recorded on another scenario than '%1'"), {scenario.file}},
                      kOtherScenario};
  }
  for (const RunRecord::AssetHash& recorded : record.assets) {
    for (const Asset& asset : scenario.scenario.assets) {
      if (asset.id != recorded.id) continue;
      const auto now = assetSha256(asset, scenario.file);
      if (!now) return now.error();
      if (*now != recorded.sha256) {
        return Diagnostic{ErrorKind::Usage,
                          file,
                          "/assets",
                          {GLISSADE_TEXT("the asset '%1' has changed since the run was recorded"), {asset.id}},
                          kOtherScenario};
      }
    }
  }
  return Done{};
}

Outcome checkParameters(const RunRecord& record, ParameterValues& initial) {
  for (const auto& [id, value] : record.parameters) {
    const Outcome set = initial.set(id, value);
    if (!set) return set;
  }
  ParameterValues trial = initial;
  for (const RunLog::ParameterChange& change : record.log.parameterChanges) {
    const Outcome set = trial.set(change.id, change.value);
    if (!set) return set;
  }
  return Done{};
}

Outcome checkSemantics(const RunLog& log, const LoadedScenario& scenario) {
  const std::vector<std::string> ids = nodeIdsOf(scenario.scenario);
  const auto check = [&](const std::shared_ptr<const SemanticEdits>& edits) {
    return edits ? checkEdits(*edits, ids) : Outcome(Done{});
  };
  const Outcome start = check(log.start.edits);
  if (!start) return start;
  if (log.start.knowledge) {
    const Outcome knowledge = check(log.start.knowledge->edits);
    if (!knowledge) return knowledge;
  }
  for (const RunLog::SemanticChange& change : log.semanticChanges) {
    const Outcome changed = check(change.edits);
    if (!changed) return changed;
  }
  return Done{};
}

}  // namespace

Result<RunLog> replayLog(const RunRecord& record, const LoadedScenario& scenario, const std::string& file,
                         const PlannerRegistry& planners) {
  RunLog log = record.log;
  log.start.parameters = ParameterValues(scenario.problem.world->objectRadius());
  // Version 1 had no edits; the edits of the scenario applied.
  if (record.version == 1) log.start.edits = scenario.problem.scene.edits;
  const auto refuse = [&](Diagnostic why) {
    why.file = file;
    return why;
  };
  const Outcome same = checkScenario(record, scenario, file);
  if (!same) return same.error();
  if (planners.find(log.start.planner) == nullptr) {
    Diagnostic why = unknownPlanner(
        log.start.planner, {GLISSADE_TEXT("Replay it with the Glissade that recorded it: %1."), {record.program}});
    why.kind = ErrorKind::MalformedInput;
    why.location = "/planner";
    return refuse(why);
  }
  // Records of earlier versions do not have this parameter; the automatic planner had one slot.
  if (record.parameters.count(ParameterId::Slots) == 0) (void)log.start.parameters.set(ParameterId::Slots, 1.0);
  const Outcome parameters = checkParameters(record, log.start.parameters);
  if (!parameters) return refuse(parameters.error());
  const Outcome semantics = checkSemantics(log, scenario);
  if (!semantics) return refuse(semantics.error());
  return log;
}

}  // namespace glissade
