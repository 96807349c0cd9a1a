#pragma once

#include "engine/base/result.h"
#include "engine/import/geometry_loader.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What the bodies of an object are made of, in their order.
using ObjectGeometry = std::vector<LoadedGeometryPtr>;

/// Errors: as of GeometryLoader::load().
Result<ObjectGeometry> loadGeometryOf(const ObjectDescription& object, GeometryLoader& loader);

/// Of an object of these bodies, as they were loaded; empty where one was not.
ObjectGeometry geometryOf(const ObjectDescription& object, const LoadedScenario& loaded);

/// X_GB of one of the object's bodies.
Pose poseInObject(const ObjectDescription& object, std::size_t body);

/// The bounding box of all, in the object's frame G.
Box3 boxOf(const ObjectDescription& object, const ObjectGeometry& geometry);

/// Puts the reference point of an object where it turns best: a mesh file's into the mean of its vertices, a STEP
/// part's into the middle of the box in the part's own frame, a group's into the middle of the box; elsewhere it is the
/// origin.
void chooseReferencePoint(ObjectDescription& object, const ObjectGeometry& geometry);
/// In the object's frame G.
Vector3 referencePointOf(const ObjectDescription& object, const ObjectGeometry& geometry);
/// The object as one mesh about its reference point.
TriangleMesh objectMesh(const ObjectDescription& object, const ObjectGeometry& geometry);

}  // namespace glissade
