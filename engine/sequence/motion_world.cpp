#include "engine/sequence/motion_world.h"

#include <algorithm>

namespace glissade {

std::size_t obstacleOf(std::size_t body, const std::vector<std::size_t>& bodies) {
  return static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
}

MotionWorld motionWorld(const AssembledProduct& product, const ProductFits& fits, PreparedBodies& prepared,
                        std::size_t body, const BodySet& present) {
  MotionWorld motion;
  const MeshPtr& mesh = product.bodies[body].mesh;
  std::vector<PreparedBodies::Against> obstacles;
  std::vector<PreparedBodies::Against> unscrewed;
  std::vector<Fit> own = fits.fitsOf(body, present);
  for (const std::size_t other : bodiesIn(present)) {
    if (other == body) continue;
    motion.bodies.push_back(other);
    obstacles.push_back({other, fits.meshAgainst(body, other)});
    unscrewed.push_back({other, fits.isThread(body, other) ? mesh : obstacles.back().object});
  }
  motion.world = prepared.world(mesh, obstacles);
  for (Fit& fit : own) fit.obstacle = obstacleOf(fit.obstacle, motion.bodies);
  const std::vector<ThreadRule> rules = threadRulesOf(own);
  if (!rules.empty()) motion.world = motion.world->withThreads(rules, prepared.world(mesh, unscrewed));
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
