#include "app/cli/environment_report.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/text_cells.h"
#include "engine/base/enum_names.h"
#include "engine/places/edit_binding.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr EnumNames<Provenance, 4> kProvenanceNames{{"default", "computed", "inherited", "edited"}};

Json toJson(const Vector3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json attributesOf(const SemanticModel& semantics, std::size_t place) {
  Json attributes;
  for (const AttributeDefinition& definition : semantics.table().definitions()) {
    if (definition.owner != AttributeOwner::Place) continue;
    const ProvenValue value = semantics.ofPlace(place, definition.name);
    Json entry;
    std::visit([&](const auto& typed) { entry["value"] = typed; }, value.value);
    entry["source"] = kProvenanceNames.of(value.provenance);
    attributes[definition.name] = entry;
  }
  return attributes;
}

}  // namespace

void printEnvironment(const SceneKnowledge& knowledge, const SemanticModel& semantics, const Console& console) {
  const EnvironmentModel& environment = *knowledge.environment;
  const TopologicalMap& map = environment.map;
  const auto leaves = environment.octree->leafCounts();
  console.print({});
  console.print({GLISSADE_TEXT("octree     %1 levels, cells: %2 free, %3 mobile, %4 static"),
                 {environment.octree->depth(), leaves[0], leaves[1], leaves[2]}});
  console.print({});
  console.print({GLISSADE_TEXT("places (%1)"), {environment.options.identifier}});
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    const bool isCluttered = std::get<bool>(semantics.ofPlace(i, "cluttered").value);
    const std::string passage = map.places[i].passage ? console.text(GLISSADE_TEXT("passage")) + " " : "";
    console.print({GLISSADE_TEXT("  %1complexity %2narrowness %3compatibility %4%5%6"),
                   {toLeft(semantics.placeName(i), 8), toLeft(toText(semantics.ofPlace(i, "complexity").value), 3),
                    toLeft(rounded(map.places[i].narrowness), 10),
                    toLeft(rounded(std::get<double>(semantics.ofPlace(i, "compatibility").value)), 10), passage,
                    isCluttered ? Message(GLISSADE_TEXT("cluttered")) : Message()}});
  }
  console.print({});
  console.print(GLISSADE_TEXT("borders"));
  for (const Border& border : map.borders) {
    std::ostringstream centre;
    centre << border.centre.transpose();
    console.print(
        {GLISSADE_TEXT("  %1 - %2, opening %3 m2 at %4"),
         {semantics.placeName(static_cast<std::size_t>(border.placeA)),
          semantics.placeName(static_cast<std::size_t>(border.placeB)), rounded(border.opening), centre.str()}});
  }
}

Json toJson(const SceneKnowledge& knowledge, const SemanticModel& semantics) {
  const EnvironmentModel& environment = *knowledge.environment;
  const TopologicalMap& map = environment.map;
  const auto leaves = environment.octree->leafCounts();
  Json report;
  report["octree"] = {{"levels", environment.octree->depth()},
                      {"free_cells", leaves[0]},
                      {"mobile_cells", leaves[1]},
                      {"static_cells", leaves[2]}};
  report["identification"] = environment.options.identifier;
  report["places"] = Json::array();
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    const PassageFit& fit = knowledge.fits[i];
    report["places"].push_back({{"name", semantics.placeName(i)},
                                {"at", toJson(map.places[i].anchor)},
                                {"volume_m3", map.places[i].volume},
                                {"passage", map.places[i].passage},
                                {"margin_m", fit.margin},
                                {"straight_crossing", fit.crossing.has_value()},
                                {"attributes", attributesOf(semantics, i)}});
  }
  report["borders"] = Json::array();
  for (const Border& border : map.borders) {
    report["borders"].push_back({{"places",
                                  {semantics.placeName(static_cast<std::size_t>(border.placeA)),
                                   semantics.placeName(static_cast<std::size_t>(border.placeB))}},
                                 {"at", toJson(border.centre)},
                                 {"opening_m2", border.opening}});
  }
  return report;
}

void warnOfEdits(const LoadedScenario& scenario, const SceneKnowledge& knowledge, const Console& console) {
  Warnings warnings = editWarnings(knowledge.environment->map, semanticEditsOf(scenario.scenario));
  for (Diagnostic& warning : warnings) warning.file = scenario.file;
  reportWarnings(warnings, console);
}

}  // namespace glissade::cli
