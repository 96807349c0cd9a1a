#include "engine/sequence/motion_world.h"

#include <algorithm>

#include "engine/sequence/swept_box.h"

namespace glissade {
namespace {

double usualClearance(double radius) { return ParameterValues(radius)[ParameterId::RequiredClearance]; }

}  // namespace

MotionWorlds::MotionWorlds(const AssembledProduct& product, const ProductFits& fits)
    : product_(product), fits_(fits), prepared_(product.bodies) {}

const MovingObject& MotionWorlds::object(const BodyGroup& group) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = objects_.find(group); known != objects_.end()) return known->second;
  }
  MovingObject object;
  object.mesh = product_.bodies[group.front()].mesh;
  object.X_WB = product_.bodies[group.front()].X_WB;
  object.required = usualClearance(radiusAboutOrigin(*object.mesh));
  if (group.size() > 1) {
    Box3 box;
    std::vector<MeshPtr> whole;
    for (const std::size_t body : group) {
      box.extend(prepared_.boxOf(body));
      whole.push_back(product_.bodies[body].mesh);
      object.required = std::min(object.required, usualClearance(radiusAboutOrigin(*whole.back())));
    }
    object.X_WB = Pose::translation(box.center());
    object.mesh = joined(group, whole, object.X_WB);
  }
  object.radius = radiusAboutOrigin(*object.mesh);
  const std::lock_guard lock(mutex_);
  return objects_.try_emplace(group, std::move(object)).first->second;
}

MeshPtr MotionWorlds::joined(const BodyGroup& bodies, const std::vector<MeshPtr>& meshes, const Pose& X_WG) const {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    append(mesh, transformed(*meshes[i], inverse(X_WG) * product_.bodies[bodies[i]].X_WB));
  }
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// What these bodies of the group are taken to be against the other one, in the group's frame.
MeshPtr MotionWorlds::meshAgainst(const BodyGroup& group, const BodyGroup& bodies, std::size_t other) {
  if (group.size() == 1) return fits_.meshAgainst(group.front(), other);
  std::vector<MeshPtr> meshes;
  bool thinner = bodies.size() < group.size();
  for (const std::size_t body : bodies) {
    meshes.push_back(fits_.meshAgainst(body, other));
    thinner = thinner || meshes.back() != product_.bodies[body].mesh;
  }
  const MovingObject& whole = object(group);
  if (!thinner) return whole.mesh;
  const std::pair key{bodies, meshes};
  {
    const std::lock_guard lock(mutex_);
    const auto& known = joined_[whole.mesh];
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  MeshPtr mesh = joined(bodies, meshes, whole.X_WB);
  const std::lock_guard lock(mutex_);
  return joined_[whole.mesh].try_emplace(key, std::move(mesh)).first->second;
}

MotionWorld MotionWorlds::world(const BodyGroup& group, const BodySet& present) {
  MotionWorld motion;
  std::vector<PreparedBodies::Against> obstacles;
  for (const std::size_t other : bodiesIn(without(present, group))) {
    // Bodies of the group for which the other one is the same mesh move past it together.
    std::vector<std::pair<MeshPtr, BodyGroup>> parts;
    for (const std::size_t body : group) {
      const MeshPtr& obstacle = fits_.obstacleFor(body, other);
      const auto same = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.first == obstacle; });
      if (same != parts.end()) {
        same->second.push_back(body);
      } else {
        parts.push_back({obstacle, {body}});
      }
    }
    for (const auto& [obstacle, bodies] : parts) {
      motion.bodies.push_back(other);
      obstacles.push_back({other, meshAgainst(group, bodies, other), obstacle});
    }
  }
  motion.world = prepared_.world(object(group).mesh, obstacles);
  return motion;
}

CollisionWorldPtr MotionWorlds::pair(std::size_t body, std::size_t other) {
  return prepared_.world(product_.bodies[body].mesh,
                         {{other, fits_.meshAgainst(body, other), fits_.obstacleFor(body, other)}});
}

ParameterValues MotionWorlds::parameters(const BodyGroup& group) {
  const MovingObject& moving = object(group);
  ParameterValues parameters(moving.radius);
  static_cast<void>(parameters.set(ParameterId::Slots, 1.0));
  static_cast<void>(parameters.set(ParameterId::RequiredClearance, moving.required));
  return parameters;
}

Box3 MotionWorlds::sweptBy(const BodyGroup& group, const std::vector<PathPoint>& path) {
  const MovingObject& moving = object(group);
  const Box3 box = sweptBox(*moving.mesh, configurationsOf(path));
  const Vector3 margin = Vector3::Constant(2.0 * moving.required);
  return {box.min() - margin, box.max() + margin};
}

void nameByProduct(MotionCertificate& certificate, const std::vector<std::size_t>& bodies) {
  const auto rename = [&](NearestObstacle& nearest) {
    if (nearest.body >= 0) nearest.body = static_cast<int>(bodies[static_cast<std::size_t>(nearest.body)]);
  };
  rename(certificate.nearest);
  for (EdgeCertificate& edge : certificate.edges) rename(edge.nearest);
}

}  // namespace glissade
