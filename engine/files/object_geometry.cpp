#include "engine/files/object_geometry.h"

#include "engine/base/file.h"

namespace glissade {
namespace {

/// The middle that aboutTheirMiddles() also chooses for the bodies of a product, so that both compute the same radius.
Vector3 middleOf(const ObjectDescription& object, const ObjectGeometry& geometry) {
  const std::vector<Occurrence>& parts = geometry.front()->parts;
  if (object.isGroup() || parts.size() != 1) return boxOf(object, geometry).center();
  return parts.front().X_FP * Vector3(boundingBox(*parts.front().mesh).center());
}

}  // namespace

Result<ObjectGeometry> loadGeometryOf(const ObjectDescription& object, GeometryLoader& loader) {
  ObjectGeometry geometry;
  for (const BodyDescription& body : object.bodies) {
    const auto loaded = loader.load(body.geometry);
    if (!loaded) return loaded.error();
    geometry.push_back(*loaded);
  }
  return geometry;
}

ObjectGeometry geometryOf(const ObjectDescription& object, const LoadedScenario& loaded) {
  ObjectGeometry geometry;
  for (const BodyDescription& body : object.bodies) {
    const auto known = loaded.geometry.find(geometryKey(body.geometry, loaded.scenario.assets, folderOf(loaded.file)));
    if (known == loaded.geometry.end()) return {};
    geometry.push_back(known->second);
  }
  return geometry;
}

Pose poseInObject(const ObjectDescription& object, std::size_t body) {
  if (body == 0) return Pose::identity();
  const Pose& X_GB = object.bodies[body].pose;
  return {X_GB.position, X_GB.orientation.normalized()};
}

Box3 boxOf(const ObjectDescription& object, const ObjectGeometry& geometry) {
  Box3 box = boxOf(*geometry.front());
  for (std::size_t i = 1; i < geometry.size(); ++i) {
    for (const Occurrence& part : geometry[i]->parts) {
      box.extend(boundingBox(*part.mesh, poseInObject(object, i) * part.X_FP));
    }
  }
  return box;
}

void chooseReferencePoint(ObjectDescription& object, const ObjectGeometry& geometry) {
  const Geometry& first = object.first().geometry;
  const auto* mesh = std::get_if<MeshGeometry>(&first);
  object.centreOnVertexMean = !object.isGroup() && mesh != nullptr && !mesh->groups;
  const bool middle =
      object.isGroup() || std::holds_alternative<StepGeometry>(first) || (mesh != nullptr && mesh->groups);
  object.referencePoint = middle ? middleOf(object, geometry) : Vector3(Vector3::Zero());
}

Vector3 referencePointOf(const ObjectDescription& object, const ObjectGeometry& geometry) {
  return object.centreOnVertexMean ? geometry.front()->vertexMean : object.referencePoint;
}

TriangleMesh objectMesh(const ObjectDescription& object, const ObjectGeometry& geometry) {
  const Vector3 reference = referencePointOf(object, geometry);
  TriangleMesh mesh = wholeMesh(*geometry.front(), reference);
  for (std::size_t i = 1; i < geometry.size(); ++i) {
    const Pose X_OB = Pose::translation(-reference) * poseInObject(object, i);
    append(mesh, transformed(wholeMesh(*geometry[i], Vector3::Zero()), X_OB));
  }
  return mesh;
}

}  // namespace glissade
