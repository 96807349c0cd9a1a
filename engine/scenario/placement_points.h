#pragma once

#include <optional>

#include "engine/scenario/assembly_edits.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// Points of what is placed that a person may want to give the place of, in the frame B that its pose is of; and a
/// frame of a face or an axis, whose turn counts, too.
struct PlacementPoints {
  Vector3 fileOrigin = Vector3::Zero();  ///< the origin of the file's coordinates: where the pose of a CAD system is
  Vector3 middle = Vector3::Zero();      ///< of the bounding box in B
  std::optional<Pose> picked{};          ///< X_BF of a face or an axis that a person has picked
};

/// The origin of B is the file's where a body is placed, and the object's reference point where an end is. What is
/// made of no file has its origin in the origin of its primitive.
PlacementPoints placementPoints(const LoadedScenario& loaded, const AssemblyItem& item);

}  // namespace glissade
