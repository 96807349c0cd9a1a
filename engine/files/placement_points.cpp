#include "engine/files/placement_points.h"

#include "engine/files/object_geometry.h"
#include "engine/places/rigid_body.h"

namespace glissade {
namespace {

PlacementPoints pointsOfObject(const LoadedScenario& loaded) {
  const ObjectDescription& object = loaded.scenario.object;
  PlacementPoints points;
  points.middle = boundingBox(*loaded.object.mesh).center();
  const ObjectGeometry geometry = geometryOf(object, loaded);
  if (!geometry.empty()) points.fileOrigin = -referencePointOf(object, geometry);
  return points;
}

PlacementPoints pointsOfBody(const LoadedScenario& loaded, const AssemblyItem& item, const Pose& X_WB) {
  Box3 box;
  for (const RigidBody& rigid : loaded.obstacles) {
    if (bodyIdOf(rigid.id) == item.bodyId) box.extend(boundingBox(*rigid.mesh, inverse(X_WB) * rigid.X_WB));
  }
  PlacementPoints points;
  if (!box.isEmpty()) points.middle = box.center();
  return points;
}

}  // namespace

PlacementPoints placementPoints(const LoadedScenario& loaded, const AssemblyItem& item) {
  if (item.kind != AssemblyItem::Kind::Body) return pointsOfObject(loaded);
  const auto X_WB = poseOf(loaded.scenario, item);
  return X_WB ? pointsOfBody(loaded, item, *X_WB) : PlacementPoints();
}

}  // namespace glissade
