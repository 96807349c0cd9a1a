#include "engine/scenario/json_text.h"
#include "engine/scenario/scenario_format.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

Json toJson(const Asset& asset) {
  Json json{{"id", asset.id}, {"path", asset.path}};
  if (!asset.sha256.empty()) json["sha256"] = asset.sha256;
  json["unit"] = asset.interpretation.unit;
  json["up"] = asset.interpretation.up == UpAxis::Y ? "y" : "z";
  return json;
}

struct GeometryWriter {
  Json operator()(const MeshGeometry& mesh) const { return {{"type", "mesh"}, {"asset", mesh.asset}}; }
  Json operator()(const UrdfGeometry& urdf) const { return {{"type", "urdf"}, {"asset", urdf.asset}}; }
  Json operator()(const BoxGeometry& box) const { return {{"type", "box"}, {"size", glissade::toJson(box.size)}}; }
  Json operator()(const CylinderGeometry& cylinder) const {
    return {{"type", "cylinder"}, {"radius", cylinder.radius}, {"length", cylinder.length}};
  }
  Json operator()(const SphereGeometry& sphere) const { return {{"type", "sphere"}, {"radius", sphere.radius}}; }
};

/// What bodies and the object have alike, after their geometry.
template <class Described>
void addLooksAndMeaning(Json& json, const Described& described) {
  if (described.colour) json["colour"] = *described.colour;
  if (described.attributes.empty()) return;
  Json& attributes = json["attributes"] = Json::object();
  for (const auto& [key, value] : described.attributes) {
    std::visit([&, name = key](const auto& content) { attributes[name] = content; }, value);
  }
}

Json toJson(const BodyDescription& body) {
  Json json{{"id", body.id}};
  if (!body.name.empty()) json["name"] = body.name;
  json["mobility"] = body.mobility == Mobility::Mobile ? "mobile" : "static";
  json["geometry"] = std::visit(GeometryWriter{}, body.geometry);
  json["pose"] = toJson(body.pose);
  addLooksAndMeaning(json, body);
  return json;
}

Json toJson(const ObjectDescription& object) {
  Json json{{"id", object.id}};
  if (!object.name.empty()) json["name"] = object.name;
  json["geometry"] = std::visit(GeometryWriter{}, object.geometry);
  if (object.centreOnVertexMean) json["centre_on_vertex_mean"] = true;
  addLooksAndMeaning(json, object);
  return json;
}

template <class Values>
Json toList(const Values& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(toJson(value));
  return list;
}

}  // namespace

std::string writeScenario(const Scenario& scenario) {
  Json json{{"format", scenario_format::kName}, {"version", scenario_format::kVersion}, {"name", scenario.name}};
  if (!scenario.description.empty()) json["description"] = scenario.description;
  json["assets"] = toList(scenario.assets);
  json["bodies"] = toList(scenario.bodies);
  json["object"] = toJson(scenario.object);
  json["start"] = toJson(scenario.start);
  const Pose* goal = std::get_if<Pose>(&scenario.goal);
  json["goal"] = goal ? toJson(*goal) : Json("out");
  json["workspace"] = {{"min", toJson(scenario.workspace.min())}, {"max", toJson(scenario.workspace.max())}};
  if (!scenario.wayPoints.empty()) json["way_points"] = toList(scenario.wayPoints);
  json["planner"] = scenario.planner;
  json["parameters"] = Json::object();
  for (const auto& [id, value] : scenario.parameters) json["parameters"][std::string(specOf(id).key)] = value;
  json["seed"] = scenario.seed;
  return canonicalText(json);
}

}  // namespace glissade
