#include "engine/files/part_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/base/printable_text.h"
#include "engine/files/object_geometry.h"
#include "engine/files/part_adder.h"
#include "engine/files/scenario_bodies.h"
#include "engine/import/asset_path.h"
#include "engine/import/geometry_loader.h"
#include "engine/import/mesh_import.h"
#include "engine/import/part_solids.h"
#include "engine/import/step_import.h"
#include "engine/import/step_parts.h"
#include "engine/import/unread_kind.h"

namespace glissade {
namespace {
namespace fs = std::filesystem;

/// A node of a part file that a body uses.
struct Claim {
  std::string path;
  std::string node;
};

std::vector<Claim> claimsOf(const Scenario& scenario, const std::string& scenarioFile) {
  std::vector<Claim> claims;
  const auto add = [&](const Geometry& geometry) {
    const auto* step = std::get_if<StepGeometry>(&geometry);
    const auto* mesh = std::get_if<MeshGeometry>(&geometry);
    if (step == nullptr && (mesh == nullptr || !mesh->groups)) return;
    for (const Asset& asset : scenario.assets) {
      if (asset.id != *assetOf(geometry)) continue;
      claims.push_back({assetFile(asset, folderOf(scenarioFile)), step != nullptr ? step->part : mesh->part});
    }
  };
  for (const BodyDescription* body : allBodiesOf(scenario)) add(body->geometry);
  return claims;
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code noneThere;
  return a == b || fs::equivalent(a, b, noneThere);
}

/// The entry, or somebody who says more exactly which part is meant.
bool isTaken(const std::string& name, const PartFile& by, const std::vector<Claim>& claims) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) {
    return claim.node.size() > by.part.size() && isWithin(name, claim.node) && isSameFile(claim.path, by.path);
  });
}

using Occurrences = std::vector<Occurrence>;

bool isOneOf(const Occurrences& shapes, const std::string& path) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const Occurrence& shape) { return shape.path == path; });
}

/// The shapes of the file: each part as one, or as its solids if one of them is named.
Occurrences shapesOf(const PartFile& named, const Occurrences& solids, const Occurrences& asOne,
                     const std::vector<Claim>& claims) {
  const auto isOpen = [&](const std::string& part) {
    return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) {
      return claim.node.size() > part.size() && isWithin(claim.node, part) && !isOneOf(asOne, claim.node) &&
             isSameFile(claim.path, named.path);
    });
  };
  std::set<std::string> opened;
  for (const Occurrence& solid : solids) {
    if (solid.isSolidOfPart && isOpen(partPathOf(solid))) opened.insert(partPathOf(solid));
  }
  return opened.empty() ? asOne : withPartsAsOne(solids, opened);
}

/// The names of the steps of a node, as in Occurrence::names.
std::vector<NodeNames> namesAt(const std::string& node, const Occurrences& places) {
  const auto below =
      std::find_if(places.begin(), places.end(), [&](const Occurrence& place) { return isWithin(place.path, node); });
  if (below == places.end() || below->names.empty()) return {};
  return {below->names.begin(), below->names.begin() + static_cast<std::ptrdiff_t>(stepsOf(node).size())};
}

/// One entry for each of the shapes that lies within the part that is named.
std::vector<PartFile> entriesOf(const PartFile& named, const Occurrences& shapes, const Occurrences& solids,
                                const std::vector<Claim>& claims) {
  std::vector<PartFile> entries;
  for (const Occurrence& shape : shapes) {
    if (!isWithin(shape.path, named.part) || isTaken(shape.path, named, claims)) continue;
    PartFile& entry = entries.emplace_back(named);
    entry.part = shape.path;
    entry.asOne = !isOneOf(solids, shape.path);
    entry.names = namesAt(shape.path, shapes);
  }
  return entries;
}

/// The parts with every STEP file that holds several, and does not move, as one entry a part. A part that is
/// named, or lies in an assembly that is named, by another entry or by the scenario is that one's. Names that
/// are short get their full form.
///
/// `scenarioFile` is where the scenario is saved, or empty; `read` takes what is read. Errors are those of the
/// importer, and that there is no part of a name.
Result<std::vector<PartFile>> oneEntryEach(const std::vector<PartFile>& parts, const Scenario& scenario,
                                           const std::string& scenarioFile, GeometryCache& read,
                                           const StopToken& stop) {
  std::vector<PartFile> named = parts;
  std::vector<Occurrences> solids(parts.size());
  std::vector<Occurrences> asOne(parts.size());
  std::vector<Claim> claims = claimsOf(scenario, scenarioFile);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!isCadFile(parts[i].path) && !parts[i].groups) continue;
    PartFile whole = parts[i];
    whole.part.clear();
    whole.asOne = false;
    const auto geometry = readPart(whole, read, stop);
    if (!geometry) return geometry.error();
    solids[i] = (*geometry)->parts;
    asOne[i] = withPartsAsOne(solids[i], std::set<std::string>());
    // A name is that of a part, as 'info' lists them, else that of a solid.
    auto node = nodeNamed(parts[i].part, treeOf(asOne[i]), parts[i].path);
    if (!node) node = nodeNamed(parts[i].part, treeOf(solids[i]), parts[i].path);
    if (!node) return node.error();
    const bool isJoined = isOneOf(asOne[i], *node) && !isOneOf(solids[i], *node);
    named[i].part = *node;
    named[i].names = namesAt(*node, isJoined ? asOne[i] : solids[i]);
    named[i].asOne = isJoined || std::any_of(solids[i].begin(), solids[i].end(), [&](const Occurrence& solid) {
                       return solid.isSolidOfPart && isWithin(partPathOf(solid), *node);
                     });
    claims.push_back({parts[i].path, *node});
  }
  std::vector<PartFile> entries;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const Occurrences shapes = shapesOf(named[i], solids[i], asOne[i], claims);
    if (named[i].role == PartRole::Moves || shapes.size() <= 1) {
      entries.push_back(named[i]);
      continue;
    }
    for (PartFile& entry : entriesOf(named[i], shapes, solids[i], claims)) entries.push_back(std::move(entry));
  }
  return entries;
}

namespace fs = std::filesystem;

Diagnostic usage(const std::string& file, const Message& reason, const Message& advice) {
  return {ErrorKind::Usage, file, "", reason, advice};
}

bool moves(const PartFile& part) { return part.role == PartRole::Moves; }

Outcome checkParts(const std::vector<PartFile>& parts) {
  if (parts.empty()) return usage("", GLISSADE_TEXT("there is no part"), GLISSADE_TEXT("Give the files of the parts."));
  for (const PartFile& part : parts) {
    if (limits::isSize(part.unit)) continue;
    return usage(part.path, GLISSADE_TEXT("has a unit that is not from 1e-12 m to 1e9 m"),
                 GLISSADE_TEXT("Give the metres in a unit of the file."));
  }
  return Done{};
}

/// Splits "product.step:pump/rotor", a part of a STEP file, or "product.obj:rotor", a group, unless a file has that
/// name. A file of a kind that is not read is split, too, so that its kind is said.
std::pair<std::string, std::string> splitPartName(const std::string& text) {
  std::error_code noneThere;
  for (std::size_t at = text.find(':'); at != std::string::npos; at = text.find(':', at + 1)) {
    const std::string file = text.substr(0, at);
    const bool mayHaveParts = isCadFile(file) || mayHaveGroups(file) || unreadKind(file);
    if (mayHaveParts && !fs::exists(text, noneThere)) return {file, text.substr(at + 1)};
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
  auto geometry = readPart(whole, read, stop);
  if (!geometry) return geometry.error();
  if (!apart && isCadFile(path) && !areSolidsOfOnePart((*geometry)->parts)) {
    whole.asOne = true;
    geometry = readPart(whole, read, stop);
    if (!geometry) return geometry.error();
  }
  if (!isCadFile(path) && !whole.groups) {
    const std::vector<Occurrence>& solids = (*geometry)->parts;
    return std::vector<MeasuredPart>{{"", boxOf(**geometry), solids.empty() ? Occurrence() : solids.front()}};
  }
  std::vector<MeasuredPart> parts;
  for (const Occurrence& part : (*geometry)->parts) {
    parts.push_back({part.path, boundingBox(*part.mesh, part.X_FP), part});
  }
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
    return usage("", GLISSADE_TEXT("no part is the moving part"), GLISSADE_TEXT("Choose the moving part."));
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
    return usage(moving->path, GLISSADE_TEXT("cannot be the moving part: the scenario has one"),
                 GLISSADE_TEXT("Make it static or mobile."));
  }
  GeometryCache known = read != nullptr ? *read : GeometryCache();
  const auto parts = oneEntryEach(files, scenario, scenarioFile, known, stop);
  if (!parts) return parts.error();
  if (parts->empty()) {
    return usage(files.front().path, GLISSADE_TEXT("has no part that the scenario does not have"),
                 GLISSADE_TEXT("Name the part to have it twice."));
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
