#include "app/cli/study_command.h"

#include <charconv>
#include <filesystem>
#include <iostream>

#include "app/cli/interrupt.h"
#include "app/cli/study_report.h"
#include "engine/base/file.h"
#include "engine/study/benchmarks/benchmark_page.h"
#include "engine/study/study_report.h"
#include "engine/study/study_runner.h"
#include "engine/study/study_tables.h"

namespace glissade::cli {
namespace {

constexpr std::size_t kMostStudyBytes = 16U << 20;
constexpr std::size_t kMostShards = 1'000'000;

bool readWhole(std::string_view text, std::size_t& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

Result<Shard> parseShard(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard;
  const bool read = slash != std::string::npos && readWhole(std::string_view(text).substr(0, slash), shard.index) &&
                    readWhole(std::string_view(text).substr(slash + 1), shard.count);
  if (read && shard.index >= 1 && shard.index <= shard.count && shard.count <= kMostShards) return shard;
  return Diagnostic{ErrorKind::Usage, "", "--shard", "'" + text + "' is not I/N with I from 1 to N",
                    "Write 1/4, 2/4, 3/4 and 4/4 for four shards."};
}

/// Says what would be run, and what of it the folder already holds.
int describe(const StudyOptions& options, const StudyPlan& plan, const Shard& shard) {
  std::size_t done = 0;
  Warnings warnings;
  const auto folder = StudyFolder::open(options.out);
  const bool begun = folder.ok() && folder->planText() == writePlan(plan);
  const StudyResults known = begun ? folder->results(warnings) : StudyResults();
  const auto runs = runsOf(plan.study, shard);
  for (const StudyRun& run : runs) done += known.count(run);
  std::cout << plan.study.heading.title << "\n"
            << plan.study.cells.size() << " cells, " << runs.size() << " runs in shard " << shard.index << " of "
            << shard.count << ", " << done << " of them done\n\n";
  for (const StudyCell& cell : plan.study.cells) {
    std::cout << cell.label << "\n  " << cell.seeds.size() << " seeds of: glissade-cli";
    for (const std::string& word : planArguments(cell, cell.seeds.front(), scenarioFileOf(options.study, cell))) {
      std::cout << " " << word;
    }
    std::cout << "\n";
  }
  return 0;
}

/// Tables and report of what is there.
Outcome writeResults(const StudyFolder& folder, Warnings& warnings) {
  const Outcome written = writeTables(folder, warnings);
  return written ? writeReport(folder, folder.path(), warnings) : written;
}

int carryOut(const StudyOptions& options, const StudyPlan& plan, const Shard& shard, const Interrupt& interrupt) {
  const auto text = readFile(options.study, kMostStudyBytes);
  if (!text) return reportError(text.error(), Format::Text);
  const auto folder = StudyFolder::begin(options.out, plan, *text);
  if (!folder) return reportError(folder.error(), Format::Text);
  const Outcome noted = folder->noteStudyFile(options.study);
  if (!noted) return reportError(noted.error(), Format::Text);
  Warnings warnings;
  ProgressLine line;
  const RunnerOptions runner{std::filesystem::read_symlink("/proc/self/exe").string(), options.study, options.jobs,
                             shard};
  const Outcome ran = runStudy(
      *folder, runner, interrupt.token(), [&line](const StudyProgress& progress) { line.show(progress); }, warnings);
  line.end();
  reportWarnings(warnings);
  if (!ran && ran.error().kind != ErrorKind::Interrupted) return reportError(ran.error(), Format::Text);
  const Outcome written = writeResults(*folder, warnings);
  if (!written) return reportError(written.error(), Format::Text);
  if (!ran) return reportError(ran.error(), Format::Text);
  printSummary(*folder, warnings);
  return 0;
}

}  // namespace

int runStudyCommand(const StudyOptions& options) {
  const Interrupt interrupt;
  const auto shard = parseShard(options.shard);
  if (!shard) return reportError(shard.error(), Format::Text);
  Warnings warnings;
  const auto plan = planStudy(options.study, options.quick, warnings);
  reportWarnings(warnings);
  if (!plan) return reportError(plan.error(), Format::Text);
  return options.dryRun ? describe(options, *plan, *shard) : carryOut(options, *plan, *shard, interrupt);
}

int runMerge(const MergeOptions& options) {
  Warnings warnings;
  const auto merged = mergeStudies(options.folders, options.out, warnings);
  reportWarnings(warnings);
  if (!merged) return reportError(merged.error(), Format::Text);
  const Outcome written = writeReport(*merged, merged->path(), warnings);
  if (!written) return reportError(written.error(), Format::Text);
  printSummary(*merged, warnings);
  return 0;
}

int runReport(const ReportOptions& options) {
  Warnings warnings;
  const auto folder = StudyFolder::open(options.folder);
  if (!folder) return reportError(folder.error(), Format::Text);
  const std::string& out = options.out.empty() ? options.folder : options.out;
  const Outcome written = writeReport(*folder, out, warnings, *languageOf(options.language));
  reportWarnings(warnings);
  if (!written) return reportError(written.error(), Format::Text);
  std::cout << out << "/report.html\n";
  return 0;
}

int runBenchmarkPage(const std::string& folder) {
  Warnings warnings;
  const Outcome written = writeBenchmarkPage(folder, warnings);
  reportWarnings(warnings);
  if (!written) return reportError(written.error(), Format::Text);
  std::cout << folder << "/benchmarks.html\n";
  return 0;
}

}  // namespace glissade::cli
