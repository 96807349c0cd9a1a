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
  if (names.empty()) list->fail("is empty", "Remove it to mean any.");
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
  const std::string name = readOneOf(at, kPairNames, "pairing");
  return static_cast<PairBy>(std::find(kPairNames.begin(), kPairNames.end(), name) - kPairNames.begin());
}

void readThan(const JsonCursor& at, Finding& finding) {
  const JsonCursor than = at.at("than");
  if (than.json().is_number()) {
    finding.than = than.number();
    if (at.has("factor")) at.at("factor").fail("has no meaning beside a number", "Put it into \"than\".");
    if (at.has("pair_by")) at.at("pair_by").fail("has no meaning beside a number", "Remove it.");
    return;
  }
  finding.than = readSelection(than);
  if (const auto factor = at.find("factor")) finding.factor = factor->positiveNumber();
  const auto pairs = at.find("pair_by");
  for (std::size_t i = 0; pairs && i < pairs->size(); ++i) finding.pairBy.push_back(readPairBy(pairs->element(i)));
}

}  // namespace

std::string readOneOf(const JsonCursor& at, const std::vector<std::string>& known, const std::string& what) {
  std::string name = at.nonEmptyText();
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  std::string names;
  for (const std::string& one : known) names += (names.empty() ? "" : ", ") + one;
  at.fail("names the unknown " + what + " '" + name + "'", "Choose one of " + names + ".");
}

Quantity readQuantity(const JsonCursor& at) {
  std::vector<std::string> measures{"success_rate", "planning_s", "planning_cpu_s", "wall_s", "cpu_s"};
  for (const ResultColumn& column : resultColumns()) measures.emplace_back(column.name);
  Quantity quantity;
  quantity.measure = readOneOf(at.at("measure"), measures, "measure");
  if (quantity.measure == "success_rate") return quantity;
  quantity.statistic = readOneOf(at.at("statistic"), {"median", "mean"}, "statistic");
  quantity.over = readOneOf(at.at("over"), {"solved", "all"}, "kind of runs");
  return quantity;
}

Finding readFinding(const JsonCursor& at) {
  at.allowOnly({"text", "measure", "statistic", "over", "cells", "is", "than", "factor", "pair_by"});
  Finding finding;
  finding.text = at.at("text").nonEmptyText();
  finding.quantity = readQuantity(at);
  finding.cells = readSelection(at.at("cells"));
  const std::string relation = readOneOf(at.at("is"), {"below", "above"}, "relation");
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
