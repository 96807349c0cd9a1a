#include <algorithm>
#include <limits>
#include <map>

#include "engine/collision/collision_query.h"
#include "engine/collision/coordinate_rounding.h"
#include "engine/collision/fcl_query.h"
#include "engine/collision/grouped_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/collision/kernel/occurrence_query.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/prepared_bodies.h"
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
  std::shared_ptr<const KernelGeometry> kernel;           ///< of the backend, of a small world
  std::shared_ptr<const OccurrenceGeometry> occurrences;  ///< of the backend, of a large world
  std::shared_ptr<const FclGeometry> fcl;                 ///< of the backend
  std::vector<ObjectVariant> variants;
  std::vector<ObstacleGroup> groups;             ///< where there are variants: these answer, and not the four above
  CollisionWorldPtr whole;                       ///< that withVariants() was asked of
  std::shared_ptr<const ThreadedWorld> threads;  ///< null: there are none
};

namespace {

/// Surfaces by one of the backends, containment by our own test of solids.
class SolidQuery final : public CollisionQuery {
 public:
  SolidQuery(std::unique_ptr<SurfaceQuery> surfaces, std::shared_ptr<const Solids> solids,
             std::shared_ptr<const MotionBound> motionBound)
      : surfaces_(std::move(surfaces)), solids_(std::move(solids)), motionBound_(std::move(motionBound)) {}

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

  const MotionBound& motionBound() const override { return *motionBound_; }
  const QueryCounts& counts() const override { return counts_; }

 private:
  bool inCollision(const Pose& X_WB) { return surfaces_->touches(X_WB) || solids_->containment(X_WB); }

  std::optional<int> bodyInCollision(const Pose& X_WB) {
    const std::optional<int> touching = surfaces_->touchingBody(X_WB);
    return touching ? touching : solids_->containment(X_WB);
  }

  std::unique_ptr<SurfaceQuery> surfaces_;
  std::shared_ptr<const Solids> solids_;
  std::shared_ptr<const MotionBound> motionBound_;
  QueryCounts counts_;
};

/// Obstacles with more triangles together are a tree for each mesh instead of one tree for all.
constexpr std::size_t kMostTrianglesInOneTree = 200'000;
/// The scale of a large world is kept while the obstacles have this size times it, so that trees are kept too.
constexpr double kSmallestScaledSize = 0x1p-10;
constexpr double kLargestScaledSize = 0x1p10;

bool isSamePlaced(const RigidBody& a, const RigidBody& b) { return a.mesh == b.mesh && a.X_WB == b.X_WB; }

bool isLarge(const std::vector<RigidBody>& obstacles) {
  std::size_t triangles = 0;
  for (const RigidBody& body : obstacles) triangles += body.mesh->triangles.size();
  return triangles > kMostTrianglesInOneTree;
}

/// Prepares the obstacles of a world. What another world has prepared of the same meshes is taken from there.
class ObstaclePreparation {
 public:
  using Impl = CollisionWorld::Impl;

  /// `known`: null where there is no other world.
  ObstaclePreparation(std::vector<RigidBody> obstacles, const Impl* known)
      : obstacles_(std::make_shared<const std::vector<RigidBody>>(std::move(obstacles))),
        known_(known != nullptr && known->solids ? known : nullptr) {
    for (std::size_t i = 0; known_ != nullptr && i < known_->obstacles->size(); ++i) {
      knownByMesh_.emplace((*known_->obstacles)[i].mesh.get(), i);
    }
    placeSolids();
  }

  /// `large`: in two levels.
  std::unique_ptr<Impl> world(const MeshPtr& object, CollisionBackend backend, bool large) const {
    auto impl = std::make_unique<Impl>();
    const bool sameObject = known_ != nullptr && known_->object == object;
    impl->backend = backend;
    impl->obstacles = obstacles_;
    impl->obstaclesBox = box_;
    impl->solids =
        std::make_shared<const Solids>(solids_, sameObject ? known_->solids->object() : Solids::prepare(*object));
    if (backend == CollisionBackend::Fcl) {
      impl->fcl = makeFclGeometry(*obstacles_, *object);
    } else if (large) {
      impl->occurrences = occurrences(*object, sameObject, impl->solids->object()->box);
    } else {
      impl->kernel = std::make_shared<const KernelGeometry>(*obstacles_, *object);
    }
    return impl;
  }

 private:
  void placeSolids() {
    std::map<const TriangleMesh*, Solids::SolidPtr> prepared;
    for (const RigidBody& body : *obstacles_) {
      const auto [first, last] = knownByMesh_.equal_range(body.mesh.get());
      const auto same = std::find_if(
          first, last, [&](const auto& entry) { return isSamePlaced((*known_->obstacles)[entry.second], body); });
      Solids::SolidPtr& solid = prepared[body.mesh.get()];
      if (!solid && first != last) solid = known_->solids->obstacles()[first->second].solid;
      if (!solid) solid = Solids::prepare(*body.mesh);
      const Box3 box =
          same != last ? known_->solids->obstacles()[same->second].box_W : boundingBox(*body.mesh, body.X_WB);
      solids_.push_back({solid, body.X_WB, box});
      box_.extend(box);
    }
  }

  /// Answers do not depend on the scale, which is a power of two.
  double scaleOfLarge() const {
    const double scale = known_ != nullptr && known_->occurrences ? known_->occurrences->scale : kernelScale(box_);
    const double size = scale * box_.diagonal().norm();
    return size > kSmallestScaledSize && size < kLargestScaledSize ? scale : kernelScale(box_);
  }

  std::shared_ptr<const OccurrenceGeometry> occurrences(const TriangleMesh& object, bool sameObject,
                                                        const Box3& objectBox) const {
    const double scale = scaleOfLarge();
    const OccurrenceGeometry* known = known_ != nullptr ? known_->occurrences.get() : nullptr;
    if (known != nullptr && known->scale != scale) known = nullptr;
    std::map<const TriangleMesh*, std::shared_ptr<const BoxTree>> trees;
    std::vector<OccurrenceGeometry::Occurrence> placed;
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < obstacles_->size(); ++i) {
      const RigidBody& body = (*obstacles_)[i];
      std::shared_ptr<const BoxTree>& tree = trees[body.mesh.get()];
      const auto before = knownByMesh_.find(body.mesh.get());
      if (!tree && known != nullptr && before != knownByMesh_.end()) tree = known->occurrences[before->second].tree;
      if (!tree) tree = kernelObstacle(*body.mesh, scale);
      placed.push_back({tree, body.X_WB});
      boxes.push_back(solids_[i].box_W);
    }
    auto moving = known != nullptr && sameObject ? known->object : kernelObject(object, scale);
    return std::make_shared<const OccurrenceGeometry>(scale, std::move(placed), boxes, std::move(moving), objectBox);
  }

  std::shared_ptr<const std::vector<RigidBody>> obstacles_;
  const Impl* known_;
  std::multimap<const TriangleMesh*, std::size_t> knownByMesh_;
  std::vector<Solids::Placed> solids_;
  Box3 box_;
};

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
  const bool large = isLarge(obstacles);
  auto impl = ObstaclePreparation(std::move(obstacles), nullptr).world(object, backend, large);
  return finished(std::move(impl), std::move(object));
}

/// Obstacles that the object is taken alike against are one group.
CollisionWorldPtr CollisionWorld::compose(double scale, const PreparedObject& object,
                                          std::vector<ComposedObstacle> obstacles) {
  if (obstacles.empty()) return build({}, object.mesh);
  const auto about = [](const PreparedObject& moving) {
    auto impl = std::make_unique<Impl>();
    impl->object = moving.mesh;
    impl->objectRadius = moving.radius;
    impl->motionBound = moving.motionBound;
    return impl;
  };
  auto impl = about(object);
  std::vector<RigidBody> bodies;
  std::vector<const PreparedObject*> objects;
  std::map<const PreparedObject*, std::vector<int>> numbers;
  for (ComposedObstacle& composed : obstacles) {
    const auto number = static_cast<int>(bodies.size());
    impl->obstaclesBox.extend(composed.box_W);
    if (composed.object->mesh != object.mesh) addTo(impl->variants, composed.object->mesh, number);
    std::vector<int>& group = numbers[composed.object];
    if (group.empty()) objects.push_back(composed.object);
    group.push_back(number);
    bodies.push_back(std::move(composed.body));
  }
  for (const PreparedObject* moving : objects) {
    auto group = about(*moving);
    std::vector<RigidBody> own;
    std::vector<Solids::Placed> solids;
    std::vector<OccurrenceGeometry::Occurrence> occurrences;
    std::vector<Box3> boxes;
    for (const int number : numbers[moving]) {
      const ComposedObstacle& composed = obstacles[static_cast<std::size_t>(number)];
      own.push_back(bodies[static_cast<std::size_t>(number)]);
      solids.push_back({composed.obstacle->solid, own.back().X_WB, composed.box_W});
      occurrences.push_back({composed.obstacle->tree, own.back().X_WB});
      boxes.push_back(composed.box_W);
      group->obstaclesBox.extend(composed.box_W);
    }
    group->obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(own));
    group->solids = std::make_shared<const Solids>(std::move(solids), moving->solid);
    group->occurrences = std::make_shared<const OccurrenceGeometry>(scale, std::move(occurrences), boxes, moving->tree,
                                                                    moving->solid->box);
    impl->groups.push_back({CollisionWorldPtr(new CollisionWorld(std::move(group))), numbers[moving]});
  }
  impl->obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(bodies));
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

CollisionWorldPtr CollisionWorld::withObject(MeshPtr object) const {
  auto impl = std::make_unique<Impl>(*impl_);
  impl->threads.reset();
  impl->solids = std::make_shared<const Solids>(*impl_->solids, *object);
  if (impl_->kernel) {
    impl->kernel = std::make_shared<const KernelGeometry>(*impl_->kernel, *object);
  } else if (impl_->occurrences) {
    auto occurrences = std::make_shared<OccurrenceGeometry>(*impl_->occurrences);
    occurrences->setObject(kernelObject(*object, occurrences->scale), impl->solids->object()->box);
    impl->occurrences = std::move(occurrences);
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
  impl->whole.reset();
  for (ObjectVariant& variant : impl->variants) variant.object = change(*variant.object);
  for (ObstacleGroup& group : impl->groups) group.world = group.world->withObjects(change);
  return finished(std::move(impl), change(*impl_->object));
}

/// The obstacles that no variant is for keep the whole object.
CollisionWorldPtr CollisionWorld::withVariants(std::vector<ObjectVariant> variants) const {
  if (impl_->whole) return impl_->whole->withVariants(std::move(variants));
  if (variants.empty()) {
    if (!impl_->groups.empty()) return build(obstacles(), impl_->object, backend());
    return impl_->threads ? withoutThreads() : shared_from_this();
  }
  auto impl = std::make_unique<Impl>();
  impl->backend = impl_->backend;
  impl->obstacles = impl_->obstacles;
  impl->obstaclesBox = impl_->obstaclesBox;
  const bool large = isLarge(*impl->obstacles);
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
    if (bodies.empty()) continue;
    auto world = ObstaclePreparation(std::move(bodies), impl_.get()).world(group.object, backend(), large);
    impl->groups.push_back({finished(std::move(world), group.object), group.obstacles});
  }
  impl->variants = std::move(variants);
  impl->whole = impl_->threads ? withoutThreads() : shared_from_this();
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
  if (impl_->whole) return impl_->whole->updated(std::move(obstacles), std::move(object));
  if (!impl_->solids) return build(std::move(obstacles), std::move(object), impl_->backend);
  const std::vector<RigidBody>& before = *impl_->obstacles;
  const bool sameObject = object == impl_->object;
  if (!std::equal(before.begin(), before.end(), obstacles.begin(), obstacles.end(), isSamePlaced)) {
    const bool large = isLarge(obstacles);
    auto impl = ObstaclePreparation(std::move(obstacles), impl_.get()).world(object, impl_->backend, large);
    if (!sameObject) return finished(std::move(impl), std::move(object));
    impl->object = impl_->object;
    impl->objectRadius = impl_->objectRadius;
    impl->motionBound = impl_->motionBound;
    return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
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
  } else if (impl_->occurrences) {
    surfaces = std::make_unique<OccurrenceQuery>(impl_->occurrences);
  } else {
    surfaces = std::make_unique<FclSurfaceQuery>(impl_->fcl);
  }
  return std::make_unique<SolidQuery>(std::move(surfaces), impl_->solids, impl_->motionBound);
}

}  // namespace glissade
