#include <glissade/world.h>

#include "engine/api/values.h"
#include "engine/collision/motion_certificate.h"

namespace glissade::api {
namespace {

constexpr const char* kAsking = "checking a motion";

/// The fault of the arguments of a question about a motion.
std::optional<Diagnostic> faultOfMotion(const Pose& from, const Pose& to, double length, const char* nameOfLength) {
  if (auto fault = faultOfPose(from, "from")) return fault;
  if (auto fault = faultOfPose(to, "to")) return fault;
  // The negation refuses NaN, too.
  if (!(length > 0.0)) return wrongArgument(nameOfLength, "is not above 0");
  return std::nullopt;
}

}  // namespace

Result<bool> Query::collides(const Pose& X_WB) {
  if (const auto fault = faultOfPose(X_WB, "X_WB")) return *fault;
  return attempt<bool>(kAsking, [&] { return Result<bool>(impl_->query->collides(enginePose(X_WB))); });
}

Result<Nearest> Query::nearest(const Pose& X_WB) {
  if (const auto fault = faultOfPose(X_WB, "X_WB")) return *fault;
  return attempt<Nearest>(kAsking, [&] {
    return Result<Nearest>(publicNearest(impl_->query->nearestObstacle(enginePose(X_WB)), *impl_->world));
  });
}

Result<Certificate> Query::certify(const Pose& from, const Pose& to, double required, const StopToken& stop) {
  if (const auto fault = faultOfMotion(from, to, required, "required")) return *fault;
  return attempt<Certificate>(kAsking, [&] {
    const auto proof = certifyMotion(*impl_->query, enginePose(from), enginePose(to), required, stop);
    return Result<Certificate>(publicCertificate(proof, *impl_->world));
  });
}

Result<double> Query::freeShare(const Pose& from, const Pose& to, double step, const StopToken& stop) {
  if (const auto fault = faultOfMotion(from, to, step, "step")) return *fault;
  return attempt<double>(kAsking, [&]() -> Result<double> {
    if (impl_->query->collides(enginePose(from))) return wrongArgument("from", "is in collision");
    return freeFraction(*impl_->query, enginePose(from), enginePose(to), step, stop);
  });
}

Result<World> World::make(const std::vector<Body>& obstacles, const Mesh& object) {
  auto bodies = engineBodies(obstacles, Mobility::Static, "obstacles");
  if (!bodies) return bodies.error();
  return attempt<World>("preparing the world", [&] {
    return Result<World>(valueOf<World>({CollisionWorld::build(*bodies, object.impl().mesh)}));
  });
}

std::vector<Body> World::obstacles() const { return publicBodies(impl().world->obstacles()); }

Mesh World::object() const {
  const CollisionWorldPtr& world = impl().world;
  return valueOf<Mesh>({MeshPtr(world, &world->object())});
}

double World::objectRadius() const { return impl().world->objectRadius(); }

Query World::query() const {
  const CollisionWorldPtr& world = impl().world;
  return Query(std::make_shared<Query::Impl>(Query::Impl{world, world->makeQuery()}));
}

}  // namespace glissade::api
