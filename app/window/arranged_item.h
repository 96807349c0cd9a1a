#pragma once

#include <QString>

#include "engine/scenario/assembly_edits.h"
#include "widgets/scene3d/scene_pick.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// What a ray meets first of what can be arranged.
struct ItemHit {
  AssemblyItem item;
  RigidBody body;  ///< where it is drawn; of an end of the motion the object there
  BodyHit hit;     ///< BodyHit::body has no meaning
  Vector3 p_W;
};

/// Of the bodies that are drawn, and of the start and the goal where their ghosts are. `only`: nothing else counts.
std::optional<ItemHit> itemAt(const LoadedScenario& scenario, const SceneView& view, const Ray& ray,
                              const std::optional<AssemblyItem>& only = std::nullopt);

/// Draws an item at X_WB that the scenario has elsewhere.
void drawItemAt(const AssemblyItem& item, const Pose& X_WB, const LoadedScenario& scenario, SceneView& view);

/// As people call it.
QString nameOf(const AssemblyItem& item);

}  // namespace glissade
