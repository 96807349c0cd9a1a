#include "app/cli/commands.h"

#include <glissade/version.h>

#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/files/run_record.h"
#include "engine/files/scenario_io.h"
#include "engine/session/replay_session.h"
#include "engine/session/run_comparison.h"
#include "engine/session/session_with_planners.h"
#include "engine/study/benchmarks/peer_planners.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Session steps between two checks for an interruption.
constexpr std::uint64_t kReplaySlice = 1000;

struct Replayed {
  RunRecord record;
  RunLog recorded;
  SnapshotPtr end;
};

Result<Replayed> replay(const ReplayOptions& options, const Interrupt& interrupt) {
  auto record = readRunRecord(options.record);
  if (!record) return record.error();
  const auto scenario = loadScenario(options.scenario.empty() ? record->scenario : options.scenario);
  if (!scenario) return scenario.error();
  const PlannerRegistry planners = makePlannerRegistryWithPeers();
  auto log = replayLog(*record, *scenario, options.record, planners);
  if (!log) return log.error();
  const auto problem = withRecordedKnowledge(scenario->problem, *log, interrupt.token());
  if (!problem) return problem.error();
  const auto session =
      makeReplaySession(*problem, std::make_shared<const RunLog>(*log), ReplayEnd::WithTheLog, planners);
  session->post(command::Start{});
  session->advance(0);
  while (isRunning(*session->snapshot()) && !interrupt.requested()) session->advance(kReplaySlice, interrupt.token());
  if (interrupt.requested()) {
    return Diagnostic{ErrorKind::Interrupted, options.record, "", GLISSADE_TEXT("the replay was not finished"),
                      GLISSADE_TEXT("Start it again.")};
  }
  return Replayed{std::move(*record), std::move(*log), session->snapshot()};
}

Json toJson(const RunCheckpoint& checkpoint) {
  return {{"step", checkpoint.step}, {"nodes", checkpoint.nodes}, {"edges", checkpoint.edges}};
}

Json toJson(const Replayed& replayed, const std::optional<RunDifference>& difference) {
  Json report;
  report["same"] = !difference;
  report["record_version"] = replayed.record.version;
  report["recorded_by"] = replayed.record.program;
  report["recorded_build"] = replayed.record.build;
  report["version"] = kVersion;
  report["build"] = kBuild;
  report["checkpoints"] = replayed.recorded.checkpoints.size() + (replayed.recorded.end ? 1 : 0);
  report["nodes"] = replayed.end->counts.nodes;
  report["solved"] = replayed.end->state == SessionState::Solved;
  report["cut_short"] = replayed.recorded.cutShort;
  if (const auto& loss = replayed.record.loss) {
    report["lost"] = {{"lines", loss->lines}, {"after_step", loss->afterStep}};
  }
  if (difference) {
    report["difference"] = {{"same_until", difference->same},
                            {"recorded", toJson(difference->recorded)},
                            {"replayed", toJson(difference->replayed)}};
  }
  return report;
}

void printText(const Replayed& replayed, const std::optional<RunDifference>& difference, const Console& console) {
  if (!difference) {
    const RunCheckpoint end = replayed.recorded.end.value_or(RunCheckpoint{});
    console.print({GLISSADE_TEXT("same roadmap as recorded: %1 {1|node|nodes}"), {end.nodes}});
    if (replayed.record.version == 1) {
      console.print(GLISSADE_TEXT("(a record of version 1: only the nodes were counted)"));
    }
    if (replayed.recorded.cutShort) console.print(GLISSADE_TEXT("(the recording was full there; the run went on)"));
    return;
  }
  console.print({GLISSADE_TEXT("different: the same until step %1, not at step %2 (recorded %3 nodes, replayed %4 at "
                               "step %5)"),
                 {difference->same, difference->recorded.step, difference->recorded.nodes, difference->replayed.nodes,
                  difference->replayed.step}});
  if (!replayed.record.build.empty() && replayed.record.build != kBuild) {
    console.print({GLISSADE_TEXT("recorded by %1, %2; replayed by Glissade %3, %4"),
                   {replayed.record.program, replayed.record.build, kVersion, kBuild}});
  }
}

}  // namespace

int runReplay(const ReplayOptions& options) {
  const Interrupt interrupt;
  const auto replayed = replay(options, interrupt);
  if (!replayed) return reportError(replayed.error(), options.console);
  if (const auto loss = lossWarning(replayed->record, options.record)) reportWarnings({*loss}, options.console);
  // A run that failed before its first step has an empty log.
  const RunLog again = replayed->end->log.empty() ? RunLog() : joined(replayed->end->log);
  const auto difference = firstDifference(replayed->recorded, again);
  if (options.console.json) {
    printJson(toJson(*replayed, difference));
  } else {
    printText(*replayed, difference, options.console);
  }
  return difference ? 1 : 0;
}

}  // namespace glissade::cli
