#include "engine/study/study_summary.h"

#include <functional>

namespace glissade {
namespace {

using Outcomes = std::vector<const RunOutcome*>;
using Getter = std::function<std::optional<double>(const RunOutcome&)>;

MeasureSummary measure(std::string name, const Outcomes& outcomes, const Getter& get) {
  std::vector<double> solved;
  std::vector<double> all;
  for (const RunOutcome* outcome : outcomes) {
    const auto value = get(*outcome);
    if (!value) continue;
    all.push_back(*value);
    if (outcome->result.status == RunStatus::Solved) solved.push_back(*value);
  }
  return {std::move(name), distributionOf(std::move(solved)), distributionOf(std::move(all))};
}

CellSummary summarise(const StudyCell& cell, const Outcomes& outcomes) {
  CellSummary summary;
  summary.planned = cell.seeds.size();
  summary.runs = outcomes.size();
  for (const RunOutcome* outcome : outcomes) ++summary.statuses[static_cast<std::size_t>(outcome->result.status)];
  summary.success = wilson95(summary.solved(), summary.runs);
  for (std::size_t i = 0; i < kResultColumnCount; ++i) {
    if (!resultColumns()[i].summarised) continue;
    summary.measures.push_back(measure(std::string(resultColumns()[i].name), outcomes,
                                       [i](const RunOutcome& outcome) { return outcome.result.numbers[i]; }));
  }
  summary.timing = {
      measure("planning_s", outcomes, [](const RunOutcome& outcome) { return outcome.timing.planningSeconds; }),
      measure("planning_cpu_s", outcomes, [](const RunOutcome& outcome) { return outcome.timing.planningCpuSeconds; }),
      measure("wall_s", outcomes, [](const RunOutcome& outcome) { return outcome.timing.wallSeconds; }),
      measure("cpu_s", outcomes, [](const RunOutcome& outcome) { return outcome.timing.cpuSeconds; }),
      measure("peak_memory_mb", outcomes, [](const RunOutcome& outcome) { return outcome.timing.peakMemoryMb; })};
  return summary;
}

}  // namespace

std::vector<CellSummary> summarise(const Study& study, const StudyResults& results) {
  std::vector<Outcomes> ofCell(study.cells.size());
  for (const auto& [run, outcome] : results) ofCell[run.cell].push_back(&outcome);
  std::vector<CellSummary> summaries;
  for (std::size_t i = 0; i < study.cells.size(); ++i) summaries.push_back(summarise(study.cells[i], ofCell[i]));
  return summaries;
}

}  // namespace glissade
