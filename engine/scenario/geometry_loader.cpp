#include "engine/scenario/geometry_loader.h"

#include <algorithm>

#include "engine/geometry/primitives.h"
#include "engine/import/input_file.h"

namespace glissade {
namespace {

MeshPtr publish(TriangleMesh mesh) { return std::make_shared<const TriangleMesh>(std::move(mesh)); }

MeshPtr primitive(const Geometry& geometry) {
  if (const auto* box = std::get_if<BoxGeometry>(&geometry)) return publish(makeBox(box->size));
  if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
    return publish(makeCylinder(cylinder->radius, cylinder->length));
  }
  return publish(makeSphere(std::get<SphereGeometry>(geometry).radius));
}

}  // namespace

GeometryLoader::GeometryLoader(const Scenario& scenario, std::string folder, std::string file)
    : scenario_(scenario), folder_(std::move(folder)), file_(std::move(file)) {}

Result<std::vector<RigidBody>> GeometryLoader::bodies(const BodyDescription& description, const Colour& fallback) {
  const Result<std::vector<Part>> found = parts(description.geometry);
  if (!found) return found.error();
  std::vector<RigidBody> result;
  for (const Part& part : *found) {
    RigidBody body;
    body.id = part.link.empty() ? description.id : description.id + "/" + part.link;
    body.name = !part.link.empty() ? part.link : description.name.empty() ? description.id : description.name;
    body.mobility = description.mobility;
    body.mesh = part.mesh;
    body.X_WB = Pose{description.pose.position, description.pose.orientation.normalized()} * part.X_BodyPart;
    body.colour = description.colour.value_or(part.colour.value_or(fallback));
    result.push_back(std::move(body));
  }
  return result;
}

Result<RigidBody> GeometryLoader::object(const ObjectDescription& description, const Colour& fallback) {
  const Result<std::vector<Part>> found = parts(description.geometry);
  if (!found) return found.error();
  TriangleMesh compound;
  std::optional<Colour> colour = description.colour;
  for (const Part& part : *found) {
    append(compound, transformed(*part.mesh, part.X_BodyPart));
    if (!colour) colour = part.colour;
  }
  if (description.centreOnVertexMean) {
    const Vector3 mean = meshes_.at(std::get<MeshGeometry>(description.geometry).asset).vertexMean;
    compound = transformed(compound, Pose::translation(-mean));
  }
  RigidBody object;
  object.id = description.id;
  object.name = description.name.empty() ? description.id : description.name;
  object.mobility = Mobility::Mobile;
  object.mesh = publish(std::move(compound));
  object.colour = colour.value_or(fallback);
  return object;
}

Result<std::vector<GeometryLoader::Part>> GeometryLoader::parts(const Geometry& geometry) {
  if (const auto* reference = std::get_if<MeshGeometry>(&geometry)) {
    const Result<ImportedMesh> imported = mesh(reference->asset);
    if (!imported) return imported.error();
    return std::vector<Part>{{"", publish(imported->mesh), Pose::identity(), std::nullopt}};
  }
  if (const auto* reference = std::get_if<UrdfGeometry>(&geometry)) {
    const Result<UrdfModel> model = urdf(reference->asset);
    if (!model) return model.error();
    std::vector<Part> result;
    for (const UrdfLink& link : model->links) {
      result.push_back({link.name, publish(link.mesh), link.X_RootLink, link.colour});
    }
    return result;
  }
  return std::vector<Part>{{"", primitive(geometry), Pose::identity(), std::nullopt}};
}

Result<ImportedMesh> GeometryLoader::mesh(const std::string& assetId) {
  if (const auto known = meshes_.find(assetId); known != meshes_.end()) return known->second;
  const Asset& asset = assetOf(assetId);
  const Result<std::string> path = locate(asset);
  if (!path) return path.error();
  const Result<ImportedMesh> imported = importMesh(*path, asset.interpretation);
  if (!imported) return imported.error();
  compareHash(asset, imported->sha256);
  meshes_.emplace(assetId, *imported);
  return imported;
}

Result<UrdfModel> GeometryLoader::urdf(const std::string& assetId) {
  if (const auto known = models_.find(assetId); known != models_.end()) return known->second;
  const Asset& asset = assetOf(assetId);
  const bool asDefined = asset.interpretation.unit == 1.0 && asset.interpretation.up == UpAxis::Z;
  if (!asDefined) {
    return atAsset(
        asset, "unit",
        {ErrorKind::MalformedInput, "", "", "a URDF file is always in metres and Z-up", "Leave out 'unit' and 'up'."});
  }
  const Result<std::string> path = locate(asset);
  if (!path) return path.error();
  const Result<UrdfModel> model = importUrdf(*path, folder_);
  if (!model) return model.error();
  compareHash(asset, model->sha256);
  models_.emplace(assetId, *model);
  return model;
}

Result<std::string> GeometryLoader::locate(const Asset& asset) const {
  const Result<std::string> path = resolveInside(folder_, asset.path);
  if (!path) return atAsset(asset, "path", path.error());
  return path;
}

void GeometryLoader::compareHash(const Asset& asset, const std::string& sha256) {
  if (asset.sha256.empty() || asset.sha256 == sha256) return;
  warnings_.push_back(
      atAsset(asset, "sha256",
              {ErrorKind::MalformedInput, "", "", "'" + asset.path + "' has changed since the scenario was saved",
               "Check that it still is what you mean, and save the scenario."}));
}

Diagnostic GeometryLoader::atAsset(const Asset& asset, const std::string& key, const Diagnostic& problem) const {
  const auto index = &asset - scenario_.assets.data();
  return {problem.kind, file_, "/assets/" + std::to_string(index) + "/" + key, problem.reason, problem.advice};
}

const Asset& GeometryLoader::assetOf(const std::string& id) const {
  return *std::find_if(scenario_.assets.begin(), scenario_.assets.end(), [&](const Asset& a) { return a.id == id; });
}

}  // namespace glissade
