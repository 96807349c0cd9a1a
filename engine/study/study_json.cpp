#include "engine/study/study_json.h"

#include <algorithm>
#include <cmath>

#include "engine/files/parameters_json.h"
#include "engine/study/run_result.h"

namespace glissade {
namespace study_json {

Json number(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (value == std::floor(value) && std::abs(value) <= kExact) return static_cast<std::int64_t>(value);
  return value;
}

std::map<ParameterId, double> ParameterNumbersFormat::read(const JsonCursor& at) const {
  return ParametersFormat().read(at);
}

Json ParameterNumbersFormat::write(const std::map<ParameterId, double>& values) const {
  Json json = Json::object();
  for (const auto& [id, value] : values) json[std::string(specOf(id).key)] = number(value);
  return json;
}

Json ParameterNumbersFormat::schema(SchemaDefinitions& definitions) const {
  return ParametersFormat().schema(definitions);
}

std::map<std::string, PaperValue> PaperFormat::read(const JsonCursor& at) const {
  at.expectObject();
  std::map<std::string, PaperValue> values;
  for (const auto& item : at.json().items()) {
    const JsonCursor value = at.at(item.key());
    if (item.value().is_null()) continue;
    values[item.key()] = value.isString() ? PaperValue(value.text()) : PaperValue(value.number());
  }
  return values;
}

Json PaperFormat::write(const std::map<std::string, PaperValue>& values) const {
  Json json = Json::object();
  for (const auto& [key, value] : values) {
    if (const auto* printed = std::get_if<double>(&value)) json[key] = number(*printed);
    if (const auto* words = std::get_if<std::string>(&value)) json[key] = *words;
  }
  return json;
}

Json PaperFormat::schema(SchemaDefinitions& /*definitions*/) const {
  return Json::parse(R"({"type": "object", "additionalProperties": {"type": ["number", "string", "null"]}})");
}

void expectOneOf(const std::string& name, const std::vector<std::string>& known, CatalogueText what,
                 const JsonCursor& at) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  std::string names;
  for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
  at.fail({GLISSADE_TEXT("names the unknown %1 '%2'"), {what, name}}, {GLISSADE_TEXT("Choose one of %1."), {names}});
}

}  // namespace study_json

namespace {

using study_json::Json;

constexpr const char* kSuccessRate = "success_rate";
constexpr EnumNames<PairBy, 3> kPairNames{{"operator", "scenario", "strategy"}};
constexpr EnumNames<Relation, 2> kRelationNames{{"below", "above"}};

/// A number above zero that is written without a decimal point where it is whole.
constexpr FunctionFormat kFactor{[](const JsonCursor& at) { return at.positiveNumber(); }, study_json::number,
                                 R"({"type": "number", "exclusiveMinimum": 0})"};

constexpr FunctionFormat kMeasure{
    [](const JsonCursor& at) {
      std::vector<std::string> measures{kSuccessRate, "planning_s", "planning_cpu_s", "wall_s", "cpu_s"};
      for (const ResultColumn& column : resultColumns()) measures.emplace_back(column.name);
      std::string name = at.nonEmptyText();
      study_json::expectOneOf(name, measures, GLISSADE_TEXT("measure"), at);
      return name;
    },
    kAsItIs, R"({"type": "string", "minLength": 1})"};

/// One of two names, or an empty text.
struct ChoiceFormat {
  const char* first;
  const char* second;
  CatalogueText what;

  std::string read(const JsonCursor& at) const {
    std::string name = at.text();
    if (!name.empty()) study_json::expectOneOf(name, {first, second}, what, at);
    return name;
  }
  Json write(const std::string& name) const { return name; }
  Json schema(SchemaDefinitions& /*definitions*/) const { return {{"enum", {first, second, ""}}}; }
};
constexpr ChoiceFormat kStatistic{"median", "mean", GLISSADE_TEXT("statistic")};
constexpr ChoiceFormat kOver{"solved", "all", GLISSADE_TEXT("kind of runs")};

/// A member of the owner's quantity.
template <class Owner>
constexpr auto ofQuantity(std::string Quantity::*member) {
  return Accessor{[member](const Owner& owner) -> const std::string& { return owner.quantity.*member; },
                  [member](Owner& owner, const std::string& value) { owner.quantity.*member = value; }};
}

template <class Owner>
void checkQuantity(const Owner& owner, const JsonCursor& at) {
  if (owner.quantity.measure == kSuccessRate) return;
  (void)at.at("statistic").nonEmptyText();
  (void)at.at("over").nonEmptyText();
}

/// Other cells, or a number.
struct ThanFormat {
  std::variant<CellSelection, double> read(const JsonCursor& at) const {
    if (at.json().is_number()) return at.number();
    return kObject<CellSelection>.read(at);
  }
  Json write(const std::variant<CellSelection, double>& than) const {
    if (const auto* bound = std::get_if<double>(&than)) return study_json::number(*bound);
    return kObject<CellSelection>.write(std::get<CellSelection>(than));
  }
  Json schema(SchemaDefinitions& definitions) const {
    return {{"oneOf", {{{"type", "number"}}, kObject<CellSelection>.schema(definitions)}}};
  }
};

void checkThan(const Finding& finding, const JsonCursor& at) {
  if (!std::holds_alternative<double>(finding.than)) return;
  if (const auto factor = at.find("factor"))
    factor->fail(GLISSADE_TEXT("has no meaning beside a number"), GLISSADE_TEXT("Put it into \"than\"."));
  if (const auto pairs = at.find("pair_by"))
    pairs->fail(GLISSADE_TEXT("has no meaning beside a number"), GLISSADE_TEXT("Remove it."));
}

}  // namespace

template <class Archive>
void describe(Archive& selection, Type<CellSelection> /*type*/) {
  const auto names = listOf(kNonEmptyText, 1, study_json::kMostRows);
  selection.type("selection", "Cells with one of these names. An absent list selects all.");
  selection.optional("rows", &CellSelection::rows, names);
  selection.optional("strategies", &CellSelection::strategies, names);
  selection.optional("operators", &CellSelection::operators, names);
  selection.optional("scenarios", &CellSelection::scenarios, names);
}

template <class Archive>
void describe(Archive& finding, Type<Finding> /*type*/) {
  finding.type("finding",
               "A claim: of every pair of a cell of \"cells\" and one of \"than\", the quantity of the first is below "
               "(above) factor times that of the second.");
  finding.required("text", &Finding::text, kNonEmptyText);
  finding.required("measure", ofQuantity<Finding>(&Quantity::measure), kMeasure);
  finding.optional("statistic", ofQuantity<Finding>(&Quantity::statistic), kStatistic);
  finding.optional("over", ofQuantity<Finding>(&Quantity::over), kOver);
  finding.check(checkQuantity<Finding>);
  finding.required("cells", &Finding::cells, kObject<CellSelection>);
  finding.required("is", &Finding::relation, named(kRelationNames));
  finding.required("than", &Finding::than, ThanFormat(), "Other cells, or a number (without factor and pair_by).");
  finding.optional("factor", &Finding::factor, kFactor, "",
                   [](const Finding& written) { return std::holds_alternative<CellSelection>(written.than); });
  finding.optional("pair_by", &Finding::pairBy, listOf(named(kPairNames)),
                   "Properties that cells must have in common to be compared.");
  finding.check(checkThan);
}

template <class Archive>
void describe(Archive& column, Type<PaperColumn> /*type*/) {
  column.type("paper_column", "A column of the paper's table, and the corresponding quantity of the study.");
  column.required("key", &PaperColumn::key, kNonEmptyText);
  column.required("title", &PaperColumn::title, kNonEmptyText);
  column.required("measure", ofQuantity<PaperColumn>(&Quantity::measure), kMeasure,
                  "success_rate, a time of timing.csv (planning_s, planning_cpu_s, wall_s, cpu_s) or a number of "
                  "runs.csv.");
  column.optional("statistic", ofQuantity<PaperColumn>(&Quantity::statistic), kStatistic, "", Always());
  column.optional("over", ofQuantity<PaperColumn>(&Quantity::over), kOver, "", Always());
  column.check(checkQuantity<PaperColumn>);
}

template struct ObjectFormat<PaperColumn>;
template struct ObjectFormat<Finding>;

}  // namespace glissade
