#include "engine/planning/automatic/move_to_clearance.h"

#include <array>

#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/retraction.h"

namespace glissade {
namespace {

/// Depths of erosion, as shares of the object's radius; 0: it is too near, and does not touch.
constexpr std::array<double, 7> kDepths{0.0, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
/// Edges of the eroded object have moved by less than its faces.
constexpr std::array<double, 3> kDemands{1.05, 1.5, 2.0};

}  // namespace

Result<Pose> moveToClearance(const CollisionWorldPtr& world, const Pose& q, double required, const StopToken& stop) {
  const double clearance = 2.0 * required;
  const auto query = world->makeQuery();
  if (query->clearAbove(q, clearance)) return q;
  ErodedWorlds eroded(world);
  for (const double depth : kDepths) {
    const double by = depth * world->objectRadius();
    const auto erodedQuery = eroded.at(by)->makeQuery();
    for (const double demand : kDemands) {
      if (stop.stopRequested()) return Diagnostic{ErrorKind::Interrupted, "", "", "it was stopped", ""};
      const auto found = retracted(*erodedQuery, q, demand * (by + clearance), world->objectRadius());
      if (found && query->clearAbove(*found, clearance)) return *found;
    }
  }
  return Diagnostic{ErrorKind::InCollision, "", "", "there is no free configuration near by: the parts overlap too far",
                    "Put the object elsewhere, or check the parts and their unit."};
}

}  // namespace glissade
