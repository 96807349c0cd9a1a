#include <algorithm>
#include <limits>

#include "engine/collision/collision_query.h"
#include "engine/collision/coordinate_rounding.h"
#include "engine/collision/fcl_query.h"
#include "engine/collision/grouped_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/collision/screw_profile.h"
#include "engine/collision/solids.h"
#include "engine/collision/threaded_query.h"

namespace glissade {

struct CollisionWorld::Impl {
  CollisionBackend backend = CollisionBackend::Kernel;
  std::shared_ptr<const std::vector<RigidBody>> obstacles;
  Box3 obstaclesBox;
  MeshPtr object;
  double objectRadius = 0.0;
  std::shared_ptr<const MotionBound> motionBound;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const KernelGeometry> kernel;  ///< of the backend
  std::shared_ptr<const FclGeometry> fcl;        ///< of the backend
  std::vector<ObjectVariant> variants;
  std::vector<ObstacleGroup> groups;             ///< where there are variants: these answer, and not the three above
  std::shared_ptr<const ThreadedWorld> threads;  ///< null: there are none
};

namespace {

/// Surfaces by one of the backends, containment by our own test of solids.
class SolidQuery final : public CollisionQuery {
 public:
  SolidQuery(std::unique_ptr<SurfaceQuery> surfaces, const CollisionWorld::Impl& world)
      : surfaces_(std::move(surfaces)),
        solids_(world.solids),
        motionBound_(world.motionBound),
        obstacles_(world.obstacles),
        object_(world.object) {}

  bool collides(const Pose& X_WB) override {
    ++counts_.collision;
    return inCollision(X_WB);
  }

  std::optional<int> collidingBody(const Pose& X_WB) override {
    ++counts_.collision;
    return bodyInCollision(X_WB);
  }

  NearestObstacle nearestObstacle(const Pose& X_WB) override {
    ++counts_.distance;
    if (const auto body = bodyInCollision(X_WB)) {
      NearestObstacle touching;
      touching.body = *body;
      return touching;
    }
    return surfaces_->nearest(X_WB, std::numeric_limits<double>::infinity());
  }

  double distanceUpTo(const Pose& X_WB, double enough) override {
    ++counts_.distance;
    return inCollision(X_WB) ? 0.0 : surfaces_->nearest(X_WB, enough).distance;
  }

  bool clearAbove(const Pose& X_WB, double bound) override {
    ++counts_.distance;
    return !surfaces_->isWithin(X_WB, bound) && !solids_->containment(X_WB);
  }

  MotionCheck checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                          const StopToken& stop) override {
    ++counts_.motion;
    if (!resolvesClearance(from, to, motionBound_->objectRadius(), required)) return {};
    auto check = surfaces_->checkMotion(from, to, required, seek, stop);
    if (!check) {
      const MotionCertificate certificate = certifyMotion(*this, from, to, required, stop);
      check = {certificate.status, certificate.certified, certificate.at, certificate.distanceQueries};
    } else if (check->certified > 0.0 && solids_->containment(from)) {
      // What touches nothing is inside all the way, or nowhere.
      check = {CertificateStatus::Violated, 0.0, 0.0, check->configurations};
    }
    return *check;
  }

  /// What touches nothing is inside of nothing all the way if it is so at the beginning.
  double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough) override {
    ++counts_.motion;
    if (solids_->containment(from)) return 0.0;
    std::vector<Triangle> fixed;
    for (const RigidBody& body : *obstacles_) addTriangles(*body.mesh, body.X_WB, fixed);
    std::vector<Triangle> moving;
    addTriangles(*object_, from, moving);
    return screwDistance(moving, fixed, screw, advance, enough);
  }

  const MotionBound& motionBound() const override { return *motionBound_; }
  const QueryCounts& counts() const override { return counts_; }

 private:
  static void addTriangles(const TriangleMesh& mesh, const Pose& X_WM, std::vector<Triangle>& triangles) {
    std::vector<Vector3> placed;
    for (const Vector3& vertex : mesh.vertices) placed.push_back(X_WM * vertex);
    for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({placed[a], placed[b], placed[c]});
  }

  bool inCollision(const Pose& X_WB) { return surfaces_->touches(X_WB) || solids_->containment(X_WB); }

  std::optional<int> bodyInCollision(const Pose& X_WB) {
    const std::optional<int> touching = surfaces_->touchingBody(X_WB);
    return touching ? touching : solids_->containment(X_WB);
  }

  std::unique_ptr<SurfaceQuery> surfaces_;
  std::shared_ptr<const Solids> solids_;
  std::shared_ptr<const MotionBound> motionBound_;
  std::shared_ptr<const std::vector<RigidBody>> obstacles_;
  MeshPtr object_;
  QueryCounts counts_;
};

/// With what depends on the obstacles.
std::unique_ptr<CollisionWorld::Impl> prepared(std::vector<RigidBody> obstacles, const TriangleMesh& object,
                                               CollisionBackend backend, std::shared_ptr<const Solids> solids) {
  auto impl = std::make_unique<CollisionWorld::Impl>();
  impl->backend = backend;
  for (const RigidBody& body : obstacles) impl->obstaclesBox.extend(boundingBox(*body.mesh, body.X_WB));
  impl->solids = std::move(solids);
  if (backend == CollisionBackend::Kernel) {
    impl->kernel = std::make_shared<const KernelGeometry>(obstacles, object);
  } else {
    impl->fcl = makeFclGeometry(obstacles, object);
  }
  impl->obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(obstacles));
  return impl;
}

void addTo(std::vector<ObjectVariant>& variants, const MeshPtr& object, int obstacle) {
  const auto known = std::find_if(variants.begin(), variants.end(),
                                  [&](const ObjectVariant& variant) { return variant.object == object; });
  if (known != variants.end()) {
    known->obstacles.push_back(obstacle);
  } else {
    variants.push_back({object, {obstacle}});
  }
}

}  // namespace

CollisionWorld::CollisionWorld(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
CollisionWorld::~CollisionWorld() = default;

CollisionWorldPtr CollisionWorld::build(std::vector<RigidBody> obstacles, MeshPtr object, CollisionBackend backend) {
  auto solids = std::make_shared<const Solids>(obstacles, *object);
  auto impl = prepared(std::move(obstacles), *object, backend, std::move(solids));
  return finished(std::move(impl), std::move(object));
}

CollisionWorldPtr CollisionWorld::compose(
    const PreparedObject& object,
    const std::vector<std::pair<const PreparedObstacle*, const PreparedObject*>>& obstacles) {
  const auto about = [](const PreparedObject& moving) {
    auto impl = std::make_unique<Impl>();
    impl->object = moving.mesh;
    impl->objectRadius = moving.radius;
    impl->motionBound = moving.motionBound;
    return impl;
  };
  auto impl = about(object);
  std::vector<RigidBody> bodies;
  for (const auto& [obstacle, moving] : obstacles) {
    const auto number = static_cast<int>(bodies.size());
    bodies.push_back(obstacle->body);
    impl->obstaclesBox.extend(obstacle->box);
    if (moving->mesh != object.mesh) addTo(impl->variants, moving->mesh, number);
    auto pair = about(*moving);
    pair->obstacles = std::make_shared<const std::vector<RigidBody>>(1, obstacle->body);
    pair->obstaclesBox = obstacle->box;
    pair->solids = std::make_shared<const Solids>(obstacle->solid, moving->solid);
    pair->kernel = std::make_shared<const KernelGeometry>(obstacle->scale, obstacle->tree, moving->tree);
    impl->groups.push_back({CollisionWorldPtr(new CollisionWorld(std::move(pair))), {number}});
  }
  impl->obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(bodies));
  if (impl->groups.empty()) return build({}, object.mesh);
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

CollisionWorldPtr CollisionWorld::withObject(MeshPtr object) const {
  auto impl = std::make_unique<Impl>(*impl_);
  impl->threads.reset();
  impl->solids = std::make_shared<const Solids>(*impl_->solids, *object);
  if (impl_->kernel) {
    impl->kernel = std::make_shared<const KernelGeometry>(*impl_->kernel, *object);
  } else {
    impl->fcl = makeFclGeometry(*impl_->obstacles, *object);
  }
  return finished(std::move(impl), std::move(object));
}

CollisionWorldPtr CollisionWorld::withObjects(const std::function<MeshPtr(const TriangleMesh&)>& change) const {
  if (impl_->threads) {
    auto threads = std::make_shared<ThreadedWorld>(*impl_->threads);
    threads->whole = threads->whole->withObjects(change);
    return withoutThreads()->withObjects(change)->withThreaded(std::move(threads));
  }
  if (impl_->groups.empty()) return withObject(change(*impl_->object));
  auto impl = std::make_unique<Impl>(*impl_);
  for (ObjectVariant& variant : impl->variants) variant.object = change(*variant.object);
  for (ObstacleGroup& group : impl->groups) group.world = group.world->withObjects(change);
  return finished(std::move(impl), change(*impl_->object));
}

/// The obstacles that no variant is for keep the whole object.
CollisionWorldPtr CollisionWorld::withVariants(std::vector<ObjectVariant> variants) const {
  if (variants.empty()) {
    if (!impl_->groups.empty()) return build(obstacles(), impl_->object, backend());
    return impl_->threads ? withoutThreads() : shared_from_this();
  }
  auto impl = std::make_unique<Impl>();
  impl->backend = impl_->backend;
  impl->obstacles = impl_->obstacles;
  impl->obstaclesBox = impl_->obstaclesBox;
  std::vector<ObjectVariant> groups{{impl_->object, {}}};
  std::vector<bool> own(impl->obstacles->size(), false);
  for (ObjectVariant& variant : variants) {
    std::sort(variant.obstacles.begin(), variant.obstacles.end());
    for (const int body : variant.obstacles) own[static_cast<std::size_t>(body)] = true;
    groups.push_back(variant);
  }
  for (std::size_t body = 0; body < own.size(); ++body) {
    if (!own[body]) groups.front().obstacles.push_back(static_cast<int>(body));
  }
  for (const ObjectVariant& group : groups) {
    std::vector<RigidBody> bodies;
    for (const int body : group.obstacles) bodies.push_back((*impl->obstacles)[static_cast<std::size_t>(body)]);
    if (!bodies.empty()) impl->groups.push_back({build(std::move(bodies), group.object, backend()), group.obstacles});
  }
  impl->variants = std::move(variants);
  return finished(std::move(impl), impl_->object);
}

CollisionWorldPtr CollisionWorld::withThreads(std::vector<ThreadPair> pairs, CollisionWorldPtr whole) const {
  auto threads = std::make_shared<ThreadedWorld>();
  threads->pairs = std::move(pairs);
  threads->whole = std::move(whole);
  return withThreaded(std::move(threads));
}

CollisionWorldPtr CollisionWorld::withThreaded(std::shared_ptr<const ThreadedWorld> threads) const {
  auto impl = std::make_unique<Impl>(*impl_);
  impl->threads = std::move(threads);
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

CollisionWorldPtr CollisionWorld::withoutThreads() const { return withThreaded(nullptr); }

CollisionWorldPtr CollisionWorld::updated(std::vector<RigidBody> obstacles, MeshPtr object) const {
  if (!impl_->solids) return build(std::move(obstacles), std::move(object), impl_->backend);
  const auto isSame = [](const RigidBody& a, const RigidBody& b) { return a.mesh == b.mesh && a.X_WB == b.X_WB; };
  const std::vector<RigidBody>& before = *impl_->obstacles;
  const bool sameObject = object == impl_->object;
  if (!std::equal(before.begin(), before.end(), obstacles.begin(), obstacles.end(), isSame)) {
    auto solids =
        std::make_shared<const Solids>(*impl_->solids, before, obstacles, sameObject ? nullptr : object.get());
    auto impl = prepared(std::move(obstacles), *object, impl_->backend, std::move(solids));
    return finished(std::move(impl), std::move(object));
  }
  // Names, colours and mobility may have changed.
  auto impl = std::make_unique<Impl>(sameObject ? *impl_ : *withObject(object)->impl_);
  impl->threads.reset();
  impl->obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(obstacles));
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

CollisionWorldPtr CollisionWorld::withBackend(CollisionBackend backend) const {
  const CollisionWorldPtr whole = build(*impl_->obstacles, impl_->object, backend);
  const CollisionWorldPtr other = impl_->variants.empty() ? whole : whole->withVariants(impl_->variants);
  if (!impl_->threads) return other;
  auto threads = std::make_shared<ThreadedWorld>(*impl_->threads);
  threads->whole = threads->whole->withBackend(backend);
  return other->withThreaded(std::move(threads));
}

/// With what depends on the object alone.
CollisionWorldPtr CollisionWorld::finished(std::unique_ptr<Impl> impl, MeshPtr object) {
  impl->objectRadius = radiusAboutOrigin(*object);
  impl->motionBound = std::make_shared<const MotionBound>(*object);
  impl->object = std::move(object);
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

const std::vector<RigidBody>& CollisionWorld::obstacles() const { return *impl_->obstacles; }
const TriangleMesh& CollisionWorld::object() const { return *impl_->object; }
double CollisionWorld::objectRadius() const { return impl_->objectRadius; }
const Box3& CollisionWorld::obstaclesBox() const { return impl_->obstaclesBox; }
CollisionBackend CollisionWorld::backend() const { return impl_->backend; }
const std::vector<ObjectVariant>& CollisionWorld::variants() const { return impl_->variants; }

const std::vector<ThreadPair>& CollisionWorld::threads() const {
  static const std::vector<ThreadPair> none;
  return impl_->threads ? impl_->threads->pairs : none;
}

std::unique_ptr<CollisionQuery> CollisionWorld::makeQuery() const {
  if (impl_->threads) return std::make_unique<ThreadedQuery>(withoutThreads()->makeQuery(), impl_->threads);
  if (!impl_->groups.empty()) return std::make_unique<GroupedQuery>(impl_->groups, impl_->motionBound);
  std::unique_ptr<SurfaceQuery> surfaces;
  if (impl_->kernel) {
    surfaces = std::make_unique<KernelQuery>(impl_->kernel);
  } else {
    surfaces = std::make_unique<FclSurfaceQuery>(impl_->fcl);
  }
  return std::make_unique<SolidQuery>(std::move(surfaces), *impl_);
}

}  // namespace glissade
