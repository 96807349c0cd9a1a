#include "engine/scenario/part_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "engine/base/file.h"
#include "engine/import/mesh_import.h"
#include "engine/scenario/asset_path.h"
#include "engine/scenario/geometry_loader.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

Diagnostic usage(const std::string& file, const std::string& reason, const std::string& advice) {
  return {ErrorKind::Usage, file, "", reason, advice};
}

bool moves(const PartFile& part) { return part.role == PartRole::Moves; }

Outcome checkParts(const std::vector<PartFile>& parts) {
  if (parts.empty()) return usage("", "there is no part", "Give the files of the parts.");
  for (const PartFile& part : parts) {
    if (std::isfinite(part.unit) && part.unit > 0.0) continue;
    return usage(part.path, "has a unit that is not above zero", "Give the metres in a unit of the file.");
  }
  return Done{};
}

std::string uniqueId(const std::string& stem, const std::set<std::string>& taken) {
  std::string id = stem;
  for (int number = 2; taken.count(id) > 0; ++number) id = stem + "-" + std::to_string(number);
  return id;
}

std::set<std::string> assetIds(const Scenario& scenario) {
  std::set<std::string> ids;
  for (const Asset& asset : scenario.assets) ids.insert(asset.id);
  return ids;
}

std::set<std::string> bodyIds(const Scenario& scenario) {
  std::set<std::string> ids{scenario.object.id};
  for (const BodyDescription& body : scenario.bodies) ids.insert(body.id);
  return ids;
}

/// Adds files and bodies to a scenario that is saved as `file`, or nowhere yet.
class PartAdder {
 public:
  PartAdder(Scenario& scenario, const std::string& file)
      : scenario_(scenario), folder_(folderOf(file)), saved_(!file.empty()) {}

  void addBody(const PartFile& part) {
    BodyDescription body;
    body.id = body.name = uniqueId(stemOf(part), bodyIds(scenario_));
    body.mobility = part.role == PartRole::Mobile ? Mobility::Mobile : Mobility::Static;
    body.geometry = geometryOf(part);
    scenario_.bodies.push_back(std::move(body));
  }

  void setObject(const PartFile& part) {
    ObjectDescription& object = scenario_.object;
    object.id = object.name = stemOf(part);
    object.geometry = geometryOf(part);
    object.centreOnVertexMean = !isUrdfFile(part.path);
  }

 private:
  static std::string stemOf(const PartFile& part) { return fs::path(part.path).stem().string(); }

  Geometry geometryOf(const PartFile& part) {
    if (isUrdfFile(part.path)) return UrdfGeometry{assetOf(part)};
    return MeshGeometry{assetOf(part)};
  }

  std::string assetOf(const PartFile& part) {
    const auto same = std::find_if(scenario_.assets.begin(), scenario_.assets.end(), [&](const Asset& asset) {
      std::error_code noneThere;
      return asset.unit == part.unit && asset.up == part.up &&
             fs::equivalent(assetFile(asset, folder_), part.path, noneThere);
    });
    if (same != scenario_.assets.end()) return same->id;
    const std::string path = fs::absolute(part.path).lexically_normal().generic_string();
    const std::string id = uniqueId(stemOf(part), assetIds(scenario_));
    scenario_.assets.push_back({id, saved_ ? assetPathFrom(folder_, path) : path, "", part.unit, part.up});
    return id;
  }

  Scenario& scenario_;
  std::string folder_;
  bool saved_;
};

/// Box of the bodies from the given one on.
Result<Box3> boxOfBodies(GeometryLoader& loader, const Scenario& scenario, std::size_t first) {
  Box3 box;
  for (std::size_t i = first; i < scenario.bodies.size(); ++i) {
    const auto geometry = loader.load(scenario.bodies[i].geometry);
    if (!geometry) return geometry.error();
    box.extend(boxOf(**geometry));
  }
  return box;
}

}  // namespace

bool isUrdfFile(const std::string& path) { return endingOf(path) == "urdf"; }

bool isPartFile(const std::string& path) { return isUrdfFile(path) || isMeshFile(path); }

PartFile usualPart(const std::string& path) {
  const std::string ending = endingOf(path);
  if (ending == "urdf") return {path, PartRole::Static, 1.0, UpAxis::Z};
  if (ending == "dae" || ending == "gltf" || ending == "glb") return {path, PartRole::Static, 1.0, UpAxis::Y};
  return {path, PartRole::Static, 0.001, UpAxis::Z};
}

Result<Box3> boxInFile(const std::string& path) {
  Scenario scenario;
  PartAdder(scenario, "").addBody({path, PartRole::Static, 1.0, UpAxis::Z});
  GeometryLoader loader(scenario, ".", path, {});
  return boxOfBodies(loader, scenario, 0);
}

Box3 roomAbout(const Box3& box, double radius) {
  const Vector3 margin = Vector3::Constant(2.0 * radius);
  return {box.min() - margin, box.max() + margin};
}

Box3 boxOfPart(const PartFile& part, const Box3& inFile) {
  TriangleMesh corners;
  corners.vertices = {inFile.min(), inFile.max()};
  return boundingBox(interpreted(corners, part.unit, part.up));
}

Result<Scenario> scenarioOfParts(const std::vector<PartFile>& parts, GeometryCache* read) {
  if (const Outcome sound = checkParts(parts); !sound) return sound.error();
  const auto moving = std::find_if(parts.begin(), parts.end(), moves);
  if (moving == parts.end()) return usage("", "no part moves", "Choose the part that moves.");
  if (const auto second = std::find_if(moving + 1, parts.end(), moves); second != parts.end()) {
    return usage(second->path, "is the second part that moves", "Choose one part that moves.");
  }
  Scenario scenario;
  PartAdder adder(scenario, "");
  adder.setObject(*moving);
  for (const PartFile& part : parts) {
    if (!moves(part)) adder.addBody(part);
  }
  GeometryLoader loader(scenario, ".", "", read != nullptr ? *read : GeometryCache());
  const auto object = loader.load(scenario.object.geometry);
  if (!object) return object.error();
  const auto bodies = boxOfBodies(loader, scenario, 0);
  if (!bodies) return bodies.error();
  if (read != nullptr) read->merge(loader.loaded());
  scenario.name = scenario.object.name;
  scenario.start = Pose::translation((*object)->vertexMean);
  scenario.goal = GoalOut{};
  scenario.workspace =
      roomAbout(bodies->merged(boxOf(**object)), radiusAboutOrigin(objectMesh(scenario.object, **object)));
  scenario.planner = "auto";
  return scenario;
}

Result<Scenario> withParts(Scenario scenario, const std::string& scenarioFile, const std::vector<PartFile>& parts,
                           GeometryCache* read) {
  if (const Outcome sound = checkParts(parts); !sound) return sound.error();
  if (const auto moving = std::find_if(parts.begin(), parts.end(), moves); moving != parts.end()) {
    return usage(moving->path, "cannot be what moves: the scenario has its object", "Make it static or mobile.");
  }
  const std::size_t before = scenario.bodies.size();
  PartAdder adder(scenario, scenarioFile);
  for (const PartFile& part : parts) adder.addBody(part);
  GeometryLoader loader(scenario, folderOf(scenarioFile), scenarioFile, read != nullptr ? *read : GeometryCache());
  const auto added = boxOfBodies(loader, scenario, before);
  if (!added) return added.error();
  const auto object = loader.load(scenario.object.geometry);
  if (!object) return object.error();
  if (read != nullptr) read->merge(loader.loaded());
  if (!std::holds_alternative<GoalOut>(scenario.goal)) return scenario;
  scenario.workspace.extend(roomAbout(*added, radiusAboutOrigin(objectMesh(scenario.object, **object))));
  return scenario;
}

}  // namespace glissade
