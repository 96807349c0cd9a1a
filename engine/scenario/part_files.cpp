#include "engine/scenario/part_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/base/printable_text.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/mesh_import.h"
#include "engine/import/step_import.h"
#include "engine/scenario/object_geometry.h"
#include "engine/scenario/part_adder.h"
#include "engine/scenario/part_expansion.h"
#include "engine/scenario/scenario_bodies.h"

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
    if (limits::isSize(part.unit)) continue;
    return usage(part.path, "has a unit that is not from 1e-12 m to 1e9 m", "Give the metres in a unit of the file.");
  }
  return Done{};
}

/// Splits "product.step:pump/rotor", a part of a STEP file, or "product.obj:rotor", a group, unless a file has that
/// name.
std::pair<std::string, std::string> splitPartName(const std::string& text) {
  std::error_code noneThere;
  for (std::size_t at = text.find(':'); at != std::string::npos; at = text.find(':', at + 1)) {
    const std::string file = text.substr(0, at);
    if ((isCadFile(file) || mayHaveGroups(file)) && !fs::exists(text, noneThere)) return {file, text.substr(at + 1)};
  }
  return {text, ""};
}

void takeRead(GeometryLoader& loader, GeometryCache& read) {
  read.insert(loader.files().begin(), loader.files().end());
  read.merge(loader.loaded());
}

/// Bounding box of the bodies from index `first` on.
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

bool mayHaveGroups(const std::string& path) { return endingOf(path) == "obj"; }

bool isUrdfFile(const std::string& path) { return endingOf(path) == "urdf"; }

bool saysItsUnit(const std::string& path) { return isUrdfFile(path) || isCadFile(path); }

bool saysNoUnit(const std::string& path) {
  const std::string ending = endingOf(path);
  return ending == "stl" || ending == "obj" || ending == "ply";
}

bool isPartFile(const std::string& path) { return saysItsUnit(path) || isMeshFile(path); }

PartFile usualPart(const std::string& text) {
  const auto [path, part] = splitPartName(text);
  const std::string ending = endingOf(path);
  PartFile usual{path, PartRole::Static, 0.001, UpAxis::Z, part};
  if (saysItsUnit(path)) usual.unit = 1.0;
  usual.groups = mayHaveGroups(path) && !part.empty();
  usual.asOne = isCadFile(path);
  if (ending == "dae" || ending == "gltf" || ending == "glb") {
    usual.unit = 1.0;
    usual.up = UpAxis::Y;
  }
  return usual;
}

Result<LoadedGeometryPtr> readPart(const PartFile& part, GeometryCache& read, const StopToken& stop,
                                   Warnings* warnings) {
  Scenario scenario;
  PartAdder(scenario, "").addBody(part);
  GeometryLoader loader(scenario.assets, ".", part.path, &read, stop);
  auto geometry = loader.load(scenario.bodies.front().geometry);
  if (geometry) takeRead(loader, read);
  if (warnings != nullptr) warnings->insert(warnings->end(), loader.warnings().begin(), loader.warnings().end());
  return geometry;
}

void readSmallFiles(const std::vector<std::string>& paths, GeometryCache& read, const StopToken& stop) {
  std::vector<Asset> assets;
  std::vector<Geometry> meshes;
  for (const std::string& path : paths) {
    if (!isMeshFile(path)) continue;
    assets.push_back({path, fs::absolute(path).lexically_normal().generic_string(), ""});
    meshes.emplace_back(MeshGeometry{path});
  }
  std::vector<const Geometry*> expected;
  for (const Geometry& mesh : meshes) expected.push_back(&mesh);
  GeometryLoader loader(assets, ".", "", &read, stop);
  loader.expect(expected);
  takeRead(loader, read);
}

Result<std::vector<MeasuredPart>> partsInFile(const std::string& path, GeometryCache& read, const StopToken& stop,
                                              bool apart) {
  PartFile whole{path, PartRole::Static, 1.0, UpAxis::Z};
  whole.groups = apart && mayHaveGroups(path);
  whole.asOne = !apart && isCadFile(path);
  const auto geometry = readPart(whole, read, stop);
  if (!geometry) return geometry.error();
  if (!isCadFile(path) && !whole.groups) return std::vector<MeasuredPart>{{"", boxOf(**geometry)}};
  std::vector<MeasuredPart> parts;
  for (const Occurrence& part : (*geometry)->parts) parts.push_back({part.path, boundingBox(*part.mesh, part.X_FP)});
  return parts;
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

Result<Scenario> scenarioOfParts(const std::vector<PartFile>& files, GeometryCache* read, const StopToken& stop) {
  if (const Outcome sound = checkParts(files); !sound) return sound.error();
  GeometryCache known = read != nullptr ? *read : GeometryCache();
  const auto entries = oneEntryEach(files, Scenario(), "", known, stop);
  if (!entries) return entries.error();
  const std::vector<PartFile>& parts = *entries;
  if (std::none_of(parts.begin(), parts.end(), moves)) {
    return usage("", "no part moves", "Choose the part that moves.");
  }
  Scenario scenario;
  PartAdder adder(scenario, "");
  for (const PartFile& part : parts) {
    if (moves(part)) adder.addToObject(part);
  }
  for (const PartFile& part : parts) {
    if (!moves(part)) adder.addBody(part);
  }
  GeometryLoader loader(scenario.assets, ".", "", &known, stop);
  loader.expect(geometriesOf(scenario));
  ObjectDescription& object = scenario.object;
  const auto geometry = loadGeometryOf(object, loader);
  if (!geometry) return geometry.error();
  const auto bodies = boxOfBodies(loader, scenario, 0);
  if (!bodies) return bodies.error();
  loader.noteHashes(scenario.assets);
  if (read != nullptr) takeRead(loader, *read);
  if (scenario.assets.size() == 1) scenario.name = printableLine(fs::path(files.front().path).stem().string());
  chooseReferencePoint(object, *geometry);
  scenario.start = Pose::translation(referencePointOf(object, *geometry));
  scenario.goal = GoalOut{};
  scenario.workspace =
      roomAbout(bodies->merged(boxOf(object, *geometry)), radiusAboutOrigin(objectMesh(object, *geometry)));
  scenario.planner = "auto";
  scenario.fits.on = true;
  return scenario;
}

Result<Scenario> withParts(Scenario scenario, const std::string& scenarioFile, const std::vector<PartFile>& files,
                           GeometryCache* read, const StopToken& stop) {
  if (const Outcome sound = checkParts(files); !sound) return sound.error();
  if (const auto moving = std::find_if(files.begin(), files.end(), moves); moving != files.end()) {
    return usage(moving->path, "cannot be what moves: the scenario has its object", "Make it static or mobile.");
  }
  GeometryCache known = read != nullptr ? *read : GeometryCache();
  const auto parts = oneEntryEach(files, scenario, scenarioFile, known, stop);
  if (!parts) return parts.error();
  if (parts->empty()) {
    return usage(files.front().path, "has no part that the scenario does not have", "Name the part to have it twice.");
  }
  const std::size_t before = scenario.bodies.size();
  PartAdder adder(scenario, scenarioFile);
  for (const PartFile& part : *parts) adder.addBody(part);
  GeometryLoader loader(scenario.assets, folderOf(scenarioFile), scenarioFile, &known, stop);
  loader.expect(geometriesOf(scenario));
  const auto added = boxOfBodies(loader, scenario, before);
  if (!added) return added.error();
  const auto geometry = loadGeometryOf(scenario.object, loader);
  if (!geometry) return geometry.error();
  loader.noteHashes(scenario.assets);
  if (read != nullptr) takeRead(loader, *read);
  if (!std::holds_alternative<GoalOut>(scenario.goal)) return scenario;
  scenario.workspace.extend(roomAbout(*added, radiusAboutOrigin(objectMesh(scenario.object, *geometry))));
  return scenario;
}

}  // namespace glissade
