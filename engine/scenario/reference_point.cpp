#include "engine/scenario/reference_point.h"

#include "engine/import/geometry_loader.h"

namespace glissade {

void chooseReferencePoint(ObjectDescription& object, const LoadedGeometry& geometry) {
  object.centreOnVertexMean = std::holds_alternative<MeshGeometry>(object.geometry);
  const bool step = std::holds_alternative<StepGeometry>(object.geometry);
  object.referencePoint = step ? boxOf(geometry).center() : Vector3(Vector3::Zero());
}

Vector3 referencePointOf(const ObjectDescription& object, const LoadedGeometry& geometry) {
  return object.centreOnVertexMean ? geometry.vertexMean : object.referencePoint;
}

TriangleMesh objectMesh(const ObjectDescription& object, const LoadedGeometry& geometry) {
  return wholeMesh(geometry, referencePointOf(object, geometry));
}

}  // namespace glissade
