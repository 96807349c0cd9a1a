#include "engine/sequence/motion_world.h"

namespace glissade {

MotionWorld motionWorld(const AssembledProduct& product, const ProductFits& fits, PreparedBodies& prepared,
                        std::size_t body, const BodySet& present) {
  MotionWorld motion;
  std::vector<PreparedBodies::Against> obstacles;
  for (const std::size_t other : bodiesIn(present)) {
    if (other == body) continue;
    motion.bodies.push_back(other);
    obstacles.push_back({other, fits.meshAgainst(body, other)});
  }
  motion.world = prepared.world(product.bodies[body].mesh, obstacles);
  return motion;
}

ParameterValues motionParameters(const RigidBody& body) {
  ParameterValues parameters(radiusAboutOrigin(*body.mesh));
  static_cast<void>(parameters.set(ParameterId::Slots, 1.0));
  return parameters;
}

void nameByProduct(MotionCertificate& certificate, const std::vector<std::size_t>& bodies) {
  const auto rename = [&](NearestObstacle& nearest) {
    if (nearest.body >= 0) nearest.body = static_cast<int>(bodies[static_cast<std::size_t>(nearest.body)]);
  };
  rename(certificate.nearest);
  for (EdgeCertificate& edge : certificate.edges) rename(edge.nearest);
}

}  // namespace glissade
