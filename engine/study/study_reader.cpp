#include "engine/study/study_reader.h"

#include <algorithm>
#include <set>

#include "engine/files/parameters_json.h"
#include "engine/operator/device_registry.h"
#include "engine/sequence/sequence_strategy.h"
#include "engine/study/benchmarks/peer_planners.h"
#include "engine/study/study_axes.h"
#include "engine/study/study_json.h"
#include "engine/study/study_plan.h"

namespace glissade {
namespace {

using study_json::Json;

constexpr std::uint64_t kMostRuns = 10'000'000;
constexpr double kMostCells = 100'000;
constexpr std::uint64_t kMostMegabytes = 1ULL << 40U;  // largest limit whose value in bytes fits into 64 bits

/// The section of the study file that --quick applies.
struct QuickSection {
  std::vector<std::string> rows;  ///< labels of the rows that stay; empty: all
  StudyAxes axes;
};

/// A study file before its cells are listed.
struct StudyFile {
  StudyHeading heading;
  StudyAxes axes;
  std::vector<StudyRow> rows;
  std::optional<QuickSection> quick;
};

std::vector<std::string> knownStrategies() {
  std::vector<std::string> names = idsOf(makePlannerRegistryWithPeers());
  const SequenceStrategyRegistry sequences = makeSequenceStrategyRegistry();
  for (const SequenceStrategyEntry& entry : sequences.entries())
    names.push_back(std::string(kSequencePrefix) + entry.id);
  return names;
}

std::vector<std::string> knownOperators() {
  std::vector<std::string> names{"none"};
  const DeviceRegistry registry = makeDeviceRegistry();
  for (const DeviceEntry& entry : registry.entries()) {
    if (entry.simulated) names.push_back(entry.id);
  }
  return names;
}

constexpr FunctionFormat kStrategy{[](const JsonCursor& at) {
                                     static const std::vector<std::string> kKnown = knownStrategies();
                                     std::string name = at.nonEmptyText();
                                     study_json::expectOneOf(name, kKnown, GLISSADE_TEXT("strategy"), at);
                                     return name;
                                   },
                                   kAsItIs, R"({"type": "string", "minLength": 1})"};

struct OperatorFormat {
  std::string read(const JsonCursor& at) const {
    std::string name = at.nonEmptyText();
    study_json::expectOneOf(name, knownOperators(), GLISSADE_TEXT("operator"), at);
    return name;
  }
  Json schema(SchemaDefinitions& /*definitions*/) const { return {{"enum", knownOperators()}}; }
};

/// A list of distinct values, which is not empty.
template <class Item>
struct SetFormat {
  Item item;
  std::size_t most = study_json::kMostRows;

  auto read(const JsonCursor& at) const {
    std::vector<decltype(item.read(at))> values = listOf(item, 1, most).read(at);
    std::set<decltype(item.read(at))> seen;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!seen.insert(values[i]).second)
        at.element(i).fail(GLISSADE_TEXT("is there a second time"), GLISSADE_TEXT("Remove it."));
    }
    return values;
  }
  Json schema(SchemaDefinitions& definitions) const {
    return {{"type", "array"}, {"minItems", 1}, {"uniqueItems", true}, {"items", item.schema(definitions)}};
  }
};
template <class Item>
SetFormat(Item) -> SetFormat<Item>;

/// Refuses limits, which stand under their own key.
void refuseLimit(ParameterId id, const JsonCursor& at) {
  if (isLimit(id)) at.fail(GLISSADE_TEXT("is a limit"), GLISSADE_TEXT("Move it to \"limits\"."));
}

/// The schema of an object with a value for parameters.
Json schemaOfParameters(const Json& value) {
  Json properties = Json::object();
  for (const ParameterSpec& spec : parameterTable()) {
    if (!isLimit(spec.id)) properties[std::string(spec.key)] = value;
  }
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

struct VariedParametersFormat {
  std::map<ParameterId, double> read(const JsonCursor& at) const {
    std::map<ParameterId, double> values = study_json::ParameterNumbersFormat().read(at);
    for (const auto& [id, value] : values) refuseLimit(id, at.at(std::string(specOf(id).key)));
    return values;
  }
  Json schema(SchemaDefinitions& /*definitions*/) const { return schemaOfParameters({{"type", "number"}}); }
};

/// Values of parameters, in the order of the file.
struct GridFormat {
  StudyGrid read(const JsonCursor& at) const {
    at.expectObject();
    StudyGrid grid;
    for (const auto& item : at.json().items()) {
      const JsonCursor values = at.at(item.key());
      const ParameterId id = parameterNamed(item.key(), values);
      refuseLimit(id, values);
      grid.emplace_back(id, SetFormat{kNumber}.read(values));
    }
    return grid;
  }
  Json schema(SchemaDefinitions& definitions) const {
    return schemaOfParameters(SetFormat{kNumber}.schema(definitions));
  }
};

/// Seeds in a list, or the first one and their number.
struct SeedsFormat {
  StudySeeds read(const JsonCursor& at) const {
    if (at.json().is_array()) {
      auto seeds = SetFormat<decltype(kCount)>{kCount, kMostRuns}.read(at);
      std::sort(seeds.begin(), seeds.end());
      return seeds;
    }
    at.allowOnly({"first", "count"});
    const SeedRange range{at.at("first").wholeNumber(), at.at("count").wholeNumber()};
    if (range.count == 0 || range.count > kMostRuns || range.first > UINT64_MAX - range.count)
      at.at("count").fail({GLISSADE_TEXT("is not from 1 to %1"), {kMostRuns}});
    return range;
  }
  Json schema(SchemaDefinitions& definitions) const {
    Json range = Json::parse(R"({"type": "object", "additionalProperties": false, "required": ["first", "count"],
      "properties": {"first": {"type": "integer", "minimum": 0}, "count": {"type": "integer", "minimum": 1}}})");
    range["properties"]["count"]["maximum"] = kMostRuns;
    return {{"oneOf", {SetFormat{kCount}.schema(definitions), std::move(range)}}};
  }
};

constexpr FunctionFormat kMegabytes{[](const JsonCursor& at) {
                                      const std::uint64_t megabytes = at.wholeNumber();
                                      if (megabytes > kMostMegabytes)
                                        at.fail({GLISSADE_TEXT("is beyond %1"), {kMostMegabytes}});
                                      return megabytes;
                                    },
                                    kAsItIs, R"({"type": "integer", "minimum": 0})"};

constexpr auto limitOf(ParameterId id) {
  return Accessor{[id](const StudyLimits& limits) { return limits.settings.at(id); },
                  [id](StudyLimits& limits, double value) { limits.settings[id] = value; }};
}

/// A member of the quick section's axes.
template <class Value>
constexpr auto ofAxes(Value StudyAxes::*member) {
  return Accessor{[member](const QuickSection& quick) -> const Value& { return quick.axes.*member; },
                  [member](QuickSection& quick, auto value) { quick.axes.*member = std::move(value); }};
}

/// Lists the cells of a file and checks what one value alone does not show. Throws JsonError.
class CellLister {
 public:
  CellLister(StudyFile file, const JsonCursor& root) : file_(std::move(file)), root_(root) {}

  Study list(bool quick) {
    checkPapers();
    std::vector<StudyRow> rows = rowsOfFile();
    checkFindings(rows);
    checkSeeds(rows);
    if (quick || file_.quick) {
      (void)root_.at("quick");
      std::vector<StudyRow> quickRows = rowsOfQuick(rows);
      checkSeeds(quickRows);
      if (quick) rows = std::move(quickRows);
    }
    return {std::move(file_.heading), quick, cellsOfRows(rows)};
  }

 private:
  void checkPapers() const {
    std::vector<std::string> keys{"note"};
    for (const PaperColumn& column : file_.heading.paper) keys.push_back(column.key);
    for (std::size_t i = 0; i < file_.rows.size(); ++i) {
      for (const auto& [key, value] : file_.rows[i].paper) {
        study_json::expectOneOf(key, keys, GLISSADE_TEXT("column"), rowAt(i).at("paper").at(key));
      }
      for (const auto& [key, value] : file_.rows[i].measured) {
        study_json::expectOneOf(key, keys, GLISSADE_TEXT("column"), rowAt(i).at("measured").at(key));
      }
    }
  }

  /// The rows with all their settings; a file without rows has one that has no label.
  std::vector<StudyRow> rowsOfFile() const {
    StudyAxes general = file_.axes;
    if (general.operators.empty()) general.operators = {"none"};
    if (file_.rows.empty()) return {{"", general, {}, {}, ""}};
    std::vector<StudyRow> rows = file_.rows;
    std::set<std::string> labels;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!labels.insert(rows[i].label).second)
        rowAt(i).at("label").fail(GLISSADE_TEXT("is there a second time"), GLISSADE_TEXT("Labels name rows."));
      rows[i].axes = inherited(rows[i].axes, general);
      rows[i].location = rowAt(i).pointer();
    }
    return rows;
  }

  JsonCursor rowAt(std::size_t index) const { return root_.at("rows").element(index); }

  /// Checks the names of findings against all rows, including those that --quick leaves out.
  void checkFindings(const std::vector<StudyRow>& rows) const {
    for (std::size_t i = 0; i < file_.heading.findings.size(); ++i) {
      const JsonCursor at = root_.at("findings").element(i);
      checkNames(at.at("cells"), rows);
      if (at.at("than").json().is_object()) checkNames(at.at("than"), rows);
    }
  }

  static void checkNames(const JsonCursor& selection, const std::vector<StudyRow>& rows) {
    std::vector<std::string> labels;
    std::vector<std::string> scenarios;
    for (const StudyRow& row : rows) {
      labels.push_back(row.label);
      scenarios.insert(scenarios.end(), row.axes.scenarios.begin(), row.axes.scenarios.end());
    }
    const auto checkAll = [&](const char* key, const std::vector<std::string>& known, CatalogueText what) {
      const auto names = selection.find(key);
      for (std::size_t i = 0; names && i < names->size(); ++i)
        study_json::expectOneOf(names->element(i).text(), known, what, names->element(i));
    };
    checkAll("rows", labels, GLISSADE_TEXT("row"));
    checkAll("scenarios", scenarios, GLISSADE_TEXT("scenario"));
    checkAll("strategies", knownStrategies(), GLISSADE_TEXT("strategy"));
    checkAll("operators", knownOperators(), GLISSADE_TEXT("operator"));
  }

  std::vector<StudyRow> rowsOfQuick(const std::vector<StudyRow>& all) const {
    std::vector<std::string> labels;
    for (const StudyRow& row : all) labels.push_back(row.label);
    const std::vector<std::string>& chosen = file_.quick->rows;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      study_json::expectOneOf(chosen[i], labels, GLISSADE_TEXT("row"), root_.at("quick").at("rows").element(i));
    std::vector<StudyRow> rows;
    for (const StudyRow& row : all) {
      if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), row.label) == chosen.end()) continue;
      rows.push_back(row);
      rows.back().axes = inherited(file_.quick->axes, row.axes);
    }
    return rows;
  }

  /// Refuses more seeds than memory holds, before they are listed.
  void checkSeeds(const std::vector<StudyRow>& rows) const {
    std::uint64_t seeds = 0;
    for (const StudyRow& row : rows) {
      seeds += seedCount(row.axes.seeds);
      if (seeds > kMostRuns) failTooMany(row);
    }
  }

  std::vector<StudyCell> cellsOfRows(const std::vector<StudyRow>& rows) const {
    std::vector<StudyCell> cells;
    double cellsBefore = 0.0;
    double runs = 0.0;
    for (const StudyRow& row : rows) {
      checkComplete(row);
      cellsBefore += cellCount(row);
      runs += cellCount(row) * static_cast<double>(seedCount(row.axes.seeds));
      if (cellsBefore > kMostCells || runs > kMostRuns) failTooMany(row);
      for (StudyCell& cell : cellsOf(row)) {
        if (isSequence(cell)) checkSequence(cell, row);
        cells.push_back(std::move(cell));
      }
    }
    return cells;
  }

  void checkComplete(const StudyRow& row) const {
    const auto& limits = row.axes.limits.settings;
    const auto limited = [&](ParameterId id) { return limits.count(id) != 0 && limits.at(id) > 0.0; };
    const JsonCursor at = placeOf(row);
    if (row.axes.scenarios.empty()) at.fail(GLISSADE_TEXT("has no scenario"), GLISSADE_TEXT("Add \"scenarios\"."));
    if (row.axes.strategies.empty()) at.fail(GLISSADE_TEXT("has no strategy"), GLISSADE_TEXT("Add \"strategies\"."));
    if (seedCount(row.axes.seeds) == 0) at.fail(GLISSADE_TEXT("has no seeds"), GLISSADE_TEXT("Add \"seeds\"."));
    if (!limited(ParameterId::TimeLimit) && !limited(ParameterId::MaxSteps) && !limited(ParameterId::MaxSamples)) {
      at.fail(GLISSADE_TEXT("may run for ever"),
              GLISSADE_TEXT("Give time_limit, max_steps or max_samples under \"limits\"."));
    }
  }

  /// Checks a cell of a sequence, which has a time limit but no parameters of paths and no other limits.
  void checkSequence(const StudyCell& cell, const StudyRow& row) const {
    const JsonCursor at = placeOf(row);
    if (cell.operatorName != "none")
      at.fail(GLISSADE_TEXT("is a sequence with an operator"), GLISSADE_TEXT("Say \"none\"."));
    if (cell.settings.count(ParameterId::TimeLimit) == 0) {
      at.fail(GLISSADE_TEXT("is a sequence without a time limit"), GLISSADE_TEXT("Give time_limit under \"limits\"."));
    }
    for (const auto& [id, value] : cell.settings) {
      if (isLimit(id)) continue;
      at.fail({GLISSADE_TEXT("is a sequence, which has no parameter %1"), {specOf(id).key}},
              GLISSADE_TEXT("Give limits only."));
    }
  }

  [[noreturn]] void failTooMany(const StudyRow& row) const {
    placeOf(row).fail(GLISSADE_TEXT("makes too many runs"), GLISSADE_TEXT("Vary less, or less finely."));
  }

  JsonCursor placeOf(const StudyRow& row) const { return {root_.json(), root_.file(), row.location}; }

  StudyFile file_;
  const JsonCursor& root_;
};

}  // namespace

template <class Archive>
void describe(Archive& limits, Type<StudyLimits> /*type*/) {
  limits.type("limits");
  for (const ParameterSpec& spec : parameterTable()) {
    if (isLimit(spec.id)) limits.optional(spec.key.data(), limitOf(spec.id), kNumber);
  }
  limits.optional("memory_limit_mb", &StudyLimits::memoryMb, kMegabytes, "Address space of the process of a run.");
}

template <class Archive>
void describe(Archive& axes, Type<StudyAxes> /*type*/) {
  axes.type("settings");
  axes.optional("scenarios", &StudyAxes::scenarios, SetFormat{kNonEmptyText}, "Relative to the folder of the file.");
  axes.optional("strategies", &StudyAxes::strategies, SetFormat{kStrategy},
                "Planners, as 'glissade-cli plan --strategy' names them; sequence-greedy and sequence-best-first find "
                "sequences, with a time_limit, without operators and parameters.");
  axes.optional("operators", &StudyAxes::operators, SetFormat{OperatorFormat()});
  axes.optional("parameters", &StudyAxes::parameters, VariedParametersFormat());
  axes.optional("grid", &StudyAxes::grid, GridFormat(), "Every combination of these values.");
  axes.optional("limits", &StudyAxes::limits, kObject<StudyLimits>);
  axes.optional("seeds", &StudyAxes::seeds, SeedsFormat());
}

template <class Archive>
void describe(Archive& row, Type<StudyRow> /*type*/) {
  row.type("row", "A named row. Its settings replace those of the whole study; parameters and limits one by one.");
  row.required("label", &StudyRow::label, kNonEmptyText);
  row.embed(&StudyRow::axes);
  row.optional("paper", &StudyRow::paper, study_json::PaperFormat(),
               "Printed numbers or words by the keys of the columns, and a note.");
  row.optional(
      "measured", &StudyRow::measured, mapOf(listOf(kNumber, 3, 3)),
      "Quartiles of the study's own results at full size with its first operator, over the solved runs, by the "
      "keys of the columns: lower, median, upper.");
}

template <class Archive>
void describe(Archive& quick, Type<QuickSection> /*type*/) {
  quick.type("quick", "Settings of --quick, and the labels of the rows that stay.");
  quick.optional("seeds", ofAxes(&StudyAxes::seeds), SeedsFormat());
  quick.optional("rows", &QuickSection::rows, SetFormat{kNonEmptyText});
  quick.optional("operators", ofAxes(&StudyAxes::operators), SetFormat{OperatorFormat()});
  quick.optional("limits", ofAxes(&StudyAxes::limits), kObject<StudyLimits>);
}

template <class Archive>
void describe(Archive& study, Type<StudyFile> /*type*/) {
  study.type(
      "study",
      "Runs over rows x scenarios x strategies x operators x grid x seeds, and the numbers that a paper printed.");
  study.constant("format", "glissade-study");
  study.constant("version", 1);
  study.embed(&StudyFile::heading);
  study.embed(&StudyFile::axes);
  study.optional("rows", &StudyFile::rows, listOf(kObject<StudyRow>, 1, study_json::kMostRows));
  study.optional("quick", &StudyFile::quick, kObject<QuickSection>);
}

Json studySchema() { return describedSchema<StudyFile>("Glissade study, version 1"); }

Result<Study> parseStudy(const std::string& text, const std::string& file, bool quick) {
  return readJson(text, file, [quick](const JsonCursor& root) {
    return CellLister(readDescribed<StudyFile>(root), root).list(quick);
  });
}

}  // namespace glissade
