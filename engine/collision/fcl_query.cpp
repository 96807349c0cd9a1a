#include "engine/collision/fcl_query.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>

#include "engine/geometry/fcl_scale.h"

namespace glissade {

/// All lengths are multiplied by `scale`.
class FclGeometry {
 public:
  using Model = fcl::BVHModel<fcl::OBBRSSd>;

  Model obstacles;
  Model object;
  std::vector<int> bodyOf;  ///< body of each triangle of `obstacles`
  double scale = 1.0;

  fcl::Transform3d place(const Pose& X_WB) const {
    fcl::Transform3d transform = toIsometry(X_WB);
    transform.translation() *= scale;
    return transform;
  }
};

namespace {

void addMesh(FclGeometry::Model& model, const TriangleMesh& mesh, double scale) {
  std::vector<fcl::Vector3d> vertices(mesh.vertices.begin(), mesh.vertices.end());
  for (fcl::Vector3d& vertex : vertices) vertex *= scale;
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  model.addSubModel(vertices, triangles);
}

/// Makes FCL fill its static table of functions, which it does at its first use, before there are threads.
void warmUp(const FclGeometry& geometry) {
  FclSurfaceQuery query(std::shared_ptr<const FclGeometry>(&geometry, [](const FclGeometry*) {}));
  query.touches(Pose::identity());
  query.nearest(Pose::identity(), std::numeric_limits<double>::infinity());
}

}  // namespace

std::shared_ptr<const FclGeometry> makeFclGeometry(const std::vector<RigidBody>& obstacles,
                                                   const TriangleMesh& object) {
  auto geometry = std::make_shared<FclGeometry>();
  std::vector<const TriangleMesh*> meshes{&object};
  double farthest = 0.0;
  for (const RigidBody& body : obstacles) {
    meshes.push_back(body.mesh.get());
    farthest = std::max(farthest, body.X_WB.position.cwiseAbs().maxCoeff());
  }
  geometry->scale = fclScale(meshes, farthest);
  geometry->object.beginModel();
  addMesh(geometry->object, object, geometry->scale);
  geometry->object.endModel();
  geometry->obstacles.beginModel();
  for (std::size_t body = 0; body < obstacles.size(); ++body) {
    addMesh(geometry->obstacles, transformed(*obstacles[body].mesh, obstacles[body].X_WB), geometry->scale);
    geometry->bodyOf.insert(geometry->bodyOf.end(), obstacles[body].mesh->triangles.size(), static_cast<int>(body));
  }
  if (!geometry->bodyOf.empty()) {
    geometry->obstacles.endModel();
    warmUp(*geometry);
  }
  return geometry;
}

FclSurfaceQuery::FclSurfaceQuery(std::shared_ptr<const FclGeometry> geometry) : geometry_(std::move(geometry)) {}

bool FclSurfaceQuery::touches(const Pose& X_WB) {
  if (geometry_->bodyOf.empty()) return false;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&geometry_->obstacles, fcl::Transform3d::Identity(), &geometry_->object, geometry_->place(X_WB),
                      request, result) > 0;
}

std::optional<int> FclSurfaceQuery::touchingBody(const Pose& X_WB) {
  if (geometry_->bodyOf.empty()) return std::nullopt;
  const fcl::CollisionRequestd request(std::numeric_limits<int>::max());
  fcl::CollisionResultd result;
  fcl::collide(&geometry_->obstacles, fcl::Transform3d::Identity(), &geometry_->object, geometry_->place(X_WB), request,
               result);
  std::optional<int> lowest;
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const int body = geometry_->bodyOf[static_cast<std::size_t>(result.getContact(i).b1)];
    if (!lowest || body < *lowest) lowest = body;
  }
  return lowest;
}

NearestObstacle FclSurfaceQuery::nearest(const Pose& X_WB, double enough) {
  NearestObstacle nearest;
  nearest.distance = enough;
  if (geometry_->bodyOf.empty()) return nearest;
  const fcl::DistanceRequestd request(true);
  fcl::DistanceResultd result;
  fcl::distance(&geometry_->obstacles, fcl::Transform3d::Identity(), &geometry_->object, geometry_->place(X_WB),
                request, result);
  const double distance = result.min_distance / geometry_->scale;
  if (distance > enough) return nearest;
  nearest.distance = std::max(0.0, distance);
  nearest.body = geometry_->bodyOf[static_cast<std::size_t>(result.b1)];
  nearest.p_WPo = result.nearest_points[0] / geometry_->scale;
  nearest.p_WPn = result.nearest_points[1] / geometry_->scale;
  return nearest;
}

bool FclSurfaceQuery::isWithin(const Pose& X_WB, double bound) {
  return touches(X_WB) || nearest(X_WB, std::numeric_limits<double>::infinity()).distance <= bound;
}

std::optional<MotionCheck> FclSurfaceQuery::checkMotion(const Pose&, const Pose&, double, SeekViolation,
                                                        const StopToken&) {
  return std::nullopt;
}

}  // namespace glissade
