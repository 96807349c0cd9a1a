#include "engine/sequence/motion_world.h"

#include <algorithm>

#include "engine/base/tolerances.h"
#include "engine/sequence/demanded_steps.h"
#include "engine/sequence/swept_box.h"

namespace glissade {
namespace {

/// Factor that raises a distance above the result of a judge with other meshes and another rounding.
constexpr double kRaised = 1.02;

double usualClearance(double radius) { return ParameterValues(radius)[ParameterId::RequiredClearance]; }

}  // namespace

MotionWorlds::MotionWorlds(const AssembledProduct& product, const ProductFits& fits, Forbidden forbidden)
    : product_(product), fits_(fits), forbidden_(std::move(forbidden)), prepared_(*fits.prepared()) {}

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

/// The mesh of these bodies of the group, each replaced by its entry in `meshes`, in the group's frame.
MeshPtr MotionWorlds::meshOf(const BodyGroup& group, const BodyGroup& bodies, const std::vector<MeshPtr>& meshes) {
  if (group.size() == 1) return meshes.front();
  bool thinner = bodies.size() < group.size();
  for (std::size_t i = 0; i < bodies.size(); ++i) thinner = thinner || meshes[i] != product_.bodies[bodies[i]].mesh;
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

MeshPtr MotionWorlds::meshAgainst(const BodyGroup& group, const Part& part) {
  std::vector<MeshPtr> meshes;
  for (const std::size_t body : part.bodies) meshes.push_back(fits_.meshAgainst(body, part.other));
  return meshOf(group, part.bodies, meshes);
}

MeshPtr MotionWorlds::wholeOf(const BodyGroup& group, const BodyGroup& bodies) {
  std::vector<MeshPtr> meshes;
  for (const std::size_t body : bodies) meshes.push_back(product_.bodies[body].mesh);
  return meshOf(group, bodies, meshes);
}

std::vector<MotionWorlds::Part> MotionWorlds::partsAgainst(const BodyGroup& group, std::size_t other) const {
  std::vector<Part> parts;
  for (const std::size_t body : group) {
    const MeshPtr& obstacle = fits_.obstacleFor(body, other);
    const bool screwed = fits_.threadOf(body, other) != nullptr;
    const auto same = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
      return part.obstacle == obstacle && part.screwed == screwed;
    });
    if (same != parts.end()) {
      same->bodies.push_back(body);
    } else {
      parts.push_back({other, obstacle, screwed, {body}});
    }
  }
  return parts;
}

/// `parts`: the obstacles of the group's world.
std::vector<ThreadPair> MotionWorlds::threadsOf(const BodyGroup& group, const std::vector<Part>& parts) {
  std::vector<ThreadPair> pairs;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].screwed) continue;
    for (const std::size_t body : parts[i].bodies) {
      ThreadRule rule = fits_.threadOf(body, parts[i].other)->rule;
      rule.obstacle = static_cast<int>(i);
      rule.assembled = {object(group).X_WB};
      pairs.emplace_back(rule, *wholeOf(group, {body}), product_.bodies[parts[i].other]);
    }
  }
  return pairs;
}

MotionWorld MotionWorlds::world(const BodyGroup& group, const BodySet& present) {
  MotionWorld motion = withoutDirections(group, present);
  std::vector<DirectedBody> directed = directedBodies(group, present);
  if (directed.empty()) return motion;
  auto rule = std::make_shared<const DirectionRule>(object(group).X_WB, std::move(directed));
  motion.world = motion.world->withForbidden(std::make_shared<const ForbiddenSpace>(std::move(rule)));
  return motion;
}

std::vector<DirectedBody> MotionWorlds::directedBodies(const BodyGroup& group, const BodySet& present) {
  std::vector<DirectedBody> directed;
  if (forbidden_.empty()) return directed;
  const BodySet others = without(present, group);
  for (const std::size_t body : group) {
    if (forbidden_[body].empty()) continue;
    const RigidBody& own = product_.bodies[body];
    DirectedBody each{own.mesh, inverse(object(group).X_WB) * own.X_WB, forbidden_[body], {}, 0.0};
    each.apart = kRaised * tolerance::kTouching * radiusAboutOrigin(*own.mesh);
    for (const std::size_t other : touchedBy(body)) {
      if (others[other]) each.beside.push_back(product_.bodies[other]);
    }
    directed.push_back(std::move(each));
  }
  return directed;
}

/// Contacts in the whole product, so that a result holds for every subset of bodies. A body without contacts counts as
/// touching all others.
std::vector<std::size_t> MotionWorlds::touchedBy(std::size_t body) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = touched_.find(body); known != touched_.end()) return known->second;
  }
  const double distance = kRaised * tolerance::kTouching * radiusAboutOrigin(*product_.bodies[body].mesh);
  std::vector<std::size_t> all;
  std::vector<std::size_t> touched;
  for (std::size_t other = 0; other < product_.bodies.size(); ++other) {
    if (other == body) continue;
    all.push_back(other);
    if (touch(body, other, distance)) touched.push_back(other);
  }
  const std::lock_guard lock(mutex_);
  return touched_.try_emplace(body, touched.empty() ? all : touched).first->second;
}

bool MotionWorlds::touch(std::size_t body, std::size_t other, double distance) {
  const RigidBody& own = product_.bodies[body];
  return boxOf(body).exteriorDistance(boxOf(other)) <= distance &&
         !prepared_.world(own.mesh, {{other, own.mesh}})->makeQuery()->clearAbove(own.X_WB, distance);
}

MotionWorld MotionWorlds::withoutDirections(const BodyGroup& group, const BodySet& present) {
  std::vector<Part> parts;
  for (const std::size_t other : bodiesIn(without(present, group))) {
    for (Part& part : partsAgainst(group, other)) parts.push_back(std::move(part));
  }
  MotionWorld motion;
  std::vector<PreparedBodies::Against> obstacles;
  for (const Part& part : parts) {
    motion.bodies.push_back(part.other);
    obstacles.push_back({part.other, meshAgainst(group, part), part.obstacle});
  }
  const MeshPtr& mesh = object(group).mesh;
  motion.world = prepared_.world(mesh, obstacles);
  std::vector<ThreadPair> threads = threadsOf(group, parts);
  if (threads.empty()) return motion;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].screwed) obstacles[i] = {parts[i].other, wholeOf(group, parts[i].bodies)};
  }
  motion.world = motion.world->withThreads(std::move(threads), prepared_.world(mesh, obstacles));
  return motion;
}

bool MotionWorlds::mayBegin(const Vector3& direction, std::size_t body) const {
  return forbidden_.empty() || !isForbidden(direction, forbidden_[body]);
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
