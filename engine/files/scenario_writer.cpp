#include "engine/base/json_reader.h"
#include "engine/base/overloaded.h"
#include "engine/files/fits_json.h"
#include "engine/files/joints_json.h"
#include "engine/files/kept_path_json.h"
#include "engine/files/plan_file.h"
#include "engine/files/scenario_file.h"
#include "engine/files/semantics_json.h"
#include "engine/files/sequence_json.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

Json toJson(const Asset& asset) {
  Json json;
  json["id"] = asset.id;
  json["path"] = asset.path;
  if (!asset.sha256.empty()) json["sha256"] = asset.sha256;
  json["unit"] = asset.unit;
  json["up_axis"] = kUpAxisNames.of(asset.up);
  if (asset.deflection > 0.0) json["deflection"] = asset.deflection;
  if (asset.closeHoles) json["close_holes"] = true;
  return json;
}

Json toJson(const Geometry& geometry) {
  return std::visit(Overloaded{[](const MeshGeometry& mesh) -> Json {
                                 if (!mesh.groups) return {{"mesh", mesh.asset}};
                                 Json json;
                                 json["asset"] = mesh.asset;
                                 if (!mesh.part.empty()) json["part"] = mesh.part;
                                 return {{"mesh", json}};
                               },
                               [](const UrdfGeometry& urdf) -> Json {
                                 return {{"urdf", urdf.asset}};
                               },
                               [](const StepGeometry& step) -> Json {
                                 Json json;
                                 json["asset"] = step.asset;
                                 if (!step.part.empty()) json["part"] = step.part;
                                 if (step.asOne) json["as_one"] = true;
                                 return {{"step", json}};
                               },
                               [](const BoxGeometry& box) -> Json {
                                 return {{"box", glissade::toJson(box.size)}};
                               },
                               [](const CylinderGeometry& cylinder) -> Json {
                                 return {{"cylinder", {{"radius", cylinder.radius}, {"length", cylinder.length}}}};
                               },
                               [](const SphereGeometry& sphere) -> Json {
                                 return {{"sphere", {{"radius", sphere.radius}}}};
                               }},
                    geometry);
}

void addAppearance(Json& json, const std::optional<Colour>& colour, const Attributes& attributes) {
  if (colour) json["colour"] = *colour;
  if (!attributes.empty()) json["attributes"] = attributesToJson(attributes);
}

Json toJson(const BodyDescription& body) {
  Json json;
  json["id"] = body.id;
  json["name"] = body.name;
  json["mobility"] = kMobilityNames.of(body.mobility);
  json["geometry"] = toJson(body.geometry);
  json["pose"] = glissade::toJson(body.pose);
  addAppearance(json, body.colour, body.attributes);
  return json;
}

Json toJson(const NodeDescription& node) {
  Json json{{"id", node.id}};
  if (node.name) json["name"] = *node.name;
  if (!node.occurrence.empty()) json["occurrence"] = node.occurrence;
  if (!node.designator.empty()) json["designator"] = node.designator;
  if (node.in) json["in"] = *node.in;
  if (!node.attributes.empty()) json["attributes"] = attributesToJson(node.attributes);
  return json;
}

template <class Range>
Json itemList(const Range& range) {
  Json json = Json::array();
  for (const auto& item : range) json.push_back(toJson(item));
  return json;
}

Json toJson(const ObjectDescription& object) {
  const BodyDescription& first = object.first();
  Json json;
  json["id"] = first.id;
  json["name"] = first.name;
  if (first.mobility == Mobility::Mobile) json["mobility"] = kMobilityNames.of(first.mobility);
  json["geometry"] = toJson(first.geometry);
  if (object.isGroup()) {
    json["with"] = itemList(std::vector<BodyDescription>(object.bodies.begin() + 1, object.bodies.end()));
  }
  if (object.centreOnVertexMean) json["centre_on_vertex_mean"] = true;
  if (!object.referencePoint.isZero(0.0)) json["reference_point"] = glissade::toJson(object.referencePoint);
  addAppearance(json, first.colour, first.attributes);
  return json;
}

Json scenarioJson(const Scenario& scenario) {
  Json json;
  json["format"] = "glissade-scenario";
  json["version"] = 1;
  json["name"] = scenario.name;
  json["description"] = scenario.description;
  json["assets"] = itemList(scenario.assets);
  json["bodies"] = itemList(scenario.bodies);
  json["object"] = toJson(scenario.object);
  if (!scenario.leftOut.empty()) json["left_out"] = itemList(scenario.leftOut);
  if (!scenario.nodes.empty()) json["product"] = itemList(scenario.nodes);
  json["start"] = glissade::toJson(scenario.start);
  const Pose* goal = std::get_if<Pose>(&scenario.goal);
  json["goal"] = goal != nullptr ? glissade::toJson(*goal) : Json("out");
  json["workspace"] = {{"min", glissade::toJson(Vector3(scenario.workspace.min()))},
                       {"max", glissade::toJson(Vector3(scenario.workspace.max()))}};
  json["way_points"] = itemList(scenario.wayPoints);
  json["planner"] = scenario.planner;
  json["parameters"] = Json::object();
  for (const auto& [id, value] : scenario.parameters) json["parameters"][std::string(specOf(id).key)] = value;
  addSemantics(scenario, json);
  addFits(scenario.fits, json);
  addJointEdits(scenario.joints, json);
  addSequence(scenario.sequence, json);
  json["seed"] = scenario.seed;
  addKeptPaths(scenario.paths, json);
  if (scenario.plan) json["plan"] = planJson(*scenario.plan, scenario.name);
  return json;
}

std::string textOf(const Json& json) { return jsonText(json, 2) + "\n"; }

}  // namespace

std::string scenarioText(const Scenario& scenario) { return textOf(scenarioJson(scenario)); }

std::string writeScenario(const Scenario& scenario) {
  Json json = scenarioJson(scenario);
  addChecksum(json);
  return textOf(json);
}

}  // namespace glissade
