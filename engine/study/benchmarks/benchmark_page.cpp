#include "engine/study/benchmarks/benchmark_page.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <vector>

#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/base/number_text.h"
#include "engine/planning/planner.h"
#include "engine/study/benchmarks/benchmark_results.h"
#include "engine/study/cell_value.h"
#include "engine/study/report_html.h"
#include "engine/study/study_axes.h"
#include "engine/study/study_plots.h"
#include "engine/study/study_report_tables.h"

namespace glissade {
namespace {

constexpr const char* kOurs = "auto";

/// A cell with its results.
struct Entry {
  const StudyCell* cell;
  const CellSummary* summary;
  CellValue seconds;
};

/// How the planner of a cell looks at edges.
std::string edgesOf(const StudyCell& cell) {
  if (!cell.strategy.starts_with(kPeerPrefix)) return "certified";
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

/// The section of one study on the page of results: findings, `auto` beside the best of the others on every scenario,
/// plots, endings of runs and seconds. The study's own report has the rest.
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

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 16U << 20;
constexpr double kMicro = 1e6;

/// A query of the kernel, and the required ratio to FCL's time (geometric mean).
struct Aim {
  const char* question;
  const char* text;
  double ratio;
};
constexpr Aim kAims[] = {
    {"collide", "Collide: 30 times faster than FCL.", 30.0},
    {"distance", "Distance with nearest points: 15 times faster than FCL.", 15.0},
    {"edge", "A certified edge: 10 times faster than 20 discrete checks by FCL.", 10.0},
};

/// A quantity that grows with the size, and its name in the plot.
struct Growing {
  const char* quantity;
  const char* title;
  const char* size;
};
constexpr Growing kGrowing[] = {
    {"nearest", "Nearest neighbour", "Configurations"},
    {"iteration", "Iteration of a planner", "Nodes of its trees"},
    {"collide", "Collide", "Triangles"},
    {"distance", "Distance", "Triangles"},
    {"edge", "Edge: certified by the kernel, 20 discrete checks by FCL", "Triangles"},
};

std::string microseconds(double seconds) { return shortNumber(kMicro * seconds); }

ReportTable ratioTable(const std::vector<BackendTimes>& times) {
  ReportTable table;
  table.caption = "The same meshes and poses, one core; surfaces alone in both.";
  table.columns = {{"Question"},
                   {"Model and poses"},
                   {"FCL (µs)", ReportColumn::Kind::Number},
                   {"Kernel (µs)", ReportColumn::Kind::Number},
                   {"Times faster", ReportColumn::Kind::Number}};
  for (const BackendTimes& pair : times) {
    table.rows.push_back(
        {pair.question, pair.place, microseconds(pair.fcl), microseconds(pair.kernel), shortNumber(pair.ratio())});
  }
  return table;
}

ReportTable aimsTable(const std::vector<BackendTimes>& times) {
  ReportTable table;
  table.columns = {
      {"Finding"}, {"Verdict", ReportColumn::Kind::Verdict}, {"Geometric mean", ReportColumn::Kind::Number}};
  for (const Aim& aim : kAims) {
    const bool asked = std::any_of(times.begin(), times.end(),
                                   [&](const BackendTimes& pair) { return pair.question == aim.question; });
    const double mean = asked ? geometricMean(times, aim.question) : 0.0;
    table.rows.push_back({aim.text,
                          !asked              ? "open"
                          : mean >= aim.ratio ? "holds"
                                              : "does not hold",
                          asked ? shortNumber(mean) : "–"});
  }
  return table;
}

PlotSeries seriesOf(const GrowthSeries& growth, std::size_t style) {
  PlotSeries series;
  series.name = growth.who + (growth.exponent ? ": n^" + shortNumber(*growth.exponent) : "");
  series.style = style % kPlotStyleCount;
  for (const auto& [size, seconds] : growth.points) {
    const double time = kMicro * seconds;
    series.points.push_back(
        {size, time, time, time, "", growth.who + ", " + shortNumber(size) + ": " + shortNumber(time) + " µs", {}});
  }
  return series;
}

std::optional<Plot> growthPlot(const Growing& growing, const std::vector<GrowthSeries>& all) {
  Plot plot;
  plot.name = std::string("growth-") + growing.quantity;
  plot.title = growing.title;
  plot.caption = "Both axes are logarithmic; n^k in the legend is fitted to all points of a line (least squares).";
  std::vector<double> sizes;
  std::vector<double> times;
  for (const GrowthSeries& growth : all) {
    if (growth.quantity != growing.quantity) continue;
    plot.series.push_back(seriesOf(growth, plot.series.size()));
    for (const PlotPoint& point : plot.series.back().points) {
      sizes.push_back(point.x);
      times.push_back(point.y);
    }
  }
  if (plot.series.empty()) return std::nullopt;
  plot.x = PlotScale::logarithmic(growing.size, sizes);
  plot.y = PlotScale::logarithmic("Time (µs)", times);
  return plot;
}

ReportTable growthTable(const std::vector<GrowthSeries>& all) {
  ReportTable table;
  table.columns = {{"Quantity"},
                   {"Who"},
                   {"Exponent", ReportColumn::Kind::Number},
                   {"Sizes", ReportColumn::Kind::Number},
                   {"Times (µs)", ReportColumn::Kind::Number}};
  for (const Growing& growing : kGrowing) {
    for (const GrowthSeries& growth : all) {
      if (growth.quantity != growing.quantity) continue;
      const auto& [smallest, shortest] = growth.points.front();
      const auto& [largest, longest] = growth.points.back();
      table.rows.push_back({growing.title, growth.who, growth.exponent ? shortNumber(*growth.exponent) : "–",
                            shortNumber(smallest) + " – " + shortNumber(largest),
                            microseconds(shortest) + " – " + microseconds(longest)});
    }
  }
  return table;
}

ReportTable timesTable(const std::vector<BenchmarkTime>& times) {
  ReportTable table;
  table.columns = {{"Benchmark"}, {"Time (ms)", ReportColumn::Kind::Number}, {"Counters"}};
  for (const BenchmarkTime& time : times) {
    std::string counters;
    for (const auto& [name, value] : time.counters)
      counters += (counters.empty() ? "" : ", ") + name + " " + shortNumber(value);
    table.rows.push_back({time.name, shortNumber(1e3 * time.seconds), counters});
  }
  return table;
}

/// Writes the page, section by section.
class Writer {
 public:
  Writer(std::string folder, Warnings& warnings) : folder_(std::move(folder)), warnings_(warnings) {}

  Result<StudyReport> write() {
    for (const char* name : {"collision", "nearest_neighbours", "growth", "octree"}) {
      const Outcome taken = take(name);
      if (!taken) return taken.error();
    }
    const std::vector<StudyFolder> studies = studyFolders();
    if (runs_.empty() && studies.empty()) {
      return Diagnostic{ErrorKind::MalformedInput, folder_, "", GLISSADE_TEXT("holds no results of benchmarks"),
                        GLISSADE_TEXT("Run packaging/benchmarks.sh, and give the folder that it filled.")};
    }
    addOrigin();
    addCollision();
    addGrowth("nearest_neighbours", "Nearest neighbours: our tree and the plain scan");
    addGrowth("growth", "Growth");
    addOctree();
    for (const StudyFolder& study : studies) {
      for (ReportBlock& block : planningSection(study, warnings_)) add(std::move(block));
    }
    addCommands();
    return std::move(report_);
  }

 private:
  void add(ReportBlock block) { report_.blocks.push_back(std::move(block)); }

  /// Reads a file of the folder. A missing file makes its section missing.
  Outcome take(const std::string& name) {
    const std::string file = folder_ + "/" + name + ".json";
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return Done{};
    const auto text = readFile(file, kMostBytes);
    if (!text) return text.error();
    auto run = readBenchmarks(*text, file);
    if (!run) return run.error();
    runs_[name] = std::move(*run);
    return Done{};
  }

  std::vector<StudyFolder> studyFolders() {
    std::error_code ignored;
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
      if (fs::exists(entry.path() / "plan.json", ignored)) names.insert(entry.path().string());
    }
    std::vector<StudyFolder> studies;
    for (const std::string& name : names) {
      auto study = StudyFolder::open(name);
      if (study) {
        studies.push_back(std::move(*study));
      } else {
        warnings_.push_back(study.error());
      }
    }
    return studies;
  }

  const BenchmarkRun* run(const std::string& name) const {
    const auto found = runs_.find(name);
    return found == runs_.end() || found->second.times.empty() ? nullptr : &found->second;
  }

  void addOrigin() {
    ReportTable table;
    table.columns = {{""}, {""}};
    const std::pair<const char*, const char*> shown[] = {
        {"date", "Date"},         {"machine", "Machine"}, {"libraries", "Libraries"},
        {"glissade", "Glissade"}, {"commit", "Commit"},   {"library_build_type", "Google Benchmark, built for"}};
    for (const auto& [key, title] : shown) {
      std::set<std::string> values;
      for (const auto& [name, run] : runs_) {
        const auto found = run.context.find(key);
        if (found != run.context.end()) values.insert(found->second);
      }
      std::string text;
      for (const std::string& value : values) text += (text.empty() ? "" : "; ") + value;
      if (!text.empty()) table.rows.push_back({title, text});
    }
    add(ReportHeading{"Where the numbers are from"});
    add(std::move(table));
  }

  /// Begins a section with its heading. Returns false, after a note, where the section has no data.
  bool begin(const std::string& heading, const std::string& name) {
    add(ReportHeading{heading});
    if (run(name) != nullptr) return true;
    add(ReportText{"Not measured this time (" + name + "_benchmark)."});
    return false;
  }

  void addCollision() {
    if (!begin("Collision: our kernel and FCL", "collision")) return;
    const auto times = backendTimes(run("collision")->times);
    add(aimsTable(times));
    add(ratioTable(times));
  }

  void addGrowth(const std::string& name, const std::string& heading) {
    if (!begin(heading, name)) return;
    const auto all = growthSeries(run(name)->times);
    for (const Growing& growing : kGrowing) {
      if (auto plot = growthPlot(growing, all)) add(std::move(*plot));
    }
    add(growthTable(all));
  }

  void addOctree() {
    if (!begin("Octree: one part moved, and built afresh", "octree")) return;
    add(timesTable(run("octree")->times));
  }

  void addCommands() {
    const auto text = readFile(folder_ + "/commands.txt", kMostBytes);
    if (!text) return;
    ReportCommands commands;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) commands.lines.push_back(line);
    add(ReportHeading{"What was run"});
    add(std::move(commands));
  }

  std::string folder_;
  Warnings& warnings_;
  std::map<std::string, BenchmarkRun> runs_;
  StudyReport report_{"Glissade, measured beside its peers", {}};
};

}  // namespace

Result<StudyReport> benchmarkPage(const std::string& folder, Warnings& warnings) {
  return Writer(folder, warnings).write();
}

Outcome writeBenchmarkPage(const std::string& folder, Warnings& warnings) {
  const auto page = benchmarkPage(folder, warnings);
  if (!page) return page.error();
  const auto html = reportHtml(*page);
  if (!html) return html.error();
  return saveFile(folder + "/benchmarks.html", *html, warnings);
}

}  // namespace glissade
