#include "engine/import/geometry_loader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/base/overloaded.h"
#include "engine/geometry/mesh_edges.h"
#include "engine/geometry/primitives.h"
#include "engine/geometry/t_junctions.h"
#include "engine/import/asset_path.h"
#include "engine/import/cad_kind.h"
#include "engine/import/hole_closing.h"
#include "engine/import/import_limits.h"
#include "engine/import/mesh_import.h"
#include "engine/import/part_solids.h"
#include "engine/import/small_meshes.h"
#include "engine/import/step_import.h"
#include "engine/import/step_parts.h"
#include "engine/import/urdf_import.h"
#include "engine/model/unique_names.h"

namespace glissade {
namespace {

LoadedGeometry single(TriangleMesh mesh) {
  LoadedGeometry geometry;
  geometry.parts.push_back({"", std::make_shared<const TriangleMesh>(std::move(mesh)), Pose::identity(), std::nullopt});
  return geometry;
}

}  // namespace

const std::string* assetOf(const Geometry& geometry) {
  return std::visit(
      [](const auto& of) -> const std::string* {
        if constexpr (requires { of.asset; }) {
          return &of.asset;
        } else {
          return nullptr;
        }
      },
      geometry);
}

namespace {

const Asset& assetById(const std::string& id, const std::vector<Asset>& assets) {
  return *std::find_if(assets.begin(), assets.end(), [&](const Asset& a) { return a.id == id; });
}

/// Null if the geometry is not in the cache, or if there is no cache.
LoadedGeometryPtr found(const std::string& key, const GeometryCache* cache) {
  if (cache == nullptr) return nullptr;
  const auto known = cache->find(key);
  return known == cache->end() ? nullptr : known->second;
}

/// Warns of triangles with two equal corners, which bound nothing and were left out.
void warnOfRemovedTriangles(std::size_t count, const std::string& file, Warnings& warnings) {
  if (count == 0) return;
  warnings.push_back({ErrorKind::MalformedInput,
                      file,
                      "",
                      {GLISSADE_TEXT("has %1 {1|triangle with two equal corners, which was|triangles with two equal "
                                     "corners, which were} left out"),
                       {count}},
                      GLISSADE_TEXT("They have no area, so that no surface is missing.")});
}

/// Warns that the surface was changed, and by how little.
void warnOfTJunctions(const ClosedAtTJunctions& closed, const std::string& file, Warnings& warnings) {
  warnings.push_back(
      {ErrorKind::MalformedInput,
       file,
       "",
       {GLISSADE_TEXT("was closed along %1 {1|edge|edges} on which vertices of neighbouring faces lie (T-junctions)"),
        {closed.edges}},
       {GLISSADE_TEXT("The surface has moved by at most %1 micrometres."), {std::ceil(1e8 * closed.moved) / 1e2}}});
}

/// Closes planar holes, with a warning.
TriangleMesh withoutHoles(const TriangleMesh& mesh, const std::string& file, Warnings& warnings) {
  ClosedHoles closed = withPlanarHolesClosed(mesh);
  if (closed.closed + closed.left == 0) return mesh;
  warnings.push_back({ErrorKind::MalformedInput,
                      file,
                      "",
                      {GLISSADE_TEXT("had %1 planar {1|hole, which was|holes, which were} closed as asked for; %2 "
                                     "{2|hole is|holes are} left open"),
                       {closed.closed, closed.left}},
                      GLISSADE_TEXT("Look at them: what is behind a closed hole is solid.")});
  return std::move(closed.mesh);
}

/// The only part of a file has no path.
void leaveSingleUnnamed(std::vector<Occurrence>& parts) {
  if (parts.size() != 1) return;
  parts.front().path.clear();
  parts.front().names.clear();
}

/// Hash of the file's bytes; if the file names other files for its parts, the hash of all their hashes and names.
std::string hashOf(const FileContent& content, const StepProduct& product) {
  std::string hash = sha256(content.bytes);
  if (product.partFiles.empty()) return hash;
  for (const StepPartFile& file : product.partFiles) hash += "\n" + file.sha256 + " " + file.name;
  return sha256(hash);
}

}  // namespace

std::string geometryKey(const Geometry& geometry, const std::vector<Asset>& assets, const std::string& folder) {
  const auto ofAsset = [&](const std::string& kind, const std::string& id) {
    const Asset& asset = assetById(id, assets);
    return kind + (asset.closeHoles ? " closed " : " ") + toText(asset.unit) + (asset.up == UpAxis::Y ? " y " : " z ") +
           withoutLinks(assetFile(asset, folder));
  };
  return std::visit(Overloaded{[&](const MeshGeometry& mesh) {
                                 return ofAsset(mesh.groups || !mesh.part.empty() ? "groups" : "mesh", mesh.asset) +
                                        (mesh.part.empty() ? "" : " : " + mesh.part);
                               },
                               [&](const UrdfGeometry& urdf) { return ofAsset("urdf", urdf.asset); },
                               [&](const StepGeometry& step) {
                                 const double deflection = assetById(step.asset, assets).deflection;
                                 return ofAsset("step " + toText(deflection), step.asset) +
                                        (step.part.empty() ? "" : " : " + step.part) + (step.asOne ? " as one" : "");
                               },
                               [](const BoxGeometry& box) {
                                 return "box " + toText(box.size.x()) + " " + toText(box.size.y()) + " " +
                                        toText(box.size.z());
                               },
                               [](const CylinderGeometry& cylinder) {
                                 return "cylinder " + toText(cylinder.radius) + " " + toText(cylinder.length);
                               },
                               [](const SphereGeometry& sphere) { return "sphere " + toText(sphere.radius); }},
                    geometry);
}

GeometryLoader::GeometryLoader(const std::vector<Asset>& assets, std::string folder, std::string file,
                               const GeometryCache* known, StopToken stop)
    : assets_(assets), folder_(std::move(folder)), file_(std::move(file)), known_(known), stop_(std::move(stop)) {}

namespace {

/// The part of a file that a geometry names; empty: all parts. Nothing: it names no file with several parts.
std::optional<std::string> partNamedBy(const Geometry& geometry) {
  if (const auto* step = std::get_if<StepGeometry>(&geometry)) return step->part;
  const auto* mesh = std::get_if<MeshGeometry>(&geometry);
  return mesh != nullptr && !mesh->part.empty() ? std::optional(mesh->part) : std::nullopt;
}

/// The geometry of all parts of the file of a named part.
Geometry wholeFileOf(const Geometry& geometry) {
  const std::string& asset = *assetOf(geometry);
  if (std::holds_alternative<StepGeometry>(geometry)) return StepGeometry{asset, ""};
  return MeshGeometry{asset, true};
}

}  // namespace

Result<LoadedGeometryPtr> GeometryLoader::load(const Geometry& geometry) {
  const std::string key = geometryKey(geometry, assets_, folder_);
  LoadedGeometryPtr& loaded = loaded_[key];
  if (!loaded) {
    loaded = found(key, known_);
    if (loaded && partNamedBy(geometry)) keepWholeFileOf(geometry);
  }
  if (!loaded) {
    auto read = this->read(geometry);
    if (!read) return read.error();
    loaded = std::make_shared<const LoadedGeometry>(std::move(*read));
  }
  if (const std::string* asset = assetOf(geometry)) hashes_[*asset] = loaded->sha256;
  takeWarnings(*loaded);
  return loaded;
}

/// Keeps the whole file of a part: its unnamed parts are missing shapes, even if nothing is read again.
void GeometryLoader::keepWholeFileOf(const Geometry& geometry) {
  const std::string key = geometryKey(wholeFileOf(geometry), assets_, folder_);
  if (LoadedGeometryPtr whole = found(key, known_)) loaded_[key] = std::move(whole);
}

/// Takes each warning once, even if it was read before and several bodies have it.
void GeometryLoader::takeWarnings(const LoadedGeometry& geometry) {
  for (const Diagnostic& warning : geometry.warnings) {
    const bool known = std::any_of(warnings_.begin(), warnings_.end(), [&](const Diagnostic& other) {
      return other.file == warning.file && other.location == warning.location && other.reason == warning.reason;
    });
    if (!known) warnings_.push_back(warning);
  }
}

void GeometryLoader::noteHashes(std::vector<Asset>& assets) const {
  for (Asset& asset : assets) {
    const auto found = hashes_.find(asset.id);
    if (found != hashes_.end()) asset.sha256 = found->second;
  }
}

Result<LoadedGeometry> GeometryLoader::read(const Geometry& geometry) {
  using Read = Result<LoadedGeometry>;
  return std::visit(
      Overloaded{[this](const MeshGeometry& mesh) -> Read {
                   if (!mesh.part.empty()) return partOf(mesh.asset, mesh.part, MeshGeometry{mesh.asset, true}, false);
                   return readMesh(assetById(mesh.asset, assets_), mesh.groups);
                 },
                 [this](const UrdfGeometry& urdf) -> Read { return readUrdf(assetById(urdf.asset, assets_)); },
                 [this](const StepGeometry& step) -> Read {
                   if (step.part.empty() && !step.asOne) return readStep(assetById(step.asset, assets_));
                   return partOf(step.asset, step.part, StepGeometry{step.asset, ""}, step.asOne);
                 },
                 [](const BoxGeometry& box) -> Read { return single(makeBox(box.size)); },
                 [](const CylinderGeometry& cylinder) -> Read {
                   return single(makeCylinder(cylinder.radius, cylinder.length));
                 },
                 [](const SphereGeometry& sphere) -> Read { return single(makeSphere(sphere.radius)); }},
      geometry);
}

namespace {

/// Key of a mesh file in a GeometryCache without unit and axis.
std::string fileKey(const Asset& asset, const std::string& folder) {
  return "file:" + withoutLinks(assetFile(asset, folder));
}

LoadedGeometryPtr asItIs(ImportedMesh imported, const std::string& hash) {
  LoadedGeometry raw = single(std::move(imported.mesh));
  raw.parts.front().coordinateSpacing = imported.coordinateSpacing;
  raw.vertexMean = imported.vertexMean;
  raw.warnings = std::move(imported.warnings);
  raw.groups = std::move(imported.groups);
  raw.sha256 = hash;
  return std::make_shared<const LoadedGeometry>(std::move(raw));
}

ImportedMesh meshOf(const LoadedGeometry& raw) {
  const Occurrence& part = raw.parts.front();
  return {*part.mesh, raw.vertexMean, part.coordinateSpacing, raw.warnings, raw.groups};
}

/// Small mesh files, by their keys.
std::map<std::string, std::string> smallFiles(const std::vector<const Geometry*>& geometries,
                                              const std::vector<Asset>& assets, const std::string& folder,
                                              const GeometryCache* known) {
  std::map<std::string, std::string> files;
  for (const Geometry* geometry : geometries) {
    const auto* mesh = std::get_if<MeshGeometry>(geometry);
    if (mesh == nullptr || found(geometryKey(*geometry, assets, folder), known)) continue;
    const Asset& asset = assetById(mesh->asset, assets);
    const std::string file = assetFile(asset, folder);
    const std::string key = fileKey(asset, folder);
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
    if (!unknown && isSmallMesh(file, bytes) && !found(key, known)) files.emplace(key, file);
  }
  return files;
}

}  // namespace

void GeometryLoader::expect(const std::vector<const Geometry*>& geometries) {
  constexpr std::size_t kFilesAtOnce = 512;
  const auto files = smallFiles(geometries, assets_, folder_, known_);
  if (files.size() < 2) return;
  for (auto next = files.begin(); next != files.end() && !stop_.stopRequested();) {
    std::vector<FileContent> contents;
    std::vector<std::string> keys;
    for (; next != files.end() && contents.size() < kFilesAtOnce; ++next) {
      auto content = readContent(next->second, mostFileBytes());
      if (!content) continue;
      keys.push_back(next->first);
      contents.push_back(std::move(*content));
    }
    auto meshes = importSmallMeshes(contents, stop_);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      if (meshes[i]) files_[keys[i]] = asItIs(std::move(*meshes[i]), sha256(contents[i].bytes));
    }
  }
}

/// The mesh of a file without unit and axis. Meshes of small files are kept.
Result<ImportedMesh> GeometryLoader::importFile(const Asset& asset) {
  const std::string key = fileKey(asset, folder_);
  LoadedGeometryPtr raw = found(key, &files_);
  if (!raw) raw = found(key, known_);
  if (raw) {
    noteHash(asset, assetFile(asset, folder_), raw->sha256);
    return meshOf(*raw);
  }
  const auto content = readAsset(asset);
  if (!content) return content.error();
  auto imported = importMesh(*content, stop_);
  if (imported && isSmallMesh(content->file, content->bytes.size())) files_[key] = asItIs(*imported, hashes_[asset.id]);
  return imported;
}

/// Reads the file of an asset, once.
Result<FileContent> GeometryLoader::readAsset(const Asset& asset) {
  auto content = readContent(assetFile(asset, folder_), mostFileBytes());
  if (content) noteHash(asset, content->file, sha256(content->bytes));
  return content;
}

/// Warns if the content differs from that with which the scenario was saved.
void GeometryLoader::noteHash(const Asset& asset, const std::string& file, const std::string& hash) {
  hashes_[asset.id] = hash;
  if (asset.sha256.empty() || hash == asset.sha256) return;
  warnings_.push_back({ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("has changed since the scenario was saved"),
                       GLISSADE_TEXT("Check the scenario and save it again.")});
}

namespace {

/// The solid of a mesh in the units and axes of its file. Nothing if no triangle has three corners.
std::optional<Occurrence> solidOf(TriangleMesh inFile, const Asset& asset, const std::string& file,
                                  Warnings& warnings) {
  const std::size_t triangles = inFile.triangles.size();
  TriangleMesh mesh = welded(interpreted(std::move(inFile), asset.unit, asset.up));
  if (mesh.empty()) return std::nullopt;
  warnOfRemovedTriangles(triangles - mesh.triangles.size(), file, warnings);
  Occurrence solid;
  solid.isClosed = edgeFactsOf(mesh).consistentlyOriented;
  if (auto closed = solid.isClosed ? std::nullopt : closedAtTJunctions(mesh)) {
    warnOfTJunctions(*closed, file, warnings);
    mesh = std::move(closed->mesh);
    solid.coordinateSpacing = closed->moved;
  }
  if (asset.closeHoles) mesh = withoutHoles(mesh, file, warnings);
  solid.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return solid;
}

/// The triangles of each group by its name in the file.
std::map<std::string, TriangleMesh> groupsOf(const ImportedMesh& imported) {
  std::map<std::string, TriangleMesh> meshes;
  std::map<std::string, std::map<std::uint32_t, std::uint32_t>> vertices;  // by group and vertex of the file
  auto next = imported.mesh.triangles.begin();
  for (const GroupRun& run : imported.groups) {
    if (run.triangles == 0) continue;
    TriangleMesh& mesh = meshes[run.name];
    std::map<std::uint32_t, std::uint32_t>& known = vertices[run.name];
    for (const auto end = next + run.triangles; next != end; ++next) {
      TriangleIndices triangle = *next;
      for (std::uint32_t& corner : triangle) {
        const auto [vertex, isNew] = known.emplace(corner, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew) mesh.vertices.push_back(imported.mesh.vertices[corner]);
        corner = vertex->second;
      }
      mesh.triangles.push_back(triangle);
    }
  }
  if (meshes.empty()) meshes[""] = imported.mesh;
  return meshes;
}

/// The group as a step of a path, in which '/' separates steps.
std::string stepOf(const std::string& group) {
  std::string step = group.empty() ? "group" : group;
  std::replace(step.begin(), step.end(), '/', '.');
  return step;
}

}  // namespace

/// `groups`: each group of the file is a part.
Result<LoadedGeometry> GeometryLoader::readMesh(const Asset& asset, bool groups) {
  auto imported = importFile(asset);
  if (!imported) return imported.error();
  const std::string file = assetFile(asset, folder_);
  LoadedGeometry geometry;
  geometry.warnings = imported->warnings;
  std::map<std::string, TriangleMesh> meshes;
  if (groups) {
    meshes = groupsOf(*imported);
  } else {
    meshes[""] = std::move(imported->mesh);
  }
  UniqueNames steps;
  for (auto& [name, mesh] : meshes) {
    auto solid = solidOf(std::move(mesh), asset, file, geometry.warnings);
    if (!solid) continue;
    if (meshes.size() > 1) solid->path = steps.take(stepOf(name));
    solid->coordinateSpacing += asset.unit * imported->coordinateSpacing;
    geometry.parts.push_back(std::move(*solid));
  }
  if (geometry.parts.empty()) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", GLISSADE_TEXT("holds no triangle with three corners"),
                      GLISSADE_TEXT("Export the part again.")};
  }
  TriangleMesh point;
  point.vertices = {imported->vertexMean};
  geometry.vertexMean = interpreted(point, asset.unit, asset.up).vertices.front();
  geometry.sha256 = hashes_[asset.id];
  return geometry;
}

Result<LoadedGeometry> GeometryLoader::readUrdf(const Asset& asset) {
  if (const Outcome sound = checkOwnUnit(asset, "URDF"); !sound) return sound.error();
  const auto content = readAsset(asset);
  if (!content) return content.error();
  auto links = importUrdf(*content, folderOf(content->file), stop_);
  if (!links) return links.error();
  LoadedGeometry geometry;
  geometry.sha256 = hashes_[asset.id];
  geometry.parts = std::move(*links);
  return geometry;
}

Result<LoadedGeometry> GeometryLoader::readStep(const Asset& asset) {
  if (const Outcome sound = checkOwnUnit(asset, nameOf(cadKindOf(asset.path).value_or(CadKind::Step))); !sound)
    return sound.error();
  const auto content = readContent(assetFile(asset, folder_), mostFileBytes());
  if (!content) return content.error();
  const auto product = importStep(*content, asset.deflection, stop_);
  if (!product) return product.error();
  noteHash(asset, content->file, hashOf(*content, *product));
  LoadedGeometry geometry;
  geometry.warnings = product->warnings;
  geometry.sha256 = hashes_[asset.id];
  geometry.parts = product->parts;
  geometry.missing = product->missing;
  leaveSingleUnnamed(geometry.parts);
  return geometry;
}

namespace {

/// The occurrences at a node or below it, with their paths from the node. If there are none, `node` is taken as a path
/// of an earlier version.
std::vector<Occurrence> partsWithin(const std::string& node, const std::vector<Occurrence>& all) {
  std::vector<Occurrence> parts;
  for (const bool formerly : {false, true}) {
    for (const Occurrence& part : all) {
      const std::string& path = formerly && !part.formerPath.empty() ? part.formerPath : part.path;
      if (!isWithin(path, node)) continue;
      parts.push_back(part);
      parts.back().path = pathWithin(path, node);
      const auto above = static_cast<std::ptrdiff_t>(std::min(stepsOf(node).size(), part.names.size()));
      parts.back().names.erase(parts.back().names.begin(), parts.back().names.begin() + above);
    }
    if (!parts.empty()) break;
  }
  return parts;
}

}  // namespace

/// A part of the whole file, which is read once.
Result<LoadedGeometry> GeometryLoader::partOf(const std::string& asset, const std::string& part,
                                              const Geometry& wholeFile, bool asOne) {
  const auto whole = load(wholeFile);
  if (!whole) return whole.error();
  LoadedGeometry geometry = **whole;
  if (asOne && !part.empty()) {
    // Instances share the triangles of the parts of the whole file.
    const auto joined = load(StepGeometry{asset, "", true});
    if (!joined) return joined.error();
    geometry.parts = partsWithin(part, (*joined)->parts);
    if (!geometry.parts.empty()) return geometry;
  }
  geometry.parts = partsWithin(part, asOne ? withPartsAsOne((*whole)->parts, part) : (*whole)->parts);
  if (geometry.parts.empty()) return noSuchPart(assetFile(assetById(asset, assets_), folder_), part, namesOf(**whole));
  if (part.empty()) leaveSingleUnnamed(geometry.parts);
  return geometry;
}

Outcome GeometryLoader::checkOwnUnit(const Asset& asset, const std::string& kind) const {
  if (asset.unit == 1.0 && asset.up == UpAxis::Z) return Done{};
  return Diagnostic{ErrorKind::MalformedInput,
                    file_,
                    {GLISSADE_TEXT("asset '%1'"), {asset.id}},
                    {GLISSADE_TEXT("has a unit or an up-axis, but a %1 file says itself what its numbers mean, and is "
                                   "z up"),
                     {kind}},
                    GLISSADE_TEXT("Leave out 'unit' and 'up_axis'.")};
}

BodyId partId(const BodyId& bodyId, const Occurrence& part) { return BodyId(joinedPath(bodyId.text(), part.path)); }

void warnOfMissingFaces(const LoadedGeometry& geometry, const BodyId& bodyId, const std::string& file,
                        Warnings& warnings) {
  for (const Occurrence& part : geometry.parts) {
    if (part.facesWithoutMesh == 0) continue;
    warnings.push_back({ErrorKind::MalformedInput,
                        file,
                        {GLISSADE_TEXT("body '%1'"), {partId(bodyId, part).text()}},
                        {GLISSADE_TEXT("is not closed: faces or boundaries that could not be made: %1; certificates "
                                       "take what is missing as free space"),
                         {part.facesWithoutMesh}},
                        GLISSADE_TEXT("Do not trust paths near it; export it again, or as a mesh.")});
  }
}

namespace {

bool isNamed(const Occurrence& part, const std::string& asset, const std::vector<const Geometry*>& named) {
  return std::any_of(named.begin(), named.end(), [&](const Geometry* geometry) {
    if (assetOf(*geometry) == nullptr || *assetOf(*geometry) != asset) return false;
    const auto node = partNamedBy(*geometry);
    return !node || node->empty() || isWithin(part.path, *node) || isWithin(part.formerPath, *node);
  });
}

}  // namespace

MissingShapes missingShapesOf(const GeometryCache& read, const std::vector<const Geometry*>& named,
                              const std::vector<Asset>& assets, const std::string& folder) {
  MissingShapes missing;
  std::set<std::string> looked;
  for (const Geometry* geometry : named) {
    if (!partNamedBy(*geometry) || !looked.insert(*assetOf(*geometry)).second) continue;
    const auto whole = read.find(geometryKey(wholeFileOf(*geometry), assets, folder));
    if (whole == read.end()) continue;
    const Asset& asset = assetById(*assetOf(*geometry), assets);
    for (const Occurrence& part : whole->second->parts) {
      if (isNamed(part, asset.id, named)) continue;
      missing.push_back(
          {asset.path, part.path, "", "", GLISSADE_TEXT("the scenario neither names it nor excludes it")});
    }
  }
  for (const auto& [key, geometry] : read) {
    for (const MissingShape& shape : geometry->missing) {
      if (std::find(missing.begin(), missing.end(), shape) == missing.end()) missing.push_back(shape);
    }
  }
  return missing;
}

TriangleMesh wholeMesh(const LoadedGeometry& geometry, const Vector3& reference) {
  TriangleMesh mesh;
  for (const Occurrence& part : geometry.parts) append(mesh, transformed(*part.mesh, part.X_FP));
  return reference.isZero(0.0) ? mesh : transformed(mesh, Pose::translation(-reference));
}

Box3 boxOf(const LoadedGeometry& geometry) {
  Box3 box;
  for (const Occurrence& part : geometry.parts) box.extend(boundingBox(*part.mesh, part.X_FP));
  return box;
}

Pose uprightPose(UpAxis up) {
  return {Vector3::Zero(), up == UpAxis::Y ? fromRollPitchYaw(std::acos(0.0), 0.0, 0.0) : Quaternion::Identity()};
}

TriangleMesh interpreted(TriangleMesh mesh, double unit, UpAxis up) {
  const Pose upright = uprightPose(up);
  for (Vector3& vertex : mesh.vertices) vertex = upright * Vector3(unit * vertex);
  return mesh;
}

}  // namespace glissade
