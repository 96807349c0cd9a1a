#include "app/cli/environment_report.h"

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/report.h"
#include "engine/base/enum_names.h"
#include "engine/environment/edit_binding.h"

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

void printEnvironment(const SceneKnowledge& knowledge, const SemanticModel& semantics) {
  const EnvironmentModel& environment = *knowledge.environment;
  const TopologicalMap& map = environment.map;
  const auto leaves = environment.octree->leafCounts();
  std::cout << "\noctree     " << environment.octree->depth() << " levels, cells: " << leaves[0] << " free, "
            << leaves[1] << " mobile, " << leaves[2] << " static\n\nplaces (" << environment.options.identifier
            << ")\n";
  for (std::size_t i = 0; i < map.places.size(); ++i) {
    const std::string complexity = toText(semantics.ofPlace(i, "complexity").value);
    const bool cluttered = std::get<bool>(semantics.ofPlace(i, "cluttered").value);
    std::cout << "  " << std::left << std::setw(8) << semantics.placeName(i) << "complexity " << std::setw(3)
              << complexity << "narrowness " << std::setw(10) << map.places[i].narrowness << "compatibility "
              << std::setw(10) << std::get<double>(semantics.ofPlace(i, "compatibility").value)
              << (map.places[i].passage ? "passage " : "") << (cluttered ? "cluttered" : "") << "\n";
  }
  std::cout << "\nborders\n";
  for (const Border& border : map.borders) {
    std::cout << "  " << semantics.placeName(static_cast<std::size_t>(border.placeA)) << " - "
              << semantics.placeName(static_cast<std::size_t>(border.placeB)) << ", opening " << border.opening
              << " m2 at " << border.centre.transpose() << "\n";
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

void warnOfEdits(const LoadedScenario& scenario, const SceneKnowledge& knowledge) {
  Warnings warnings = editWarnings(knowledge.environment->map, semanticEditsOf(scenario.scenario));
  for (Diagnostic& warning : warnings) warning.file = scenario.file;
  reportWarnings(warnings);
}

}  // namespace glissade::cli
