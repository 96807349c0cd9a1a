#include "engine/collision/independent_check.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/collision/fcl_scale.h"
#include "engine/collision/ray_containment.h"

namespace glissade {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

/// FCL's distances between triangles are good to this share of them, and to this share of the largest
/// coordinate that enters: some 16 roundings.
constexpr double kRelativeError = 1e-9;
constexpr double kCoordinateError = 4e-15;
/// Where that comes to more than this share of the clearance, it is undecided.
constexpr double kErrorShare = 0.05;
/// Clearances are proved down to this share of the smallest distance met.
constexpr double kCloseShare = 0.5;
/// Distances asked for on one edge before it is given up as undecided.
constexpr std::uint64_t kMostDistances = 400'000;
/// An interval of time that was halved this often is as short as numbers allow.
constexpr int kMostHalvings = 48;
/// Within this many radians of half a circle the sense of the turn is rounding.
constexpr double kHalfCircle = 1e-6;

void addTriangles(Model& model, const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> points(mesh.vertices.begin(), mesh.vertices.end());
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  model.addSubModel(points, triangles);
}

TriangleMesh inWorld(const RigidBody& body, double scale) {
  TriangleMesh mesh = *body.mesh;
  const Eigen::Matrix3d rotation = body.X_WB.orientation.toRotationMatrix();
  for (Vector3& vertex : mesh.vertices) vertex = scale * (rotation * vertex + body.X_WB.position);
  return mesh;
}

Pose scaledPose(const Pose& pose, double scale) { return {scale * pose.position, pose.orientation}; }

double largestCoordinate(const TriangleMesh& mesh) {
  double largest = 0.0;
  for (const Vector3& vertex : mesh.vertices) largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  return largest;
}

/// From the scaled geometry's lengths to metres.
MotionCertificate inMetres(MotionCertificate edge, double scale) {
  edge.tolerance /= scale;
  edge.minClearance /= scale;
  edge.provedClearance /= scale;
  edge.nearest.distance /= scale;
  edge.nearest.p_WPo /= scale;
  edge.nearest.p_WPn /= scale;
  return edge;
}

/// The straight motion, as a line and a rotation vector in the object's frame.
class Course {
 public:
  Course(const Pose& from, const Pose& to) : from_(from), way_(to.position - from.position) {
    Quaternion turn = from.orientation.conjugate() * to.orientation;
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    angle_ = 2.0 * std::atan2(sine, turn.w());
    if (sine > 0.0) axis_ = turn.vec() / sine;
  }

  fcl::Transform3d at(double t) const {
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.linear() = from_.orientation.toRotationMatrix() * Eigen::AngleAxisd(t * angle_, axis_).toRotationMatrix();
    place.translation() = from_.position + t * way_;
    return place;
  }
  /// No vertex moves faster, in metres per unit of t.
  double speed(const TriangleMesh& object) const {
    double arm = 0.0;
    for (const Vector3& vertex : object.vertices) arm = std::max(arm, (vertex - axis_ * axis_.dot(vertex)).norm());
    return (way_.norm() + angle_ * arm) * (1.0 + kRelativeError);
  }
  bool isHalfACircle() const { return angle_ > 3.14159265358979323846 - kHalfCircle; }

 private:
  const Pose& from_;
  Vector3 way_;
  double angle_ = 0.0;
  Vector3 axis_ = Vector3::UnitX();
};

struct Span {
  double begin;
  double end;
  int halvings;
};

}  // namespace

/// All lengths are multiplied by `scale`, those of the poses that are asked for too.
struct IndependentCheck::Geometry {
  double scale;
  TriangleMesh object;
  RaySolid objectSolid;
  std::vector<RaySolid> obstacleSolids;
  Model objectSurface;
  Model obstacleSurface;
  std::vector<int> bodyOf;  ///< per triangle of the obstacles

  double coordinates;  ///< the largest of the obstacles and of the object in its own frame, together

  Geometry(const TriangleMesh& mesh, double factor)
      : scale(factor),
        object(scaled(mesh, Vector3::Constant(factor))),
        objectSolid(object),
        coordinates(largestCoordinate(object)) {}

  /// Of distances where the object is placed here.
  double errorAt(const Vector3& position) const {
    return kCoordinateError * (coordinates + position.cwiseAbs().maxCoeff());
  }

  NearestObstacle nearest(const fcl::Transform3d& X_WB) const {
    NearestObstacle found;
    found.distance = std::numeric_limits<double>::infinity();
    if (bodyOf.empty()) return found;
    const auto bodyAt = [&](long triangle) { return bodyOf[static_cast<std::size_t>(triangle)]; };
    const fcl::Transform3d fixed = fcl::Transform3d::Identity();
    fcl::CollisionResultd touch;
    if (fcl::collide(&obstacleSurface, fixed, &objectSurface, X_WB, fcl::CollisionRequestd(), touch) > 0) {
      found.distance = 0.0;
      found.body = bodyAt(touch.getContact(0).b1);
      return found;
    }
    const double error = errorAt(X_WB.translation());
    fcl::DistanceResultd gap;
    fcl::distance(&obstacleSurface, fixed, &objectSurface, X_WB, fcl::DistanceRequestd(true), gap);
    found.distance = std::max(0.0, gap.min_distance * (1.0 - kRelativeError) - error);
    found.body = bodyAt(gap.b1);
    found.p_WPo = gap.nearest_points[0];
    found.p_WPn = gap.nearest_points[1];
    return found;
  }

  /// Whether distances along the straight motion are exact enough to be compared with this clearance.
  bool resolves(const Pose& from, const Pose& to, double clearance) const {
    return std::max(errorAt(from.position), errorAt(to.position)) <= kErrorShare * clearance;
  }

  /// The body that the object is inside of, or around; -1 where there is none.
  int container(const fcl::Transform3d& X_WB) const {
    const fcl::Transform3d X_BW = X_WB.inverse();
    for (std::size_t body = 0; body < obstacleSolids.size(); ++body) {
      for (const Vector3& p : objectSolid.partPoints()) {
        if (obstacleSolids[body].contains(X_WB * p)) return static_cast<int>(body);
      }
      for (const Vector3& p : obstacleSolids[body].partPoints()) {
        if (objectSolid.contains(X_BW * p)) return static_cast<int>(body);
      }
    }
    return -1;
  }
};

IndependentCheck::IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object) {
  auto geometry = std::make_unique<Geometry>(object, fclScale(obstacles, object));
  geometry->objectSurface.beginModel();
  addTriangles(geometry->objectSurface, geometry->object);
  geometry->objectSurface.endModel();
  geometry->obstacleSurface.beginModel();
  double farthest = 0.0;
  for (std::size_t body = 0; body < obstacles.size(); ++body) {
    TriangleMesh placed = inWorld(obstacles[body], geometry->scale);
    farthest = std::max(farthest, largestCoordinate(placed));
    addTriangles(geometry->obstacleSurface, placed);
    geometry->bodyOf.insert(geometry->bodyOf.end(), placed.triangles.size(), static_cast<int>(body));
    geometry->obstacleSolids.emplace_back(std::move(placed));
  }
  geometry->coordinates += farthest;
  if (!geometry->bodyOf.empty()) geometry->obstacleSurface.endModel();
  geometry_ = std::move(geometry);
}

IndependentCheck::~IndependentCheck() = default;

MotionCertificate IndependentCheck::check(const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                                          const StopToken& stop) const {
  const double scale = geometry_->scale;
  MotionCertificate result;
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const Pose& to = path[std::min(i + 1, path.size() - 1)];
    const MotionCertificate edge =
        checkEdge(scaledPose(path[i], scale), scaledPose(to, scale), scale * demands[i].clearance, stop);
    addEdge(result, inMetres(edge, scale), demands[i]);
    if (result.status != CertificateStatus::Certified) break;
  }
  return result;
}

std::string IndependentCheck::whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const {
  const double scale = geometry_->scale;
  const Pose begin = scaledPose(from, scale);
  const Pose end = scaledPose(to, scale);
  if (Course(begin, end).isHalfACircle()) {
    return "the edge turns by half a circle, and rounding decides which way; insert a configuration between its ends";
  }
  if (!geometry_->resolves(begin, end, scale * requiredClearance)) {
    return "the rounding of coordinates of this size is not small against the required clearance; move the scene to "
           "the origin, or require more clearance";
  }
  return "the clearance is so close to the required one that " + std::to_string(kMostDistances) +
         " distances do not prove it; require less clearance, or divide the edge";
}

/// In the scaled geometry. An interval of time is proved by the distance at its middle less what any vertex can move
/// until its ends; what is not proved is halved, the earlier half first.
MotionCertificate IndependentCheck::checkEdge(const Pose& from, const Pose& to, double required,
                                              const StopToken& stop) const {
  const Course course(from, to);
  const double speed = course.speed(geometry_->object);
  MotionCertificate result;
  result.tolerance = required;
  result.minClearance = result.provedClearance = std::numeric_limits<double>::infinity();
  if (const int body = geometry_->container(course.at(0.0)); body >= 0) {
    result.status = CertificateStatus::Violated;
    result.minClearance = result.provedClearance = 0.0;
    result.nearest.body = body;
    return result;
  }
  if (course.isHalfACircle() || !geometry_->resolves(from, to, required)) return result;
  std::vector<Span> open{{0.0, 1.0, 0}};
  while (!open.empty()) {
    const Span span = open.back();
    open.pop_back();
    if (stop.stopRequested() || ++result.distanceQueries > kMostDistances) return result;
    const double middle = 0.5 * (span.begin + span.end);
    const NearestObstacle nearest = geometry_->nearest(course.at(middle));
    if (nearest.distance < result.minClearance) {
      result.minClearance = nearest.distance;
      result.at = middle;
      result.nearest = nearest;
    }
    if (nearest.distance < required) {
      result.status = CertificateStatus::Violated;
      return result;
    }
    const double proved = nearest.distance - 0.5 * speed * (span.end - span.begin);
    if (proved >= std::max(required, kCloseShare * result.minClearance)) {
      result.provedClearance = std::min(result.provedClearance, proved);
      result.certified = span.end;
    } else if (span.halvings == kMostHalvings) {
      return result;
    } else {
      open.push_back({middle, span.end, span.halvings + 1});
      open.push_back({span.begin, middle, span.halvings + 1});
    }
  }
  result.status = CertificateStatus::Certified;
  return result;
}

}  // namespace glissade
