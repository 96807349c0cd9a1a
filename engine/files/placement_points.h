#pragma once

#include <optional>

#include "engine/files/assembly_edits.h"
#include "engine/files/scenario.h"

namespace glissade {

/// Points of a placed item whose position a person may want to set, in the frame B of its pose; and a frame of a face
/// or an axis, whose orientation matters, too.
struct PlacementPoints {
  Vector3 fileOrigin = Vector3::Zero();  ///< the origin of the file's coordinates, which CAD systems use as the pose
  Vector3 middle = Vector3::Zero();      ///< middle of the bounding box in B
  std::optional<Pose> picked{};          ///< X_BF of a face or an axis that a person has picked
};

/// The placement points of an item. The origin of B is the file's origin for a body, and the object's reference point
/// for an end. A body without a file has its origin in the origin of its primitive.
PlacementPoints placementPoints(const LoadedScenario& loaded, const AssemblyItem& item);

}  // namespace glissade
