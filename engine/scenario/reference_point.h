#pragma once

#include "engine/scenario/scenario.h"

namespace glissade {

/// Puts the reference point of an object where it turns best: a mesh file's into the mean of its vertices, a
/// STEP part's into the middle of its box; elsewhere it is the origin.
void chooseReferencePoint(ObjectDescription& object, const LoadedGeometry& geometry);
/// In the geometry's frame.
Vector3 referencePointOf(const ObjectDescription& object, const LoadedGeometry& geometry);
/// The object as one mesh about its reference point.
TriangleMesh objectMesh(const ObjectDescription& object, const LoadedGeometry& geometry);

}  // namespace glissade
