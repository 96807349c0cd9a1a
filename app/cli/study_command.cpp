#include "app/cli/commands.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/cli/interrupt.h"
#include "app/cli/text_cells.h"
#include "engine/base/file.h"
#include "engine/study/study_page.h"
#include "engine/study/study_runner.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_tables.h"

namespace glissade::cli {
namespace {

/// Shows the progress of a study on standard error. A terminal has one line that is rewritten; other outputs get a new
/// line now and then.
class ProgressLine {
 public:
  explicit ProgressLine(const Console& console);
  void show(const StudyProgress& progress);
  void end();

 private:
  Console console_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

using Clock = std::chrono::steady_clock;

std::string duration(double seconds) {
  if (seconds < 90.0) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 5400.0) return std::to_string(std::lround(seconds / 60.0)) + " min";
  return fixedDigits(seconds / 3600.0, 1) + " h";
}

const MeasureSummary& measureNamed(const CellSummary& summary, const std::string& name) {
  return *std::find_if(summary.measures.begin(), summary.measures.end(),
                       [&](const MeasureSummary& measure) { return measure.name == name; });
}

std::string median(const Distribution& distribution, int digits) {
  return distribution.count == 0 ? "-" : fixedDigits(distribution.median, digits);
}

Message inWords(const StudyProgress& progress) {
  Message text{GLISSADE_TEXT("%1 of %2 {2|run|runs}, %3 solved"), {progress.done, progress.planned, progress.solved}};
  if (progress.broken > 0) {
    text = {GLISSADE_TEXT("%1, %2 ended by time, memory or a fault"), {text, progress.broken}};
  }
  if (progress.done < progress.planned && progress.secondsLeft >= 0.0) {
    text = {GLISSADE_TEXT("%1, about %2 left"), {text, duration(progress.secondsLeft)}};
  }
  return text;
}

ProgressLine::ProgressLine(const Console& console)
    : console_(console), terminal_(isatty(STDERR_FILENO) != 0), last_(Clock::now()) {}

void ProgressLine::show(const StudyProgress& progress) {
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000);
  const bool last = progress.done == progress.planned;
  if (shown_ && !last && Clock::now() - last_ < pause) return;
  shown_ = true;
  last_ = Clock::now();
  std::cerr << (terminal_ ? "\r\033[K" : "") << console_.text(inWords(progress)) << (terminal_ ? "" : "\n")
            << std::flush;
}

void ProgressLine::end() {
  if (terminal_ && shown_) std::cerr << "\n";
}

/// Prints a short table of a study's results on standard output.
void printSummary(const StudyFolder& folder, bool withReport, Warnings& warnings, const Console& console) {
  const Study& study = folder.plan().study;
  const auto summaries = summarise(study, folder.results(warnings));
  std::size_t widest = 5;
  for (const StudyCell& cell : study.cells) widest = std::max(widest, widthOf(cell.label));
  const Message title(study.heading.title);
  console.print(study.quick ? Message{GLISSADE_TEXT("%1 (quick)"), {title}} : title);
  console.print(GLISSADE_TEXT("medians of the solved runs"));
  console.print({});
  std::cout << std::string(widest, ' ');
  console.print(GLISSADE_TEXT("     solved   virtual s     nodes     edges    random"));
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const CellSummary& summary = summaries[i];
    const auto shown = [&](const char* measure, int digits, std::size_t width) {
      return toRight(median(measureNamed(summary, measure).solved, digits), width);
    };
    const std::string numbers = shown("virtual_s", 1, 8) + shown("nodes", 0, 10) + shown("edges", 0, 10) +
                                shown("random_configurations", 0, 10);
    console.print({GLISSADE_TEXT("%1 of %2"),
                   {toLeft(study.cells[i].label, widest) + toRight(std::to_string(summary.solved()), 5),
                    toLeft(std::to_string(summary.runs), 4) + numbers}});
  }
  console.print({});
  console.print(withReport ? Message{GLISSADE_TEXT("see %1 and summary.csv"), {folder.file("report.html")}}
                           : Message{GLISSADE_TEXT("see %1; 'glissade-cli report %2' writes the page of the study"),
                                     {folder.file("summary.csv"), folder.path()}});
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
  return Diagnostic{ErrorKind::Usage,
                    "",
                    "--shard",
                    {GLISSADE_TEXT("'%1' is not I/N with I from 1 to N"), {text}},
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
  const Console& console = options.console;
  console.print(Message(plan.study.heading.title));
  console.print({GLISSADE_TEXT("%1 {1|cell|cells}, %2 {2|run|runs} in shard %3 of %4, %5 of them done"),
                 {plan.study.cells.size(), runs.size(), shard.index, shard.count, done}});
  console.print({});
  for (const StudyCell& cell : plan.study.cells) {
    std::string command = "glissade-cli";
    for (const std::string& word : planArguments(cell, cell.seeds.front(), scenarioFileOf(options.study, cell))) {
      command += " " + word;
    }
    std::cout << cell.label << "\n";
    console.print({GLISSADE_TEXT("  %1 {1|seed|seeds} of: %2"), {cell.seeds.size(), command}});
  }
  return 0;
}

/// Writes the tables of the results that exist and, where it is wanted, the page.
Outcome writeResults(const StudyFolder& folder, bool withReport, const Console& console, const StopToken& stop) {
  Warnings warnings;
  const auto tell = [&](const Outcome& outcome) {
    reportWarnings(warnings, console);
    return outcome;
  };
  if (!withReport) return tell(writeTables(folder, folder.path(), warnings));
  const auto page = writeStudyPage(folder, {"", "", console.language}, warnings, stop);
  return tell(page ? Outcome(Done{}) : Outcome(page.error()));
}

int carryOut(const StudyOptions& options, const StudyPlan& plan, const Shard& shard, const Interrupt& interrupt) {
  const auto text = readFile(options.study, kMostStudyBytes);
  if (!text) return reportError(text.error(), options.console);
  const auto folder = StudyFolder::begin(options.out, plan, *text);
  if (!folder) return reportError(folder.error(), options.console);
  const Outcome noted = folder->noteStudyFile(options.study);
  if (!noted) return reportError(noted.error(), options.console);
  Warnings warnings;
  ProgressLine line(options.console);
  const RunnerOptions runner{std::filesystem::read_symlink("/proc/self/exe").string(), options.study, options.jobs,
                             shard};
  const Outcome ran = runStudy(
      *folder, runner, interrupt.token(), [&line](const StudyProgress& progress) { line.show(progress); }, warnings);
  line.end();
  reportWarnings(warnings, options.console);
  if (!ran && ran.error().kind != ErrorKind::Interrupted) return reportError(ran.error(), options.console);
  const Outcome written = writeResults(*folder, options.report && ran, options.console, interrupt.token());
  if (!written) return reportError(written.error(), options.console);
  if (!ran) return reportError(ran.error(), options.console);
  printSummary(*folder, options.report, warnings, options.console);
  return 0;
}

}  // namespace

int runStudyCommand(const StudyOptions& options) {
  const Interrupt interrupt;
  const auto shard = parseShard(options.shard);
  if (!shard) return reportError(shard.error(), options.console);
  Warnings warnings;
  const auto plan = planStudy(options.study, options.quick, warnings);
  reportWarnings(warnings, options.console);
  if (!plan) return reportError(plan.error(), options.console);
  return options.dryRun ? describe(options, *plan, *shard) : carryOut(options, *plan, *shard, interrupt);
}

int runMerge(const MergeOptions& options) {
  const Interrupt interrupt;
  Warnings warnings;
  const auto merged = mergeStudies(options.folders, options.out, warnings);
  reportWarnings(warnings, options.console);
  if (!merged) return reportError(merged.error(), options.console);
  const Outcome written = writeResults(*merged, options.report, options.console, interrupt.token());
  if (!written) return reportError(written.error(), options.console);
  printSummary(*merged, options.report, warnings, options.console);
  return 0;
}

namespace {

/// Prints the file of a page, or why there is none.
int tellPage(const Result<std::string>& page, const Warnings& warnings, const Console& console) {
  reportWarnings(warnings, console);
  if (!page) return reportError(page.error(), console);
  std::cout << *page << "\n";
  return 0;
}

}  // namespace

int runReport(const ReportOptions& options) {
  const Interrupt interrupt;
  Warnings warnings;
  const auto folder = StudyFolder::open(options.folder);
  if (!folder) return reportError(folder.error(), options.console);
  const PageOptions page{options.out, "", *languageOf(options.language)};
  return tellPage(writeStudyPage(*folder, page, warnings, interrupt.token()), warnings, options.console);
}

int runBenchmarkPage(const BenchmarkPageOptions& options) {
  const Interrupt interrupt;
  Warnings warnings;
  return tellPage(writeBenchmarkPage(options.folder, {}, warnings, interrupt.token()), warnings, options.console);
}

}  // namespace glissade::cli
