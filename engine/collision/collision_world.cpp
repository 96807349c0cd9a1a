#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "engine/base/tolerances.h"
#include "engine/collision/collision_query.h"
#include "engine/collision/coordinate_rounding.h"
#include "engine/collision/forbidding_query.h"
#include "engine/collision/grouped_query.h"
#include "engine/collision/motion_bound.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/collision/screw_profile.h"
#include "engine/collision/solids.h"
#include "engine/collision/threaded_query.h"
#include "engine/collision/world_geometry.h"

namespace glissade {
namespace {

/// The data that queries of a world need.
struct QueryGeometry {
  WorldGeometry geometry;
  std::shared_ptr<const MotionBound> motionBound;
};

/// QueryGeometry that is prepared when it is first requested. Any number of threads may request it: the first one
/// prepares, the others wait.
class LaterGeometry {
 public:
  explicit LaterGeometry(std::function<QueryGeometry()> prepare) : prepare_(std::move(prepare)) {}

  /// After an exception (no memory) the next call prepares again.
  const QueryGeometry& get() const {
    std::call_once(once_, [this] {
      prepared_ = prepare_();
      prepare_ = nullptr;
      isPrepared_ = true;
    });
    return prepared_;
  }
  bool isPrepared() const { return isPrepared_; }

 private:
  mutable std::once_flag once_;
  mutable std::function<QueryGeometry()> prepare_;
  mutable QueryGeometry prepared_;
  mutable std::atomic<bool> isPrepared_{false};
};

}  // namespace

struct CollisionWorld::Impl {
  WorldGeometry geometry;  ///< backend, bodies and their box, if the geometry is prepared later
  double objectRadius = 0.0;
  std::shared_ptr<const MotionBound> motionBound;
  std::shared_ptr<const LaterGeometry> later;  ///< null: all is prepared

  const WorldGeometry& prepared() const { return later ? later->get().geometry : geometry; }
  std::vector<ObjectVariant> variants;
  std::vector<ObstacleGroup> groups;  ///< groups that answer queries instead of `geometry`, if there are variants
  CollisionWorldPtr whole;            ///< world from which withVariants() was called
  std::shared_ptr<const ThreadedWorld> threads;     ///< null: there are none
  std::shared_ptr<const ForbiddenSpace> forbidden;  ///< null: nothing is forbidden
};

namespace {

/// Lower bound that the proof of a screw motion aims at, as a multiple of the default clearance of a path plus the
/// deviation of its chords from the screw motion.
constexpr double kWantedClearances = 2.0;

/// Queries of solids: surfaces by one of the backends, containment by our own test.
class SolidQuery final : public CollisionQuery {
 public:
  SolidQuery(std::unique_ptr<SurfaceQuery> surfaces, const WorldGeometry& geometry,
             std::shared_ptr<const MotionBound> motionBound)
      : surfaces_(std::move(surfaces)),
        solids_(geometry.solids),
        motionBound_(std::move(motionBound)),
        obstacles_(geometry.obstacles),
        object_(geometry.object) {}

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
      // An object that touches nothing is inside an obstacle on the whole motion, or nowhere.
      check = {CertificateStatus::Violated, 0.0, 0.0, check->configurations};
    }
    return *check;
  }

  /// An object that touches nothing on the motion and is inside no obstacle at its beginning is inside none.
  double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough, double off) override {
    ++counts_.motion;
    if (solids_->containment(from)) return 0.0;
    std::vector<Triangle> moving;
    addTriangles(*object_, from, moving);
    const Box3 swept = boxOfScrew(moving, screw, advance);
    std::vector<Triangle> fixed;
    for (const RigidBody& body : *obstacles_) {
      if (swept.exteriorDistance(boundingBox(*body.mesh, body.X_WB)) > enough) continue;
      addTriangles(*body.mesh, body.X_WB, fixed);
    }
    const double wanted = kWantedClearances * (tolerance::kRequiredClearance * motionBound_->objectRadius() + off);
    return screwDistance(moving, fixed, screw, advance, enough, wanted);
  }

  const MotionBound& motionBound() const override { return *motionBound_; }
  QueryCounts counts() const override {
    QueryCounts counts = counts_;
    counts.pairs = surfaces_->pairs();
    return counts;
  }

 private:
  static void addTriangles(const TriangleMesh& mesh, const Pose& X_WM, std::vector<Triangle>& triangles) {
    std::vector<Vector3> placed;
    for (const Vector3& vertex : mesh.vertices) placed.push_back(X_WM * vertex);
    for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({placed[a], placed[b], placed[c]});
  }

  /// Bounding box of a cylinder about the axis that contains the triangles on the whole motion.
  static Box3 boxOfScrew(const std::vector<Triangle>& moving, const ScrewAxis& screw, double advance) {
    Box3 axis;
    double radius = 0.0;
    for (const Triangle& triangle : moving) {
      for (const Vector3& p : triangle) {
        const double along = (p - screw.point_W).dot(screw.axis_W);
        const Vector3 foot = screw.point_W + along * screw.axis_W;
        radius = std::max(radius, (p - foot).norm());
        axis.extend(foot).extend(foot + advance * screw.axis_W);
      }
    }
    const Vector3 margin = Vector3::Constant(radius * (1.0 + 1e-9));
    return Box3(axis.min() - margin, axis.max() + margin);
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

std::unique_ptr<CollisionWorld::Impl> consistingOf(WorldGeometry geometry) {
  auto impl = std::make_unique<CollisionWorld::Impl>();
  impl->geometry = std::move(geometry);
  return impl;
}

RigidBody objectAlone(const MeshPtr& object) {
  RigidBody body;
  body.mesh = object;
  return body;
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
  const bool large = isLarge(obstacles);
  if (large || isLarge({objectAlone(object)})) return buildLater(std::move(obstacles), object, backend);
  auto geometry = prepareGeometry(std::move(obstacles), object, backend, large, nullptr);
  return finished(consistingOf(std::move(geometry)), std::move(object));
}

CollisionWorldPtr CollisionWorld::buildLater(std::vector<RigidBody> obstacles, const MeshPtr& object,
                                             CollisionBackend backend) {
  auto impl = std::make_unique<Impl>();
  WorldGeometry& outline = impl->geometry;
  outline.backend = backend;
  outline.object = object;
  for (const RigidBody& body : obstacles) outline.obstaclesBox.extend(boundingBox(*body.mesh, body.X_WB));
  outline.obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(obstacles));
  impl->objectRadius = radiusAboutOrigin(*object);
  impl->later = std::make_shared<const LaterGeometry>([bodies = outline.obstacles, object, backend] {
    return QueryGeometry{prepareGeometry(*bodies, object, backend, isLarge(*bodies), nullptr),
                         std::make_shared<const MotionBound>(*object)};
  });
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

/// Obstacles against which the object has the same replacement form one group.
CollisionWorldPtr CollisionWorld::compose(double scale, const PreparedObject& object,
                                          std::vector<ComposedObstacle> obstacles) {
  if (obstacles.empty()) return build({}, object.mesh);
  const auto about = [](const PreparedObject& moving) {
    auto impl = std::make_unique<Impl>();
    impl->geometry.object = moving.mesh;
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
    impl->geometry.obstaclesBox.extend(composed.box_W);
    if (composed.object->mesh != object.mesh) addTo(impl->variants, composed.object->mesh, number);
    std::vector<int>& group = numbers[composed.object.get()];
    if (group.empty()) objects.push_back(composed.object.get());
    group.push_back(number);
    bodies.push_back(std::move(composed.body));
  }
  for (const PreparedObject* moving : objects) {
    auto group = about(*moving);
    WorldGeometry& geometry = group->geometry;
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
      geometry.obstaclesBox.extend(composed.box_W);
    }
    geometry.obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(own));
    geometry.solids = std::make_shared<const Solids>(std::move(solids), moving->solid);
    geometry.occurrences = std::make_shared<const OccurrenceGeometry>(scale, std::move(occurrences), boxes,
                                                                      moving->tree, moving->solid->box);
    impl->groups.push_back({CollisionWorldPtr(new CollisionWorld(std::move(group))), numbers[moving]});
  }
  impl->geometry.obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(bodies));
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

CollisionWorldPtr CollisionWorld::withObject(MeshPtr object) const {
  if (impl_->forbidden) return withForbidden(nullptr)->withObject(std::move(object))->withForbidden(impl_->forbidden);
  auto geometry = withOtherObject(impl_->prepared(), object);
  return finished(consistingOf(std::move(geometry)), std::move(object));
}

CollisionWorldPtr CollisionWorld::withObjects(const std::function<MeshPtr(const TriangleMesh&)>& change) const {
  if (impl_->forbidden) return withForbidden(nullptr)->withObjects(change)->withForbidden(impl_->forbidden);
  if (impl_->threads) {
    auto threads = std::make_shared<ThreadedWorld>(*impl_->threads);
    threads->whole = threads->whole->withObjects(change);
    return withoutThreads()->withObjects(change)->withThreaded(std::move(threads));
  }
  if (impl_->groups.empty()) return withObject(change(object()));
  auto impl = std::make_unique<Impl>(*impl_);
  impl->whole.reset();
  for (ObjectVariant& variant : impl->variants) variant.object = change(*variant.object);
  for (ObstacleGroup& group : impl->groups) group.world = group.world->withObjects(change);
  return finished(std::move(impl), change(object()));
}

/// Obstacles without a variant keep the whole object.
CollisionWorldPtr CollisionWorld::withVariants(std::vector<ObjectVariant> variants) const {
  if (impl_->forbidden) {
    return withForbidden(nullptr)->withVariants(std::move(variants))->withForbidden(impl_->forbidden);
  }
  if (impl_->whole) return impl_->whole->withVariants(std::move(variants));
  if (variants.empty()) {
    if (!impl_->groups.empty()) return build(obstacles(), impl_->geometry.object, backend());
    return impl_->threads ? withoutThreads() : shared_from_this();
  }
  const WorldGeometry& known = impl_->prepared();
  auto impl = std::make_unique<Impl>();
  impl->geometry.backend = known.backend;
  impl->geometry.obstacles = known.obstacles;
  impl->geometry.obstaclesBox = known.obstaclesBox;
  const bool large = isLarge(*known.obstacles);
  std::vector<ObjectVariant> groups{{known.object, {}}};
  std::vector<bool> own(known.obstacles->size(), false);
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
    for (const int body : group.obstacles) bodies.push_back((*known.obstacles)[static_cast<std::size_t>(body)]);
    if (bodies.empty()) continue;
    auto geometry = prepareGeometry(std::move(bodies), group.object, known.backend, large, &known);
    impl->groups.push_back({finished(consistingOf(std::move(geometry)), group.object), group.obstacles});
  }
  impl->variants = std::move(variants);
  impl->whole = impl_->threads ? withoutThreads() : shared_from_this();
  return finished(std::move(impl), known.object);
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

CollisionWorldPtr CollisionWorld::withForbidden(std::shared_ptr<const ForbiddenSpace> space) const {
  auto impl = std::make_unique<Impl>(*impl_);
  impl->forbidden = std::move(space);
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

ForbiddenRegionsPtr CollisionWorld::forbidden() const {
  return impl_->forbidden ? impl_->forbidden->regions() : nullptr;
}

CollisionWorldPtr CollisionWorld::withoutThreads() const { return withThreaded(nullptr); }

CollisionWorldPtr CollisionWorld::updated(std::vector<RigidBody> obstacles, MeshPtr object) const {
  if (impl_->forbidden) {
    const CollisionWorldPtr other = withForbidden(nullptr)->updated(std::move(obstacles), std::move(object));
    return other->withForbidden(impl_->forbidden);
  }
  if (impl_->whole) return impl_->whole->updated(std::move(obstacles), std::move(object));
  const WorldGeometry& known = impl_->prepared();
  if (!known.solids) return build(std::move(obstacles), std::move(object), known.backend);
  const bool sameObject = object == known.object;
  auto impl = std::make_unique<Impl>();
  if (!std::equal(known.obstacles->begin(), known.obstacles->end(), obstacles.begin(), obstacles.end(), isSamePlaced)) {
    const bool large = isLarge(obstacles);
    impl->geometry = prepareGeometry(std::move(obstacles), object, known.backend, large, &known);
  } else {
    // Names, colours and mobility may have changed.
    impl->geometry = sameObject ? known : withOtherObject(known, object);
    impl->geometry.obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(obstacles));
  }
  if (!sameObject) return finished(std::move(impl), std::move(object));
  impl->objectRadius = impl_->objectRadius;
  impl->motionBound = impl_->later ? impl_->later->get().motionBound : impl_->motionBound;
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

CollisionWorldPtr CollisionWorld::withBackend(CollisionBackend backend) const {
  if (impl_->forbidden) return withForbidden(nullptr)->withBackend(backend)->withForbidden(impl_->forbidden);
  const CollisionWorldPtr whole = build(obstacles(), impl_->geometry.object, backend);
  const CollisionWorldPtr other = impl_->variants.empty() ? whole : whole->withVariants(impl_->variants);
  if (!impl_->threads) return other;
  auto threads = std::make_shared<ThreadedWorld>(*impl_->threads);
  threads->whole = threads->whole->withBackend(backend);
  return other->withThreaded(std::move(threads));
}

/// Completes a world with the data that depend on the object alone.
CollisionWorldPtr CollisionWorld::finished(std::unique_ptr<Impl> impl, MeshPtr object) {
  impl->objectRadius = radiusAboutOrigin(*object);
  impl->motionBound = std::make_shared<const MotionBound>(*object);
  impl->geometry.object = std::move(object);
  return CollisionWorldPtr(new CollisionWorld(std::move(impl)));
}

const std::vector<RigidBody>& CollisionWorld::obstacles() const { return *impl_->geometry.obstacles; }
const TriangleMesh& CollisionWorld::object() const { return *impl_->geometry.object; }
double CollisionWorld::objectRadius() const { return impl_->objectRadius; }
const Box3& CollisionWorld::obstaclesBox() const { return impl_->geometry.obstaclesBox; }
CollisionBackend CollisionWorld::backend() const { return impl_->geometry.backend; }
const std::vector<ObjectVariant>& CollisionWorld::variants() const { return impl_->variants; }

const std::vector<ThreadPair>& CollisionWorld::threads() const {
  static const std::vector<ThreadPair> none;
  return impl_->threads ? impl_->threads->pairs : none;
}

bool CollisionWorld::isPrepared() const { return !impl_->later || impl_->later->isPrepared(); }

std::unique_ptr<CollisionQuery> CollisionWorld::makeQuery() const {
  if (impl_->forbidden) {
    return std::make_unique<ForbiddingQuery>(withForbidden(nullptr)->makeQuery(), impl_->forbidden);
  }
  if (impl_->threads) return std::make_unique<ThreadedQuery>(withoutThreads()->makeQuery(), impl_->threads);
  if (!impl_->groups.empty()) return std::make_unique<GroupedQuery>(impl_->groups, impl_->motionBound);
  const WorldGeometry& geometry = impl_->prepared();
  const auto& motionBound = impl_->later ? impl_->later->get().motionBound : impl_->motionBound;
  std::unique_ptr<SurfaceQuery> surfaces;
  if (geometry.kernel) {
    surfaces = std::make_unique<KernelQuery>(geometry.kernel);
  } else if (geometry.occurrences) {
    surfaces = std::make_unique<OccurrenceQuery>(geometry.occurrences);
  } else {
    surfaces = std::make_unique<FclSurfaceQuery>(geometry.fcl);
  }
  return std::make_unique<SolidQuery>(std::move(surfaces), geometry, motionBound);
}

}  // namespace glissade
