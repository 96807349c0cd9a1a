#include "app/cli/commands.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "app/cli/interrupt.h"
#include "engine/base/file.h"
#include "engine/study/benchmarks/benchmark_page.h"
#include "engine/study/study_report.h"
#include "engine/study/study_runner.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_tables.h"

namespace glissade::cli {
namespace {

/// Shows the progress of a study on standard error. A terminal has one line that is rewritten; other outputs get a new
/// line now and then.
class ProgressLine {
 public:
  ProgressLine();
  void show(const StudyProgress& progress);
  void end();

 private:
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

using Clock = std::chrono::steady_clock;

std::string duration(double seconds) {
  std::ostringstream text;
  if (seconds < 90.0) {
    text << std::lround(seconds) << " s";
  } else if (seconds < 5400.0) {
    text << std::lround(seconds / 60.0) << " min";
  } else {
    text << std::fixed << std::setprecision(1) << seconds / 3600.0 << " h";
  }
  return text.str();
}

const MeasureSummary& measureNamed(const CellSummary& summary, const std::string& name) {
  return *std::find_if(summary.measures.begin(), summary.measures.end(),
                       [&](const MeasureSummary& measure) { return measure.name == name; });
}

std::string median(const Distribution& distribution, int digits) {
  if (distribution.count == 0) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << distribution.median;
  return text.str();
}

/// The number of UTF-8 characters: the bytes that begin one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0), last_(Clock::now()) {}

void ProgressLine::show(const StudyProgress& progress) {
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000);
  const bool last = progress.done == progress.planned;
  if (shown_ && !last && Clock::now() - last_ < pause) return;
  shown_ = true;
  last_ = Clock::now();
  std::cerr << (terminal_ ? "\r\033[K" : "") << progress.done << " of " << progress.planned << " runs, "
            << progress.solved << " solved";
  if (progress.broken > 0) std::cerr << ", " << progress.broken << " ended by time, memory or a fault";
  if (!last && progress.secondsLeft >= 0.0) std::cerr << ", about " << duration(progress.secondsLeft) << " left";
  std::cerr << (terminal_ ? "" : "\n") << std::flush;
}

void ProgressLine::end() {
  if (terminal_ && shown_) std::cerr << "\n";
}

/// Prints a short table of a study's results on standard output.
void printSummary(const StudyFolder& folder, Warnings& warnings) {
  const Study& study = folder.plan().study;
  const auto summaries = summarise(study, folder.results(warnings));
  std::size_t widest = 5;
  for (const StudyCell& cell : study.cells) widest = std::max(widest, width(cell.label));
  std::cout << study.heading.title << (study.quick ? " (quick)" : "") << "\nmedians of the solved runs\n\n"
            << std::string(widest, ' ') << "     solved   virtual s     nodes     edges    random\n";
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const CellSummary& summary = summaries[i];
    const auto show = [&](const char* measure, int digits) {
      return median(measureNamed(summary, measure).solved, digits);
    };
    const std::string& label = study.cells[i].label;
    std::cout << label << std::string(widest - width(label), ' ') << std::right << std::setw(5) << summary.solved()
              << " of " << std::left << std::setw(4) << summary.runs << std::right << std::setw(8)
              << show("virtual_s", 1) << std::setw(10) << show("nodes", 0) << std::setw(10) << show("edges", 0)
              << std::setw(10) << show("random_configurations", 0) << "\n";
  }
  std::cout << "\nsee " << folder.file("report.html") << " and summary.csv"
            << "\n";
}

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
                    GLISSADE_TEXT("Write 1/4, 2/4, 3/4 and 4/4 for four shards.")};
}

/// Prints which runs the study has and how many of them the folder already holds.
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

/// Writes tables and report of the results that exist.
Outcome writeResults(const StudyFolder& folder, Warnings& warnings) {
  const Outcome written = writeTables(folder, warnings);
  return written ? writeReport(folder, folder.path(), warnings) : written;
}

int carryOut(const StudyOptions& options, const StudyPlan& plan, const Shard& shard, const Interrupt& interrupt) {
  const auto text = readFile(options.study, kMostStudyBytes);
  if (!text) return reportError(text.error(), {});
  const auto folder = StudyFolder::begin(options.out, plan, *text);
  if (!folder) return reportError(folder.error(), {});
  const Outcome noted = folder->noteStudyFile(options.study);
  if (!noted) return reportError(noted.error(), {});
  Warnings warnings;
  ProgressLine line;
  const RunnerOptions runner{std::filesystem::read_symlink("/proc/self/exe").string(), options.study, options.jobs,
                             shard};
  const Outcome ran = runStudy(
      *folder, runner, interrupt.token(), [&line](const StudyProgress& progress) { line.show(progress); }, warnings);
  line.end();
  reportWarnings(warnings);
  if (!ran && ran.error().kind != ErrorKind::Interrupted) return reportError(ran.error(), {});
  const Outcome written = writeResults(*folder, warnings);
  if (!written) return reportError(written.error(), {});
  if (!ran) return reportError(ran.error(), {});
  printSummary(*folder, warnings);
  return 0;
}

}  // namespace

int runStudyCommand(const StudyOptions& options) {
  const Interrupt interrupt;
  const auto shard = parseShard(options.shard);
  if (!shard) return reportError(shard.error(), {});
  Warnings warnings;
  const auto plan = planStudy(options.study, options.quick, warnings);
  reportWarnings(warnings);
  if (!plan) return reportError(plan.error(), {});
  return options.dryRun ? describe(options, *plan, *shard) : carryOut(options, *plan, *shard, interrupt);
}

int runMerge(const MergeOptions& options) {
  Warnings warnings;
  const auto merged = mergeStudies(options.folders, options.out, warnings);
  reportWarnings(warnings);
  if (!merged) return reportError(merged.error(), {});
  const Outcome written = writeReport(*merged, merged->path(), warnings);
  if (!written) return reportError(written.error(), {});
  printSummary(*merged, warnings);
  return 0;
}

int runReport(const ReportOptions& options) {
  Warnings warnings;
  const auto folder = StudyFolder::open(options.folder);
  if (!folder) return reportError(folder.error(), {});
  const std::string& out = options.out.empty() ? options.folder : options.out;
  const Outcome written = writeReport(*folder, out, warnings, *languageOf(options.language));
  reportWarnings(warnings);
  if (!written) return reportError(written.error(), {});
  std::cout << out << "/report.html\n";
  return 0;
}

int runBenchmarkPage(const std::string& folder) {
  Warnings warnings;
  const Outcome written = writeBenchmarkPage(folder, warnings);
  reportWarnings(warnings);
  if (!written) return reportError(written.error(), {});
  std::cout << folder << "/benchmarks.html\n";
  return 0;
}

}  // namespace glissade::cli
