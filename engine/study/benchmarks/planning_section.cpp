#include "engine/study/benchmarks/planning_section.h"

#include <algorithm>

#include "engine/base/number_text.h"
#include "engine/study/cell_value.h"
#include "engine/study/study_axes.h"
#include "engine/study/study_plots.h"
#include "engine/study/study_report_tables.h"

namespace glissade {
namespace {

constexpr const char* kOurs = "auto";
constexpr const char* kPeerPrefix = "peer-";

/// A cell with its results.
struct Entry {
  const StudyCell* cell;
  const CellSummary* summary;
  CellValue seconds;
};

/// How the planner of a cell looks at edges.
std::string edgesOf(const StudyCell& cell) {
  if (cell.strategy.rfind(kPeerPrefix, 0) != 0) return "certified";
  return "every " + toText(100.0 * cell.parameters.at(ParameterId::OmplResolution)) + " %";
}

/// More runs solved, then less time.
bool better(const Entry& a, const Entry& b) {
  if (a.summary->success.share != b.summary->success.share) return a.summary->success.share > b.summary->success.share;
  return a.seconds.value < b.seconds.value;
}

std::string solvedOf(const Entry& entry) {
  return std::to_string(entry.summary->solved()) + " of " + std::to_string(entry.summary->runs);
}

std::vector<std::string> rowOf(const Entry& ours, const Entry& other) {
  const double ratio = other.seconds.value / ours.seconds.value;
  return {scenarioName(ours.cell->scenario),
          solvedOf(ours),
          shortNumber(ours.seconds.value),
          other.cell->label,
          edgesOf(*other.cell),
          solvedOf(other),
          shortNumber(other.seconds.value),
          shortNumber(ratio)};
}

/// Cells that have run, by scenario.
std::vector<std::vector<Entry>> entriesOf(const Study& study, const std::vector<CellSummary>& summaries) {
  std::vector<std::vector<Entry>> scenarios;
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const auto seconds = valueOf(summaries[i], {"planning_cpu_s", "median", "all"});
    if (!seconds) continue;
    const Entry entry{&study.cells[i], &summaries[i], *seconds};
    const auto found = std::find_if(scenarios.begin(), scenarios.end(), [&](const std::vector<Entry>& entries) {
      return entries.front().cell->scenario == entry.cell->scenario;
    });
    if (found == scenarios.end()) {
      scenarios.push_back({entry});
    } else {
      found->push_back(entry);
    }
  }
  return scenarios;
}

/// The best of those that look at edges in the same way, for each way.
std::vector<Entry> bestOthers(const std::vector<Entry>& entries) {
  std::vector<Entry> best;
  for (const Entry& entry : entries) {
    if (entry.cell->strategy == kOurs) continue;
    const auto rival = std::find_if(best.begin(), best.end(),
                                    [&](const Entry& other) { return edgesOf(*other.cell) == edgesOf(*entry.cell); });
    if (rival == best.end()) {
      best.push_back(entry);
    } else if (better(entry, *rival)) {
      *rival = entry;
    }
  }
  return best;
}

ReportTable besideTheBest(const Study& study, const std::vector<CellSummary>& summaries) {
  ReportTable table;
  table.caption =
      "The best of the others is the one that solved most, and of these the fastest; of those that look at edges in "
      "the "
      "same way. Seconds of the processor while planning: median over all runs, also those that ended without a path.";
  table.columns = {{"Problem"},
                   {"auto, solved", ReportColumn::Kind::Number},
                   {"auto, s", ReportColumn::Kind::Number},
                   {"Best of the others"},
                   {"It looks at edges"},
                   {"It solved", ReportColumn::Kind::Number},
                   {"It took, s", ReportColumn::Kind::Number},
                   {"Times", ReportColumn::Kind::Number}};
  for (const auto& entries : entriesOf(study, summaries)) {
    const auto ours =
        std::find_if(entries.begin(), entries.end(), [](const Entry& entry) { return entry.cell->strategy == kOurs; });
    if (ours == entries.end()) continue;
    for (const Entry& other : bestOthers(entries)) table.rows.push_back(rowOf(*ours, other));
  }
  return table;
}

}  // namespace

std::vector<ReportBlock> planningSection(const StudyFolder& folder, Warnings& warnings) {
  const Study& study = folder.plan().study;
  const auto summaries = summarise(study, folder.results(warnings));
  std::vector<ReportBlock> blocks;
  blocks.emplace_back(ReportHeading{study.heading.title});
  blocks.emplace_back(ReportText{study.heading.description + (study.quick ? " This is the quick size." : "")});
  if (!study.heading.findings.empty()) blocks.emplace_back(study_report::findingsTable(study, summaries, {}));
  ReportTable beside = besideTheBest(study, summaries);
  if (!beside.rows.empty()) blocks.emplace_back(std::move(beside));
  for (Plot& plot : plotsOf(study, summaries)) {
    plot.name = study.heading.name + "-" + plot.name;
    blocks.emplace_back(std::move(plot));
  }
  blocks.emplace_back(study_report::endingsTable(study, summaries, {}));
  blocks.emplace_back(study_report::timingTable(study, summaries, {}));
  return blocks;
}

}  // namespace glissade
