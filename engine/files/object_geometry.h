#pragma once

#include "engine/base/result.h"
#include "engine/files/scenario.h"
#include "engine/import/geometry_loader.h"

namespace glissade {

/// Geometries of the bodies of an object, in their order.
using ObjectGeometry = std::vector<LoadedGeometryPtr>;

/// Loads the geometries. Errors are those of GeometryLoader::load().
Result<ObjectGeometry> loadGeometryOf(const ObjectDescription& object, GeometryLoader& loader);

/// The loaded geometries of an object that consists of loaded bodies; empty where one was not loaded.
ObjectGeometry geometryOf(const ObjectDescription& object, const LoadedScenario& loaded);

/// X_GB of one of the object's bodies.
Pose poseInObject(const ObjectDescription& object, std::size_t body);

/// The bounding box of all bodies, in the object's frame G.
Box3 boxOf(const ObjectDescription& object, const ObjectGeometry& geometry);

/// Chooses the reference point of an object: the mean of the vertices of a mesh file, the middle of a STEP part's box
/// in its own frame, the middle of a group's box; else the origin.
void chooseReferencePoint(ObjectDescription& object, const ObjectGeometry& geometry);
/// The reference point in the object's frame G.
Vector3 referencePointOf(const ObjectDescription& object, const ObjectGeometry& geometry);
/// The object as one mesh about its reference point.
TriangleMesh objectMesh(const ObjectDescription& object, const ObjectGeometry& geometry);

}  // namespace glissade
