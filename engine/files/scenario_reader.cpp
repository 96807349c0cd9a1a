#include <array>
#include <set>

#include "engine/base/json_reader.h"
#include "engine/base/limits.h"
#include "engine/files/fits_json.h"
#include "engine/files/joints_json.h"
#include "engine/files/kept_path_json.h"
#include "engine/files/plan_json.h"
#include "engine/files/scenario_file.h"
#include "engine/files/semantics_json.h"
#include "engine/files/sequence_json.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

constexpr const char* kScenarioFormat = "glissade-scenario";
constexpr std::uint64_t kScenarioVersion = 1;

using Json = JsonCursor::Json;

/// Migrates a document to the next version; entry i migrates version i + 1. The list is empty, because version 1 is the
/// first.
using Migration = void (*)(Json&);
constexpr std::array<Migration, kScenarioVersion - 1> kMigrations{};

Colour readColour(const JsonCursor& at) {
  const Vector3 v = readVector(at);
  if (v.minCoeff() < 0.0 || v.maxCoeff() > 1.0) at.fail(GLISSADE_TEXT("is not a colour: three numbers from 0 to 1"));
  return {v.x(), v.y(), v.z()};
}

Asset readAsset(const JsonCursor& at) {
  at.allowOnly({"id", "path", "sha256", "unit", "up_axis", "deflection", "close_holes"});
  Asset asset;
  asset.id = at.at("id").nonEmptyText();
  asset.path = at.at("path").exactText();
  if (const auto hash = at.find("sha256")) asset.sha256 = hash->text();
  if (const auto unit = at.find("unit")) asset.unit = unit->length();
  if (const auto up = at.find("up_axis")) asset.up = up->named(kUpAxisNames);
  if (const auto deflection = at.find("deflection")) asset.deflection = deflection->length();
  if (const auto close = at.find("close_holes")) asset.closeHoles = close->boolean();
  return asset;
}

/// Exactly one of {"mesh": ...}, {"urdf": asset}, {"step": ...}, {"box": size}, {"cylinder": ...}, {"sphere": ...}.
Geometry readGeometry(const JsonCursor& at, const std::set<std::string>& assets) {
  at.allowOnly({"mesh", "urdf", "step", "box", "cylinder", "sphere"});
  if (at.json().size() != 1) at.fail(GLISSADE_TEXT("does not name exactly one shape"));
  const auto assetOf = [&](const JsonCursor& name) {
    const std::string id = name.text();
    if (assets.count(id) == 0)
      name.fail({GLISSADE_TEXT("names the asset '%1', which is not in /assets"), {id}},
                GLISSADE_TEXT("Add the asset."));
    return id;
  };
  if (const auto mesh = at.find("mesh")) {
    if (mesh->json().is_string()) return MeshGeometry{assetOf(*mesh)};
    mesh->allowOnly({"asset", "part"});
    return MeshGeometry{assetOf(mesh->at("asset")), true, mesh->has("part") ? mesh->at("part").nonEmptyText() : ""};
  }
  if (const auto urdf = at.find("urdf")) return UrdfGeometry{assetOf(*urdf)};
  if (const auto step = at.find("step")) {
    step->allowOnly({"asset", "part", "as_one"});
    return StepGeometry{assetOf(step->at("asset")), step->has("part") ? step->at("part").nonEmptyText() : "",
                        step->has("as_one") && step->at("as_one").boolean()};
  }
  if (const auto box = at.find("box")) {
    const Vector3 size = readVector(*box);
    if (!limits::isSize(size.minCoeff()))
      box->fail(GLISSADE_TEXT("has a size that is not above zero, or below 1e-12 m"));
    return BoxGeometry{size};
  }
  if (const auto cylinder = at.find("cylinder")) {
    cylinder->allowOnly({"radius", "length"});
    return CylinderGeometry{cylinder->at("radius").length(), cylinder->at("length").length()};
  }
  const JsonCursor sphere = at.at("sphere");
  sphere.allowOnly({"radius"});
  return SphereGeometry{sphere.at("radius").length()};
}

BodyDescription readDescription(const JsonCursor& at, const std::set<std::string>& assets) {
  BodyDescription body;
  body.id = at.at("id").nonEmptyText();
  body.name = at.has("name") ? at.at("name").text() : body.id;
  if (const auto mobility = at.find("mobility")) body.mobility = mobility->named(kMobilityNames);
  body.geometry = readGeometry(at.at("geometry"), assets);
  if (const auto colour = at.find("colour")) body.colour = readColour(*colour);
  body.attributes = readAttributes(at.find("attributes"));
  return body;
}

BodyDescription readBody(const JsonCursor& at, const std::set<std::string>& assets) {
  at.allowOnly({"id", "name", "mobility", "geometry", "pose", "colour", "attributes"});
  BodyDescription body = readDescription(at, assets);
  if (const auto pose = at.find("pose")) body.pose = readPose(*pose);
  return body;
}

ObjectDescription readObject(const JsonCursor& at, const std::set<std::string>& assets) {
  at.allowOnly({"id", "name", "mobility", "geometry", "with", "centre_on_vertex_mean", "reference_point", "colour",
                "attributes"});
  ObjectDescription object;
  object.first() = readDescription(at, assets);
  if (const auto with = at.find("with")) {
    for (std::size_t i = 0; i < with->sizeUpTo(limits::kMostBodies); ++i) {
      object.bodies.push_back(readBody(with->element(i), assets));
    }
  }
  if (const auto centre = at.find("centre_on_vertex_mean")) {
    object.centreOnVertexMean = centre->boolean();
    const bool mesh = std::holds_alternative<MeshGeometry>(object.first().geometry);
    if (object.centreOnVertexMean && !mesh) centre->fail(GLISSADE_TEXT("is for mesh files only"));
  }
  if (const auto point = at.find("reference_point")) {
    object.referencePoint = readVector(*point);
    if (object.centreOnVertexMean) point->fail(GLISSADE_TEXT("is said twice: there is 'centre_on_vertex_mean'"));
  }
  if (object.centreOnVertexMean && object.isGroup())
    at.at("with").fail(GLISSADE_TEXT("is not beside 'centre_on_vertex_mean'"));
  return object;
}

Goal readGoal(const JsonCursor& at) {
  if (!at.isString()) return readPose(at);
  if (at.text() != "out") at.fail(GLISSADE_TEXT("is neither a configuration nor \"out\""));
  return GoalOut{};
}

Box3 readWorkspace(const JsonCursor& at) {
  at.allowOnly({"min", "max"});
  const Box3 box(readVector(at.at("min")), readVector(at.at("max")));
  if (box.isEmpty()) at.fail(GLISSADE_TEXT("has a minimum above its maximum"));
  return box;
}

std::map<ParameterId, double> readParameters(const std::optional<JsonCursor>& at) {
  std::map<ParameterId, double> values;
  if (!at) return values;
  for (const auto& item : at->json().items()) {
    const auto id = parameterByKey(item.key());
    const JsonCursor value = at->at(item.key());
    if (!id) {
      value.fail(GLISSADE_TEXT("is not a parameter"), GLISSADE_TEXT("Remove it, or see 'glissade-cli plan --help'."));
    }
    values[*id] = value.number();
  }
  return values;
}

/// Ids are unique and leave "<body>/<link>" to the links of URDF files.
void checkId(std::set<std::string>& seen, const std::string& id, const JsonCursor& at) {
  if (id.find('/') != std::string::npos) at.at("id").fail(GLISSADE_TEXT("holds a '/'"), GLISSADE_TEXT("Leave it out."));
  if (!seen.insert(id).second)
    at.at("id").fail({GLISSADE_TEXT("has the id '%1' a second time"), {id}},
                     GLISSADE_TEXT("Give every one an id of its own."));
}

void checkIds(std::set<std::string>& seen, const ObjectDescription& object, const JsonCursor& at) {
  checkId(seen, object.first().id, at);
  for (std::size_t i = 1; i < object.bodies.size(); ++i) {
    checkId(seen, object.bodies[i].id, at.at("with").element(i - 1));
  }
}

std::vector<BodyDescription> readBodies(const JsonCursor& list, const std::set<std::string>& assets,
                                        std::set<std::string>& seen) {
  std::vector<BodyDescription> bodies;
  for (std::size_t i = 0; i < list.sizeUpTo(limits::kMostBodies); ++i) {
    bodies.push_back(readBody(list.element(i), assets));
    checkId(seen, bodies.back().id, list.element(i));
  }
  return bodies;
}

NodeDescription readNode(const JsonCursor& at) {
  at.allowOnly({"id", "name", "occurrence", "designator", "in", "attributes"});
  NodeDescription node;
  node.id = at.at("id").nonEmptyText();
  if (const auto name = at.find("name")) node.name = name->text();
  if (const auto occurrence = at.find("occurrence")) node.occurrence = occurrence->text();
  if (const auto designator = at.find("designator")) node.designator = designator->text();
  if (const auto in = at.find("in")) node.in = in->text();
  node.attributes = readAttributes(at.find("attributes"));
  return node;
}

std::vector<NodeDescription> readNodes(const JsonCursor& list) {
  std::vector<NodeDescription> nodes;
  for (std::size_t i = 0; i < list.sizeUpTo(limits::kMostBodies); ++i) nodes.push_back(readNode(list.element(i)));
  return nodes;
}

Scenario readScenario(const JsonCursor& root) {
  root.allowOnly({"format",     "version", "name",       "description",       "assets",  "bodies",     "object",
                  "start",      "goal",    "workspace",  "way_points",        "planner", "parameters", "environment",
                  "attributes", "places",  "milestones", "forbidden_regions", "rules",   "fits",       "sequence",
                  "seed",       "paths",   "plan",       "left_out",          "joints",  "product"});
  Scenario scenario;
  if (const auto name = root.find("name")) scenario.name = name->text();
  if (const auto description = root.find("description")) scenario.description = description->text();
  std::set<std::string> assets;
  const auto assetList = root.find("assets");
  for (std::size_t i = 0; assetList && i < assetList->sizeUpTo(limits::kMostBodies); ++i) {
    scenario.assets.push_back(readAsset(assetList->element(i)));
    checkId(assets, scenario.assets.back().id, assetList->element(i));
  }
  std::set<std::string> bodies;
  scenario.bodies = readBodies(root.at("bodies"), assets, bodies);
  scenario.object = readObject(root.at("object"), assets);
  checkIds(bodies, scenario.object, root.at("object"));
  if (const auto leftOut = root.find("left_out")) scenario.leftOut = readBodies(*leftOut, assets, bodies);
  if (const auto product = root.find("product")) scenario.nodes = readNodes(*product);
  scenario.start = readPose(root.at("start"));
  scenario.goal = readGoal(root.at("goal"));
  scenario.workspace = readWorkspace(root.at("workspace"));
  const auto wayPoints = root.find("way_points");
  for (std::size_t i = 0; wayPoints && i < wayPoints->size(); ++i) {
    scenario.wayPoints.push_back(readPose(wayPoints->element(i)));
  }
  if (const auto planner = root.find("planner")) scenario.planner = planner->nonEmptyText();
  scenario.parameters = readParameters(root.find("parameters"));
  if (const auto sequence = root.find("sequence")) scenario.sequence = readSequence(*sequence);
  readSemantics(root, scenario);
  if (const auto fits = root.find("fits")) scenario.fits = readFits(*fits);
  if (const auto joints = root.find("joints")) scenario.joints = readJointEdits(*joints);
  if (const auto seed = root.find("seed")) scenario.seed = seed->wholeNumber();
  if (const auto paths = root.find("paths")) scenario.paths = readKeptPaths(*paths);
  if (const auto plan = root.find("plan")) scenario.plan = std::make_shared<const AssemblyPlan>(readPlanJson(*plan));
  return scenario;
}

std::uint64_t readVersion(const JsonCursor& root) {
  if (root.at("format").text() != kScenarioFormat)
    root.at("format").fail({GLISSADE_TEXT("is not \"%1\""), {kScenarioFormat}});
  const JsonCursor at = root.at("version");
  const std::uint64_t version = at.wholeNumber();
  if (version < 1 || version > kScenarioVersion) {
    at.fail({GLISSADE_TEXT("is version %1; this program reads up to version %2"), {version, kScenarioVersion}},
            GLISSADE_TEXT("Use a newer Glissade."));
  }
  return version;
}

}  // namespace

Result<Scenario> parseScenario(const std::string& text, const std::string& file) {
  Warnings ignored;
  return parseScenario(text, file, ignored);
}

Result<Scenario> parseScenario(const std::string& text, const std::string& file, Warnings& warnings) {
  auto document = parseJson(text, file);
  if (!document) return document.error();
  if (takeChecksum(*document) == ChecksumState::Wrong) {
    warnings.push_back(
        wrongChecksum(file, GLISSADE_TEXT("Check the scenario, then save it again or remove the checksum.")));
  }
  try {
    const std::uint64_t version = readVersion(JsonCursor(*document, file, ""));
    for (std::size_t v = version - 1; v < kMigrations.size(); ++v) kMigrations[v](*document);
    return readScenario(JsonCursor(*document, file, ""));
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

}  // namespace glissade
