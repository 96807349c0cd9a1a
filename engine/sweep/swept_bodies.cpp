#include "engine/sweep/swept_bodies.h"

#include "engine/collision/prepared_bodies.h"

namespace glissade {

std::vector<std::size_t> bodiesWithin(const SweptVolume& sweep, const std::vector<RigidBody>& bodies,
                                      const StopToken& stop) {
  const auto surface = std::make_shared<const TriangleMesh>(sweep.surface_W);
  const Box3 box = boundingBox(*surface);
  PreparedBodies prepared(bodies);
  std::vector<std::size_t> within;
  for (std::size_t body = 0; body < bodies.size() && !stop.stopRequested(); ++body) {
    if (!box.intersects(prepared.boxOf(body))) continue;
    if (prepared.world(surface, {{body, surface}})->makeQuery()->collides(Pose::identity())) within.push_back(body);
  }
  return within;
}

}  // namespace glissade
