#include "engine/scenario/geometry_loader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "engine/import/step_import.h"
#include "engine/import/urdf_import.h"
#include "engine/scenario/asset_path.h"
#include "engine/scenario/step_parts.h"

namespace glissade {
namespace {

LoadedGeometry single(TriangleMesh mesh) {
  LoadedGeometry geometry;
  geometry.parts.push_back({"", std::make_shared<const TriangleMesh>(std::move(mesh)), Pose::identity(), std::nullopt});
  return geometry;
}

/// One name for a file, whichever folder it is named from.
std::string withoutLinks(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path found = std::filesystem::weakly_canonical(path, ignored);
  return found.empty() ? path : found.string();
}

const Asset& assetById(const std::string& id, const Scenario& scenario) {
  return *std::find_if(scenario.assets.begin(), scenario.assets.end(), [&](const Asset& a) { return a.id == id; });
}

}  // namespace

std::string geometryKey(const Geometry& geometry, const Scenario& scenario, const std::string& folder) {
  const auto ofAsset = [&](const std::string& kind, const std::string& id) {
    const Asset& asset = assetById(id, scenario);
    return kind + " " + toText(asset.unit) + (asset.up == UpAxis::Y ? " y " : " z ") +
           withoutLinks(assetFile(asset, folder));
  };
  if (const auto* mesh = std::get_if<MeshGeometry>(&geometry)) return ofAsset("mesh", mesh->asset);
  if (const auto* urdf = std::get_if<UrdfGeometry>(&geometry)) return ofAsset("urdf", urdf->asset);
  if (const auto* step = std::get_if<StepGeometry>(&geometry)) {
    const double deflection = assetById(step->asset, scenario).deflection;
    return ofAsset("step " + toText(deflection), step->asset) + (step->part.empty() ? "" : " : " + step->part);
  }
  if (const auto* box = std::get_if<BoxGeometry>(&geometry)) {
    return "box " + toText(box->size.x()) + " " + toText(box->size.y()) + " " + toText(box->size.z());
  }
  if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
    return "cylinder " + toText(cylinder->radius) + " " + toText(cylinder->length);
  }
  return "sphere " + toText(std::get<SphereGeometry>(geometry).radius);
}

GeometryLoader::GeometryLoader(const Scenario& scenario, std::string folder, std::string file, GeometryCache known,
                               StopToken stop)
    : scenario_(scenario),
      folder_(std::move(folder)),
      file_(std::move(file)),
      known_(std::move(known)),
      stop_(std::move(stop)) {}

Result<LoadedGeometryPtr> GeometryLoader::load(const Geometry& geometry) {
  const std::string key = geometryKey(geometry, scenario_, folder_);
  LoadedGeometryPtr& loaded = loaded_[key];
  if (loaded) return loaded;
  if (const auto known = known_.find(key); known != known_.end()) {
    loaded = known->second;
    return loaded;
  }
  auto read = this->read(geometry);
  if (!read) return read.error();
  loaded = std::make_shared<const LoadedGeometry>(std::move(*read));
  return loaded;
}

Result<LoadedGeometry> GeometryLoader::read(const Geometry& geometry) {
  if (const auto* mesh = std::get_if<MeshGeometry>(&geometry)) return readMesh(assetById(mesh->asset, scenario_));
  if (const auto* urdf = std::get_if<UrdfGeometry>(&geometry)) return readUrdf(assetById(urdf->asset, scenario_));
  if (const auto* step = std::get_if<StepGeometry>(&geometry)) {
    return step->part.empty() ? readStep(assetById(step->asset, scenario_)) : partOf(*step);
  }
  if (const auto* box = std::get_if<BoxGeometry>(&geometry)) return single(makeBox(box->size));
  if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
    return single(makeCylinder(cylinder->radius, cylinder->length));
  }
  return single(makeSphere(std::get<SphereGeometry>(geometry).radius));
}

/// The file of an asset; warns where it is not the one that the scenario was saved with.
Result<std::string> GeometryLoader::fileOf(const Asset& asset) {
  const std::string path = assetFile(asset, folder_);
  const auto content = readFile(path, kMostAssetBytes);
  if (!content) return content.error();
  if (!asset.sha256.empty() && sha256(*content) != asset.sha256) {
    warnings_.push_back({ErrorKind::MalformedInput, path, "", "has changed since the scenario was saved",
                         "Check the scenario and save it again."});
  }
  return path;
}

Result<LoadedGeometry> GeometryLoader::readMesh(const Asset& asset) {
  const auto path = fileOf(asset);
  if (!path) return path.error();
  const auto imported = importMesh(*path);
  if (!imported) return imported.error();
  LoadedGeometry geometry = single(welded(interpreted(imported->mesh, asset.unit, asset.up)));
  if (geometry.parts.front().mesh->empty()) {
    return Diagnostic{ErrorKind::MalformedInput, *path, "", "holds no triangle with three corners",
                      "Export the part again."};
  }
  TriangleMesh point;
  point.vertices = {imported->vertexMean};
  geometry.vertexMean = interpreted(point, asset.unit, asset.up).vertices.front();
  return geometry;
}

Result<LoadedGeometry> GeometryLoader::readUrdf(const Asset& asset) {
  if (const Outcome sound = checkOwnUnit(asset, "URDF"); !sound) return sound.error();
  const auto path = fileOf(asset);
  if (!path) return path.error();
  auto links = importUrdf(*path, folderOf(*path));
  if (!links) return links.error();
  LoadedGeometry geometry;
  for (UrdfLink& link : *links) {
    geometry.parts.push_back(
        {link.name, std::make_shared<const TriangleMesh>(std::move(link.mesh)), link.X_RL, link.colour});
  }
  return geometry;
}

Result<LoadedGeometry> GeometryLoader::readStep(const Asset& asset) {
  if (const Outcome sound = checkOwnUnit(asset, "STEP"); !sound) return sound.error();
  const auto path = fileOf(asset);
  if (!path) return path.error();
  const auto parts = importStep(*path, asset.deflection, stop_);
  if (!parts) return parts.error();
  LoadedGeometry geometry;
  for (const StepPart& part : *parts) {
    const std::string name = parts->size() == 1 ? "" : part.path;
    geometry.parts.push_back({name, part.mesh, part.X_FP, part.colour, part.deflection, part.facesWithoutMesh});
  }
  return geometry;
}

/// Of the file as a whole, which is read once.
Result<LoadedGeometry> GeometryLoader::partOf(const StepGeometry& step) {
  const auto whole = load(StepGeometry{step.asset, ""});
  if (!whole) return whole.error();
  LoadedGeometry geometry;
  for (const GeometryPart& part : (*whole)->parts) {
    if (!isWithin(part.name, step.part)) continue;
    geometry.parts.push_back(part);
    geometry.parts.back().name = nameWithin(part.name, step.part);
  }
  if (!geometry.parts.empty()) return geometry;
  return noSuchPart(assetFile(assetById(step.asset, scenario_), folder_), step.part, namesOf(**whole));
}

Outcome GeometryLoader::checkOwnUnit(const Asset& asset, const std::string& kind) const {
  if (asset.unit == 1.0 && asset.up == UpAxis::Z) return Done{};
  return Diagnostic{ErrorKind::MalformedInput, file_, "asset '" + asset.id + "'",
                    "has a unit or an up-axis, but a " + kind + " file says itself what its numbers mean, and is z up",
                    "Leave out 'unit' and 'up_axis'."};
}

void chooseReferencePoint(ObjectDescription& object, const LoadedGeometry& geometry) {
  object.centreOnVertexMean = std::holds_alternative<MeshGeometry>(object.geometry);
  const bool step = std::holds_alternative<StepGeometry>(object.geometry);
  object.referencePoint = step ? boxOf(geometry).center() : Vector3(Vector3::Zero());
}

Vector3 referencePointOf(const ObjectDescription& object, const LoadedGeometry& geometry) {
  return object.centreOnVertexMean ? geometry.vertexMean : object.referencePoint;
}

TriangleMesh objectMesh(const ObjectDescription& object, const LoadedGeometry& geometry) {
  TriangleMesh mesh;
  for (const GeometryPart& part : geometry.parts) append(mesh, transformed(*part.mesh, part.X_BP));
  const Vector3 reference = referencePointOf(object, geometry);
  return reference.isZero(0.0) ? mesh : transformed(mesh, Pose::translation(-reference));
}

Box3 boxOf(const LoadedGeometry& geometry) {
  Box3 box;
  for (const GeometryPart& part : geometry.parts) box.extend(boundingBox(*part.mesh, part.X_BP));
  return box;
}

TriangleMesh interpreted(const TriangleMesh& mesh, double unit, UpAxis up) {
  const Pose upright{Vector3::Zero(),
                     up == UpAxis::Y ? fromRollPitchYaw(std::acos(0.0), 0.0, 0.0) : Quaternion::Identity()};
  return transformed(scaled(mesh, Vector3::Constant(unit)), upright);
}

}  // namespace glissade
