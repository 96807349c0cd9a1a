#include <algorithm>

#include "engine/collision/collision_query.h"
#include "engine/collision/fcl_query.h"
#include "engine/collision/solids.h"

namespace glissade {

struct CollisionWorld::Impl {
  std::vector<RigidBody> obstacles;
  MeshPtr object;
  double objectRadius = 0.0;
  Box3 obstaclesBox;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const FclGeometry> fcl;
};

namespace {

/// Surfaces by FCL, containment by our own test of solids.
class SolidQuery final : public CollisionQuery {
 public:
  SolidQuery(std::shared_ptr<const FclGeometry> fcl, std::shared_ptr<const Solids> solids)
      : surfaces_(std::move(fcl)), solids_(std::move(solids)) {}

  bool collides(const Pose& X_WB) override {
    ++counts_.collision;
    return surfaces_.surfacesTouch(X_WB) || solids_->containment(X_WB);
  }

  std::optional<int> collidingBody(const Pose& X_WB) override {
    ++counts_.collision;
    const std::vector<int> touching = surfaces_.touchingBodies(X_WB);
    if (!touching.empty()) return touching.front();
    return solids_->containment(X_WB);
  }

  NearestObstacle nearestObstacle(const Pose& X_WB) override {
    ++counts_.distance;
    NearestObstacle nearest = surfaces_.nearest(X_WB);
    if (nearest.distance <= 0.0) return nearest;
    if (const auto body = solids_->containment(X_WB)) {
      nearest.distance = 0.0;
      nearest.body = *body;
    }
    return nearest;
  }

  const QueryCounts& counts() const override { return counts_; }

 private:
  FclSurfaceQuery surfaces_;
  std::shared_ptr<const Solids> solids_;
  QueryCounts counts_;
};

}  // namespace

CollisionWorld::CollisionWorld(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
CollisionWorld::~CollisionWorld() = default;

std::shared_ptr<const CollisionWorld> CollisionWorld::build(std::vector<RigidBody> obstacles, MeshPtr object) {
  auto impl = std::make_unique<Impl>();
  impl->objectRadius = radiusAboutOrigin(*object);
  for (const RigidBody& body : obstacles) impl->obstaclesBox.extend(boundingBox(*body.mesh, body.X_WB));
  impl->solids = std::make_shared<const Solids>(obstacles, *object);
  impl->fcl = makeFclGeometry(obstacles, *object);
  impl->obstacles = std::move(obstacles);
  impl->object = std::move(object);
  return std::shared_ptr<const CollisionWorld>(new CollisionWorld(std::move(impl)));
}

const std::vector<RigidBody>& CollisionWorld::obstacles() const { return impl_->obstacles; }
const TriangleMesh& CollisionWorld::object() const { return *impl_->object; }
double CollisionWorld::objectRadius() const { return impl_->objectRadius; }
const Box3& CollisionWorld::obstaclesBox() const { return impl_->obstaclesBox; }

std::unique_ptr<CollisionQuery> CollisionWorld::makeQuery() const {
  return std::make_unique<SolidQuery>(impl_->fcl, impl_->solids);
}

}  // namespace glissade
