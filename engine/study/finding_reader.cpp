#include "engine/study/finding_reader.h"

#include <algorithm>

#include "engine/study/run_result.h"

namespace glissade::study_json {
namespace {

const std::vector<std::string> kPairNames{"operator", "scenario", "strategy"};

std::vector<std::string> readNames(const JsonCursor& at, const char* key) {
  std::vector<std::string> names;
  const auto list = at.find(key);
  if (!list) return names;
  for (std::size_t i = 0; i < list->size(); ++i) names.push_back(list->element(i).nonEmptyText());
  if (names.empty()) list->fail(GLISSADE_TEXT("is empty"), GLISSADE_TEXT("Remove it to mean any."));
  return names;
}

CellSelection readSelection(const JsonCursor& at) {
  at.allowOnly({"rows", "strategies", "operators", "scenarios"});
  return {readNames(at, "rows"), readNames(at, "strategies"), readNames(at, "operators"), readNames(at, "scenarios")};
}

Json toJson(const CellSelection& selection) {
  Json json = Json::object();
  if (!selection.rows.empty()) json["rows"] = selection.rows;
  if (!selection.strategies.empty()) json["strategies"] = selection.strategies;
  if (!selection.operators.empty()) json["operators"] = selection.operators;
  if (!selection.scenarios.empty()) json["scenarios"] = selection.scenarios;
  return json;
}

PairBy readPairBy(const JsonCursor& at) {
  const std::string name = readOneOf(at, kPairNames, GLISSADE_TEXT("pairing"));
  return static_cast<PairBy>(std::find(kPairNames.begin(), kPairNames.end(), name) - kPairNames.begin());
}

void readThan(const JsonCursor& at, Finding& finding) {
  const JsonCursor than = at.at("than");
  if (than.json().is_number()) {
    finding.than = than.number();
    if (at.has("factor"))
      at.at("factor").fail(GLISSADE_TEXT("has no meaning beside a number"), GLISSADE_TEXT("Put it into \"than\"."));
    if (at.has("pair_by"))
      at.at("pair_by").fail(GLISSADE_TEXT("has no meaning beside a number"), GLISSADE_TEXT("Remove it."));
    return;
  }
  finding.than = readSelection(than);
  if (const auto factor = at.find("factor")) finding.factor = factor->positiveNumber();
  const auto pairs = at.find("pair_by");
  for (std::size_t i = 0; pairs && i < pairs->size(); ++i) finding.pairBy.push_back(readPairBy(pairs->element(i)));
}

}  // namespace

std::string readOneOf(const JsonCursor& at, const std::vector<std::string>& known, CatalogueText what) {
  std::string name = at.nonEmptyText();
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  std::string names;
  for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
  at.fail({GLISSADE_TEXT("names the unknown %1 '%2'"), {what, name}}, {GLISSADE_TEXT("Choose one of %1."), {names}});
}

Quantity readQuantity(const JsonCursor& at) {
  std::vector<std::string> measures{"success_rate", "planning_s", "planning_cpu_s", "wall_s", "cpu_s"};
  for (const ResultColumn& column : resultColumns()) measures.emplace_back(column.name);
  Quantity quantity;
  quantity.measure = readOneOf(at.at("measure"), measures, GLISSADE_TEXT("measure"));
  if (quantity.measure == "success_rate") return quantity;
  quantity.statistic = readOneOf(at.at("statistic"), {"median", "mean"}, GLISSADE_TEXT("statistic"));
  quantity.over = readOneOf(at.at("over"), {"solved", "all"}, GLISSADE_TEXT("kind of runs"));
  return quantity;
}

Finding readFinding(const JsonCursor& at) {
  at.allowOnly({"text", "measure", "statistic", "over", "cells", "is", "than", "factor", "pair_by"});
  Finding finding;
  finding.text = at.at("text").nonEmptyText();
  finding.quantity = readQuantity(at);
  finding.cells = readSelection(at.at("cells"));
  const std::string relation = readOneOf(at.at("is"), {"below", "above"}, GLISSADE_TEXT("relation"));
  finding.relation = relation == "below" ? Relation::Below : Relation::Above;
  readThan(at, finding);
  return finding;
}

Json toJson(const Finding& finding) {
  Json json;
  json["text"] = finding.text;
  json["measure"] = finding.quantity.measure;
  if (!finding.quantity.statistic.empty()) json["statistic"] = finding.quantity.statistic;
  if (!finding.quantity.over.empty()) json["over"] = finding.quantity.over;
  json["cells"] = toJson(finding.cells);
  json["is"] = finding.relation == Relation::Below ? "below" : "above";
  if (const auto* bound = std::get_if<double>(&finding.than)) {
    json["than"] = number(*bound);
    return json;
  }
  json["than"] = toJson(std::get<CellSelection>(finding.than));
  json["factor"] = number(finding.factor);
  for (const PairBy by : finding.pairBy) json["pair_by"].push_back(kPairNames[static_cast<std::size_t>(by)]);
  return json;
}

}  // namespace glissade::study_json
