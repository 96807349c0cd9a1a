#pragma once

#include <optional>

#include "engine/collision/collision_query.h"
#include "engine/places/environment_model.h"
#include "engine/planning/sampling_region.h"

namespace glissade {

/// Whether and how the object goes through a place: the computed compatibility (paper 2, Table 1, as
/// a score instead of a boolean).
struct PassageFit {
  double score = 1.0;   ///< 0: does not fit; from kFits on it does; 1: with ease
  double margin = 0.0;  ///< metres that are left around the silhouette at the best; negative: too large
  /// A certified straight path through the passage: configurations before, in and behind it along its axis. Nothing if
  /// none was found.
  struct Crossing {
    Pose before;
    Pose inside;
    Pose behind;
  };
  std::optional<Crossing> crossing;
  bool probed = false;                     ///< the silhouette nearly fits, and a search in 3D decided
  std::uint64_t randomConfigurations = 0;  ///< drawn by that search

  static constexpr double kFits = 0.5;
};

/// Fits the object through a passage. The object's silhouette is taken along the normals of its
/// largest faces, turned and shifted to the largest margin in the section of the passage (for convex
/// sections and silhouettes the answer of the small linear programme over position for each angle);
/// it counts as fitting once a straight motion through is certified. A silhouette that is only just too large, of an
/// object that is not convex, is probed by a short search in 3D: such objects may pass by tilting. Deterministic.
/// Unfinished after a stop. Precondition: place.passage.
PassageFit fitThroughPassage(const EnvironmentModel& environment, std::size_t place, const CollisionWorldPtr& world,
                             const Box3& bounds, double requiredClearance, const StopToken& stop = {});

/// For places that are not passages: whether the object's slimmest extent goes through the widest spot.
PassageFit fitInRoom(const Place& room, double slimmestExtent);

/// The least distance of two parallel planes across a principal direction with the object between them.
double slimmestExtent(const TriangleMesh& object);

/// The directions, in B, along which the object is looked at: normals of its largest faces, each with
/// its opposite.
std::vector<Vector3> principalDirections(const TriangleMesh& object, std::size_t most);

}  // namespace glissade
