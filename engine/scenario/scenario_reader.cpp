#include <set>

#include "engine/import/input_file.h"
#include "engine/scenario/json_cursor.h"
#include "engine/scenario/scenario_io.h"
#include "engine/scenario/scenario_migrations.h"

namespace glissade {
namespace {

/// Ids of assets or of bodies met so far.
using Ids = std::set<std::string>;

std::string readNewId(const JsonCursor& cursor, Ids& known) {
  const std::string id = cursor.nonEmptyText();
  if (id.find('/') != std::string::npos) cursor.fail("an id holds a '/'", "That is kept for the links of URDF files.");
  if (!known.insert(id).second) cursor.fail("the id '" + id + "' is there twice", "Give each its own id.");
  return id;
}

Asset readAsset(const JsonCursor& cursor, Ids& known) {
  cursor.allowOnly({"id", "path", "sha256", "unit", "up"});
  Asset asset;
  asset.id = readNewId(cursor.at("id"), known);
  const JsonCursor path = cursor.at("path");
  asset.path = path.nonEmptyText();
  if (!isRelativeInside(asset.path)) {
    path.fail("'" + asset.path + "' leaves the scenario's folder", "Give a path below it, with '/' between its parts.");
  }
  if (const auto hash = cursor.find("sha256")) {
    asset.sha256 = hash->text();
    const bool digits = asset.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!digits || asset.sha256.size() != 64) hash->fail("this is not 64 lower-case hexadecimal digits");
  }
  if (const auto unit = cursor.find("unit")) asset.interpretation.unit = unit->positiveNumber();
  if (const auto up = cursor.find("up")) asset.interpretation.up = up->oneOf({"y", "z"}) == 0 ? UpAxis::Y : UpAxis::Z;
  return asset;
}

std::string readAssetId(const JsonCursor& cursor, const Ids& assets) {
  const std::string id = cursor.text();
  if (assets.count(id) == 0) cursor.fail("there is no asset '" + id + "'", "Add it to the assets.");
  return id;
}

Geometry readGeometry(const JsonCursor& cursor, const Ids& assets) {
  const JsonCursor type = cursor.at("type");
  switch (type.oneOf({"mesh", "urdf", "box", "cylinder", "sphere"})) {
    case 0: cursor.allowOnly({"type", "asset"}); return MeshGeometry{readAssetId(cursor.at("asset"), assets)};
    case 1: cursor.allowOnly({"type", "asset"}); return UrdfGeometry{readAssetId(cursor.at("asset"), assets)};
    case 2: {
      cursor.allowOnly({"type", "size"});
      for (const JsonCursor& edge : cursor.at("size").elements(3)) edge.positiveNumber();
      return BoxGeometry{cursor.at("size").vector()};
    }
    case 3:
      cursor.allowOnly({"type", "radius", "length"});
      return CylinderGeometry{cursor.at("radius").positiveNumber(), cursor.at("length").positiveNumber()};
    default: cursor.allowOnly({"type", "radius"}); return SphereGeometry{cursor.at("radius").positiveNumber()};
  }
}

Colour readColour(const JsonCursor& cursor) {
  Colour colour{};
  const std::vector<JsonCursor> parts = cursor.elements(3);
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = parts[i].number();
    if (colour[i] < 0.0 || colour[i] > 1.0) parts[i].fail("this is not between 0 and 1");
  }
  return colour;
}

AttributeValue readAttribute(const JsonCursor& cursor) {
  if (cursor.json().is_boolean()) return cursor.boolean();
  if (cursor.json().is_number()) return cursor.number();
  if (cursor.json().is_string()) return cursor.text();
  cursor.fail("an attribute is a truth value, a number or a text");
}

template <class Described>
void readCommon(const JsonCursor& cursor, const Ids& assets, Described& described) {
  if (const auto name = cursor.find("name")) described.name = name->text();
  described.geometry = readGeometry(cursor.at("geometry"), assets);
  if (const auto colour = cursor.find("colour")) described.colour = readColour(*colour);
  if (const auto attributes = cursor.find("attributes")) {
    for (const auto& [key, value] : attributes->members()) described.attributes[key] = readAttribute(value);
  }
}

BodyDescription readBody(const JsonCursor& cursor, const Ids& assets, Ids& bodies) {
  cursor.allowOnly({"id", "name", "mobility", "geometry", "pose", "colour", "attributes"});
  BodyDescription body;
  body.id = readNewId(cursor.at("id"), bodies);
  readCommon(cursor, assets, body);
  if (const auto mobility = cursor.find("mobility")) {
    body.mobility = mobility->oneOf({"static", "mobile"}) == 0 ? Mobility::Static : Mobility::Mobile;
  }
  if (const auto pose = cursor.find("pose")) body.pose = pose->pose();
  return body;
}

ObjectDescription readObject(const JsonCursor& cursor, const Ids& assets, Ids& bodies) {
  cursor.allowOnly({"id", "name", "geometry", "centre_on_vertex_mean", "colour", "attributes"});
  ObjectDescription object;
  object.id = readNewId(cursor.at("id"), bodies);
  readCommon(cursor, assets, object);
  if (const auto centre = cursor.find("centre_on_vertex_mean")) {
    object.centreOnVertexMean = centre->boolean();
    const bool mesh = std::holds_alternative<MeshGeometry>(object.geometry);
    if (object.centreOnVertexMean && !mesh) centre->fail("only a mesh file can be centred on its vertices");
  }
  return object;
}

Goal readGoal(const JsonCursor& cursor) {
  if (!cursor.json().is_string()) return cursor.pose();
  cursor.oneOf({"out"});
  return GoalOut{};
}

Box3 readWorkspace(const JsonCursor& cursor) {
  cursor.allowOnly({"min", "max"});
  const Box3 box(cursor.at("min").vector(), cursor.at("max").vector());
  if (!(box.min().array() < box.max().array()).all()) cursor.fail("'min' is not below 'max' on every axis");
  return box;
}

std::map<ParameterId, double> readParameters(const JsonCursor& cursor) {
  std::map<ParameterId, double> parameters;
  for (const auto& [key, value] : cursor.members()) {
    const std::optional<ParameterId> id = parameterByKey(key);
    if (!id) value.fail("there is no parameter '" + key + "'", "See the parameters in the manual.");
    parameters[*id] = value.number();
  }
  return parameters;
}

void requireInside(const JsonCursor& cursor, const Pose& pose, const Box3& workspace) {
  if (!workspace.contains(pose.position)) {
    cursor.fail("this configuration is outside the workspace", "Enlarge the workspace or move the configuration.");
  }
}

Scenario readScenario(const JsonCursor& root) {
  root.allowOnly({"format", "version", "name", "description", "assets", "bodies", "object", "start", "goal",
                  "workspace", "way_points", "planner", "parameters", "seed"});
  Scenario scenario;
  Ids assets;
  Ids bodies;
  if (const auto name = root.find("name")) scenario.name = name->text();
  if (const auto description = root.find("description")) scenario.description = description->text();
  if (const auto list = root.find("assets")) {
    for (const JsonCursor& asset : list->elements()) scenario.assets.push_back(readAsset(asset, assets));
  }
  if (const auto list = root.find("bodies")) {
    for (const JsonCursor& body : list->elements()) scenario.bodies.push_back(readBody(body, assets, bodies));
  }
  scenario.object = readObject(root.at("object"), assets, bodies);
  scenario.workspace = readWorkspace(root.at("workspace"));
  scenario.start = root.at("start").pose();
  requireInside(root.at("start"), scenario.start, scenario.workspace);
  scenario.goal = readGoal(root.at("goal"));
  if (const Pose* goal = std::get_if<Pose>(&scenario.goal)) requireInside(root.at("goal"), *goal, scenario.workspace);
  if (const auto list = root.find("way_points")) {
    for (const JsonCursor& wayPoint : list->elements()) {
      scenario.wayPoints.push_back(wayPoint.pose());
      requireInside(wayPoint, scenario.wayPoints.back(), scenario.workspace);
    }
  }
  if (const auto planner = root.find("planner")) scenario.planner = planner->nonEmptyText();
  if (const auto parameters = root.find("parameters")) scenario.parameters = readParameters(*parameters);
  if (const auto seed = root.find("seed")) scenario.seed = seed->wholeNumber();
  return scenario;
}

}  // namespace

Result<Scenario> parseScenario(const std::string& text, const std::string& file) {
  Result<Json> document = parseJson(text, file);
  if (!document) return document.error();
  try {
    migrateScenario(*document);
    return readScenario(JsonCursor(*document));
  } catch (const JsonFailure& failure) {
    Diagnostic diagnostic = failure.diagnostic;
    diagnostic.file = file;
    return diagnostic;
  }
}

}  // namespace glissade
