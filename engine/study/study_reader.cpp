#include "engine/study/study_reader.h"

#include <algorithm>
#include <set>

#include "engine/operator/device_registry.h"
#include "engine/sequence/sequence_strategy.h"
#include "engine/study/benchmarks/peer_planners.h"
#include "engine/study/finding_reader.h"
#include "engine/study/study_axes.h"
#include "engine/study/study_plan.h"

namespace glissade {
namespace {

constexpr std::uint64_t kMostRuns = 10'000'000;
constexpr double kMostCells = 100'000;
/// Most rows, findings, and scenarios of a row, because names are searched sequentially.
constexpr std::size_t kMostRows = 1000;
constexpr std::uint64_t kMostMegabytes = 1ULL << 40U;  // largest limit whose value in bytes fits into 64 bits

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void expectOneOf(const JsonCursor& at, const std::vector<std::string>& known, CatalogueText what) {
  study_json::readOneOf(at, known, what);
}

std::vector<std::string> knownOperators() {
  std::vector<std::string> names{"none"};
  const DeviceRegistry registry = makeDeviceRegistry();
  for (const DeviceEntry& entry : registry.entries()) {
    if (entry.simulated) names.push_back(entry.id);
  }
  return names;
}

/// Applies `read` to every element of a list that must not be empty.
template <class Read>
auto readList(const JsonCursor& list, Read read) {
  std::vector<decltype(read(list))> values;
  for (std::size_t i = 0; i < list.size(); ++i) values.push_back(read(list.element(i)));
  if (values.empty()) list.fail(GLISSADE_TEXT("is empty"));
  return values;
}

/// Reads a list of distinct values.
template <class Read>
auto readSet(const JsonCursor& list, Read read) {
  auto values = readList(list, read);
  std::set<typename decltype(values)::value_type> seen;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!seen.insert(values[i]).second)
      list.element(i).fail(GLISSADE_TEXT("is there a second time"), GLISSADE_TEXT("Remove it."));
  }
  return values;
}

ParameterId readParameterId(const JsonCursor& at, const std::string& key) {
  const auto id = parameterByKey(key);
  if (!id)
    at.fail(GLISSADE_TEXT("is not a parameter"), GLISSADE_TEXT("See 'glissade-cli plan --help'; '_' stands for '-'."));
  if (isLimit(*id)) at.fail(GLISSADE_TEXT("is a limit"), GLISSADE_TEXT("Move it to \"limits\"."));
  return *id;
}

class Reader {
 public:
  explicit Reader(const JsonCursor& root) : root_(root), strategies_(idsOf(makePlannerRegistryWithPeers())) {
    const SequenceStrategyRegistry sequences = makeSequenceStrategyRegistry();
    for (const SequenceStrategyEntry& entry : sequences.entries()) {
      strategies_.push_back(std::string(kSequencePrefix) + entry.id);
    }
  }

  Study read(bool quick) {
    root_.allowOnly({"format", "version", "name", "title", "description", "citation", "paper", "scenarios",
                     "strategies", "operators", "parameters", "grid", "limits", "seeds", "rows", "findings", "quick"});
    if (root_.at("format").text() != "glissade-study")
      root_.at("format").fail(GLISSADE_TEXT("is not \"glissade-study\""));
    if (root_.at("version").wholeNumber() != 1)
      root_.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
    readHeading();
    StudyAxes axes;
    readAxes(root_, axes);
    readRows(axes);
    readFindings();
    applyQuick(quick);
    spellOut();
    study_.quick = quick;
    return study_;
  }

 private:
  std::string optionalText(const char* key) const {
    const auto at = root_.find(key);
    return at ? at->text() : "";
  }

  void readHeading() {
    StudyHeading& heading = study_.heading;
    heading.name = root_.at("name").nonEmptyText();
    heading.title = root_.at("title").nonEmptyText();
    heading.description = optionalText("description");
    heading.citation = optionalText("citation");
    const auto columns = root_.find("paper");
    if (!columns) return;
    heading.paper = readList(*columns, readColumn);
  }

  static PaperColumn readColumn(const JsonCursor& at) {
    at.allowOnly({"key", "title", "measure", "statistic", "over"});
    return {at.at("key").nonEmptyText(), at.at("title").nonEmptyText(), study_json::readQuantity(at)};
  }

  /// Reads the keys that the study, rows and the quick section have in common.
  void readAxes(const JsonCursor& at, StudyAxes& axes) const {
    if (const auto list = at.find("scenarios")) {
      list->sizeUpTo(kMostRows);
      axes.scenarios = readSet(*list, [](const JsonCursor& name) { return name.nonEmptyText(); });
    }
    if (const auto list = at.find("strategies")) {
      axes.strategies = readSet(*list, [this](const JsonCursor& name) { return readStrategy(name); });
    }
    if (const auto list = at.find("operators")) axes.operators = readSet(*list, readOperator);
    if (const auto limits = at.find("limits")) readLimits(*limits, axes);
    if (const auto parameters = at.find("parameters")) readParameters(*parameters, axes);
    if (const auto grid = at.find("grid")) readGrid(*grid, axes);
    if (const auto seeds = at.find("seeds")) axes.seeds = readSeeds(*seeds);
  }

  std::string readStrategy(const JsonCursor& at) const {
    expectOneOf(at, strategies_, GLISSADE_TEXT("strategy"));
    return at.text();
  }

  static std::string readOperator(const JsonCursor& at) {
    expectOneOf(at, knownOperators(), GLISSADE_TEXT("operator"));
    return at.text();
  }

  static void readParameters(const JsonCursor& parameters, StudyAxes& axes) {
    parameters.expectObject();
    for (const auto& item : parameters.json().items()) {
      const JsonCursor at = parameters.at(item.key());
      axes.settings[readParameterId(at, item.key())] = at.number();
    }
  }

  static void readGrid(const JsonCursor& grid, StudyAxes& axes) {
    grid.expectObject();
    axes.grid.clear();
    for (const auto& item : grid.json().items()) {
      const JsonCursor at = grid.at(item.key());
      axes.grid.emplace_back(readParameterId(at, item.key()),
                             readSet(at, [](const JsonCursor& value) { return value.number(); }));
    }
  }

  static void readLimits(const JsonCursor& limits, StudyAxes& axes) {
    limits.allowOnly({"time_limit", "max_steps", "max_samples", "steps_per_second", "memory_limit_mb"});
    for (const auto& item : limits.json().items()) {
      const JsonCursor at = limits.at(item.key());
      if (const auto id = parameterByKey(item.key())) {
        axes.settings[*id] = at.number();
      } else {
        axes.memoryLimitMb = at.wholeNumber();
        if (axes.memoryLimitMb > kMostMegabytes) at.fail({GLISSADE_TEXT("is beyond %1"), {kMostMegabytes}});
      }
    }
  }

  static std::vector<std::uint64_t> readSeeds(const JsonCursor& at) {
    if (at.json().is_array()) {
      auto seeds = readSet(at, [](const JsonCursor& seed) { return seed.wholeNumber(); });
      std::sort(seeds.begin(), seeds.end());
      return seeds;
    }
    at.allowOnly({"first", "count"});
    const std::uint64_t first = at.at("first").wholeNumber();
    const std::uint64_t count = at.at("count").wholeNumber();
    if (count == 0 || count > kMostRuns || first > UINT64_MAX - count) {
      at.at("count").fail({GLISSADE_TEXT("is not from 1 to %1"), {kMostRuns}});
    }
    std::vector<std::uint64_t> seeds(count);
    for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i] = first + i;
    return seeds;
  }

  void readRows(const StudyAxes& axes) {
    const auto list = root_.find("rows");
    if (!list) {
      rows_.push_back({"", axes, {}, ""});
      return;
    }
    std::set<std::string> labels;
    list->sizeUpTo(kMostRows);
    rows_ = readList(*list, [&](const JsonCursor& at) {
      StudyRow row = readRow(at, axes);
      if (!labels.insert(row.label).second)
        at.at("label").fail(GLISSADE_TEXT("is there a second time"), GLISSADE_TEXT("Labels name rows."));
      row.location = "/rows/" + std::to_string(labels.size() - 1);
      return row;
    });
  }

  StudyRow readRow(const JsonCursor& at, const StudyAxes& axes) {
    at.allowOnly({"label", "scenarios", "strategies", "operators", "parameters", "grid", "limits", "seeds", "paper"});
    StudyRow row{at.at("label").nonEmptyText(), axes, {}, ""};
    readAxes(at, row.axes);
    countSeeds(row, at);
    if (const auto paper = at.find("paper")) row.paper = readPaper(*paper);
    return row;
  }

  void countSeeds(const StudyRow& row, const JsonCursor& at) {
    seedsOfRows_ += row.axes.seeds.size();
    if (seedsOfRows_ > kMostRuns)
      at.fail(GLISSADE_TEXT("makes too many runs"), GLISSADE_TEXT("Vary less, or less finely."));
  }

  std::map<std::string, PaperValue> readPaper(const JsonCursor& paper) const {
    paper.expectObject();
    std::vector<std::string> keys{"note"};
    for (const PaperColumn& column : study_.heading.paper) keys.push_back(column.key);
    std::map<std::string, PaperValue> values;
    for (const auto& item : paper.json().items()) {
      const JsonCursor at = paper.at(item.key());
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
        at.fail(GLISSADE_TEXT("is not a column of \"paper\""), {GLISSADE_TEXT("Use one of: %1."), {listed(keys)}});
      }
      if (item.value().is_null()) continue;
      values[item.key()] = item.value().is_string() ? PaperValue(at.text()) : PaperValue(at.number());
    }
    return values;
  }

  /// Reads the findings. Their names are checked against all rows, including those that --quick leaves out.
  void readFindings() {
    const auto list = root_.find("findings");
    if (!list) return;
    list->sizeUpTo(kMostRows);
    study_.heading.findings = readList(*list, study_json::readFinding);
    for (std::size_t i = 0; i < list->size(); ++i) {
      const JsonCursor at = list->element(i);
      expectKnown(at.at("cells"));
      if (at.at("than").json().is_object()) expectKnown(at.at("than"));
    }
  }

  void expectKnown(const JsonCursor& selection) const {
    std::vector<std::string> labels;
    std::vector<std::string> scenarios;
    for (const StudyRow& row : rows_) {
      labels.push_back(row.label);
      scenarios.insert(scenarios.end(), row.axes.scenarios.begin(), row.axes.scenarios.end());
    }
    const auto expectAll = [&](const char* key, const std::vector<std::string>& known, CatalogueText what) {
      const auto names = selection.find(key);
      for (std::size_t i = 0; names && i < names->size(); ++i) expectOneOf(names->element(i), known, what);
    };
    expectAll("rows", labels, GLISSADE_TEXT("row"));
    expectAll("scenarios", scenarios, GLISSADE_TEXT("scenario"));
    expectAll("strategies", strategies_, GLISSADE_TEXT("strategy"));
    expectAll("operators", knownOperators(), GLISSADE_TEXT("operator"));
  }

  /// Reads the quick section, even where it does not apply, so that its errors are found.
  void applyQuick(bool applies) {
    const auto quick = root_.find("quick");
    if (!quick) {
      if (applies) root_.at("quick");
      return;
    }
    quick->allowOnly({"seeds", "rows", "operators", "limits"});
    std::vector<StudyRow> kept;
    seedsOfRows_ = 0;
    for (StudyRow& row : quickRows(*quick)) {
      readAxes(*quick, row.axes);
      countSeeds(row, *quick);
      kept.push_back(std::move(row));
    }
    if (applies) rows_ = std::move(kept);
  }

  std::vector<StudyRow> quickRows(const JsonCursor& quick) const {
    const auto list = quick.find("rows");
    if (!list) return rows_;
    std::vector<std::string> labels;
    for (const StudyRow& row : rows_) labels.push_back(row.label);
    const auto names = readSet(*list, [&](const JsonCursor& at) {
      expectOneOf(at, labels, GLISSADE_TEXT("row"));
      return at.text();
    });
    std::vector<StudyRow> chosen;
    for (const StudyRow& row : rows_) {
      if (std::find(names.begin(), names.end(), row.label) != names.end()) chosen.push_back(row);
    }
    return chosen;
  }

  void spellOut() {
    double runs = 0.0;
    double cells = 0.0;
    for (const StudyRow& row : rows_) {
      expectComplete(row);
      cells += cellCount(row);
      runs += cellCount(row) * static_cast<double>(row.axes.seeds.size());
      if (cells > kMostCells || runs > kMostRuns)
        locationOf(row).fail(GLISSADE_TEXT("makes too many runs"), GLISSADE_TEXT("Vary less, or less finely."));
      for (StudyCell& cell : cellsOf(row)) {
        if (isSequence(cell)) expectOfSequence(cell, row);
        study_.cells.push_back(std::move(cell));
      }
    }
  }

  /// Checks a cell of a sequence, which has a time limit but no parameters of paths and no other limits.
  void expectOfSequence(const StudyCell& cell, const StudyRow& row) const {
    if (cell.operatorName != "none")
      locationOf(row).fail(GLISSADE_TEXT("is a sequence with an operator"), GLISSADE_TEXT("Say \"none\"."));
    if (cell.settings.count(ParameterId::TimeLimit) == 0) {
      locationOf(row).fail(GLISSADE_TEXT("is a sequence without a time limit"),
                           GLISSADE_TEXT("Give time_limit under \"limits\"."));
    }
    for (const auto& [id, value] : cell.settings) {
      if (isLimit(id)) continue;
      locationOf(row).fail({GLISSADE_TEXT("is a sequence, which has no parameter %1"), {specOf(id).key}},
                           GLISSADE_TEXT("Give limits only."));
    }
  }

  void expectComplete(const StudyRow& row) const {
    const auto limited = [&](ParameterId id) {
      const auto found = row.axes.settings.find(id);
      return found != row.axes.settings.end() && found->second > 0.0;
    };
    if (row.axes.scenarios.empty())
      locationOf(row).fail(GLISSADE_TEXT("has no scenario"), GLISSADE_TEXT("Add \"scenarios\"."));
    if (row.axes.strategies.empty())
      locationOf(row).fail(GLISSADE_TEXT("has no strategy"), GLISSADE_TEXT("Add \"strategies\"."));
    if (row.axes.seeds.empty()) locationOf(row).fail(GLISSADE_TEXT("has no seeds"), GLISSADE_TEXT("Add \"seeds\"."));
    if (!limited(ParameterId::TimeLimit) && !limited(ParameterId::MaxSteps) && !limited(ParameterId::MaxSamples)) {
      locationOf(row).fail(GLISSADE_TEXT("may run for ever"),
                           GLISSADE_TEXT("Give time_limit, max_steps or max_samples under \"limits\"."));
    }
  }

  JsonCursor locationOf(const StudyRow& row) const { return {root_.json(), root_.file(), row.location}; }

  const JsonCursor& root_;
  std::vector<std::string> strategies_;
  std::vector<StudyRow> rows_;
  std::uint64_t seedsOfRows_ = 0;  ///< number of seeds of all rows, which are held in memory
  Study study_;
};

}  // namespace

Result<Study> parseStudy(const std::string& text, const std::string& file, bool quick) {
  return readJson(text, file, [quick](const JsonCursor& root) { return Reader(root).read(quick); });
}

}  // namespace glissade
