#pragma once

#include <QString>

#include "engine/files/assembly_edits.h"
#include "widgets/scene3d/scene_pick.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// The first item that can be arranged on a ray.
struct ItemHit {
  AssemblyItem item;
  RigidBody body;  ///< the body as it is drawn; for an end of the motion the object there
  BodyHit hit;     ///< BodyHit::body has no meaning
  Vector3 p_W;
};

/// Hits the bodies that are drawn, and the ghosts at the start and the goal. `only`: hits no other item.
std::optional<ItemHit> itemAt(const LoadedScenario& scenario, const SceneView& view, const Ray& ray,
                              const std::optional<AssemblyItem>& only = std::nullopt);

/// Draws an item at X_WB without changing the scenario.
void drawItemAt(const AssemblyItem& item, const Pose& X_WB, const LoadedScenario& scenario, SceneView& view);

/// The item's name for people: the displayed name of a body, the id of a description of several bodies.
QString nameOf(const AssemblyItem& item, const LoadedScenario& scenario);

}  // namespace glissade
