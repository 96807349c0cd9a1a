#include "engine/scenario/asset_geometry.h"

#include <algorithm>
#include <cmath>

#include "engine/base/file.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "engine/import/urdf_import.h"
#include "engine/scenario/asset_path.h"

namespace glissade {
namespace {

std::vector<GeometryPart> single(TriangleMesh mesh) {
  GeometryPart part;
  part.mesh = std::move(mesh);
  return {std::move(part)};
}

}  // namespace

GeometryLoader::GeometryLoader(const Scenario& scenario, std::string folder, std::string file)
    : scenario_(scenario), folder_(std::move(folder)), file_(std::move(file)) {}

Result<std::vector<GeometryPart>> GeometryLoader::load(const Geometry& geometry) {
  if (const auto* mesh = std::get_if<MeshGeometry>(&geometry)) return loadMesh(mesh->asset);
  if (const auto* urdf = std::get_if<UrdfGeometry>(&geometry)) return loadUrdf(urdf->asset);
  if (const auto* box = std::get_if<BoxGeometry>(&geometry)) return single(makeBox(box->size));
  if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
    return single(makeCylinder(cylinder->radius, cylinder->length));
  }
  return single(makeSphere(std::get<SphereGeometry>(geometry).radius));
}

const Asset& GeometryLoader::assetById(const std::string& id) const {
  return *std::find_if(scenario_.assets.begin(), scenario_.assets.end(), [&](const Asset& a) { return a.id == id; });
}

/// The file of an asset; warns where it is not the one that the scenario was saved with.
Result<std::string> GeometryLoader::fileOf(const Asset& asset) {
  constexpr std::size_t kMostBytes = 100U << 20;
  const std::string path = assetFile(asset, folder_);
  const auto content = readFile(path, kMostBytes);
  if (!content) return content.error();
  if (!asset.sha256.empty() && sha256(*content) != asset.sha256) {
    warnings_.push_back({ErrorKind::MalformedInput, path, "", "has changed since the scenario was saved",
                         "Check the scenario and save it again."});
  }
  return path;
}

Result<std::vector<GeometryPart>> GeometryLoader::loadMesh(const std::string& id) {
  const Asset& asset = assetById(id);
  const auto path = fileOf(asset);
  if (!path) return path.error();
  auto imported = importMesh(*path);
  if (!imported) return imported.error();
  auto parts = single(welded(interpreted(imported->mesh, asset.unit, asset.up)));
  if (parts.front().mesh.empty()) {
    return Diagnostic{ErrorKind::MalformedInput, *path, "", "holds no triangle with three corners",
                      "Export the part again."};
  }
  TriangleMesh point;
  point.vertices = {imported->vertexMean};
  parts.front().vertexMean = interpreted(point, asset.unit, asset.up).vertices.front();
  return parts;
}

Result<std::vector<GeometryPart>> GeometryLoader::loadUrdf(const std::string& id) {
  const Asset& asset = assetById(id);
  if (asset.unit != 1.0 || asset.up != UpAxis::Z) {
    return Diagnostic{ErrorKind::MalformedInput, file_, "asset '" + asset.id + "'",
                      "has a unit or an up-axis, but a URDF file is always in metres and z up",
                      "Leave out 'unit' and 'up_axis'."};
  }
  const auto path = fileOf(asset);
  if (!path) return path.error();
  auto links = importUrdf(*path, folderOf(*path));
  if (!links) return links.error();
  std::vector<GeometryPart> parts;
  for (UrdfLink& link : *links) {
    parts.push_back({link.name, std::move(link.mesh), link.X_RL, link.colour, Vector3::Zero()});
  }
  return parts;
}

TriangleMesh objectMesh(const ObjectDescription& object, const std::vector<GeometryPart>& parts) {
  TriangleMesh mesh;
  for (const GeometryPart& part : parts) append(mesh, transformed(part.mesh, part.X_BP));
  if (object.centreOnVertexMean) mesh = transformed(mesh, Pose::translation(-parts.front().vertexMean));
  return mesh;
}

Box3 boxOf(const std::vector<GeometryPart>& parts) {
  Box3 box;
  for (const GeometryPart& part : parts) box.extend(boundingBox(part.mesh, part.X_BP));
  return box;
}

TriangleMesh interpreted(const TriangleMesh& mesh, double unit, UpAxis up) {
  const Pose upright{Vector3::Zero(),
                     up == UpAxis::Y ? fromRollPitchYaw(std::acos(0.0), 0.0, 0.0) : Quaternion::Identity()};
  return transformed(scaled(mesh, Vector3::Constant(unit)), upright);
}

}  // namespace glissade
