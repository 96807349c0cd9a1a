#include "engine/collision/independent_check.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "engine/collision/fcl_scale.h"
#include "engine/collision/judged_thinning.h"
#include "engine/collision/judged_threads.h"
#include "engine/collision/judged_turn.h"
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
  double speed(const TriangleMesh& object) const { return (way_.norm() + turn(object)) * (1.0 + kRelativeError); }
  /// No vertex moves farther by the rotation, in metres.
  double turn(const TriangleMesh& object) const {
    double arm = 0.0;
    for (const Vector3& vertex : object.vertices) arm = std::max(arm, (vertex - axis_ * axis_.dot(vertex)).norm());
    return angle_ * arm;
  }
  const Vector3& way() const { return way_; }
  /// No vertex is farther from where an exact turn about the axis, and translation along it, has it. Between its ends a
  /// line is off a helix by an eighth of its radius times the square of its angle.
  double offTurn(const Vector3& point, const Vector3& axis, const Pose& to, const TriangleMesh& object) const {
    const Vector3 rotation = from_.orientation.toRotationMatrix() * (angle_ * axis_);
    const double turn = rotation.dot(axis);
    const Vector3 arm = from_.position - point;
    const Vector3 end = point + Eigen::AngleAxisd(turn, axis) * arm + way_.dot(axis) * axis;
    const double chord = arm.cross(axis).norm() * turn * turn / 8.0;
    double reach = 0.0;
    for (const Vector3& vertex : object.vertices) reach = std::max(reach, vertex.norm());
    return (chord + (to.position - end).norm() + (rotation - turn * axis).norm() * reach) * (1.0 + kRelativeError);
  }
  bool isHalfACircle() const { return angle_ > 3.14159265358979323846 - kHalfCircle; }

 private:
  const Pose& from_;
  Vector3 way_;
  double angle_ = 0.0;
  Vector3 axis_ = Vector3::UnitX();
};

/// What a mesh passes over on a straight way: the boundaries of the prisms that its triangles sweep.
TriangleMesh sweptBy(const TriangleMesh& mesh, const Vector3& way) {
  TriangleMesh swept = mesh;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) swept.vertices.emplace_back(vertex + way);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    swept.triangles.push_back({a + count, b + count, c + count});
    edges.insert({std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
  }
  for (const auto& [a, b] : edges) {
    swept.triangles.push_back({a, b, b + count});
    swept.triangles.push_back({a, b + count, a + count});
  }
  return swept;
}

/// Whether a triangle on a straight way passes over the point.
bool passesOver(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& way, const Vector3& point) {
  Eigen::Matrix3d sides;
  sides << b - a, c - a, way;
  if (sides.determinant() == 0.0) return false;
  const Vector3 shares = sides.inverse() * (point - a);
  return shares.minCoeff() >= 0.0 && shares.x() + shares.y() <= 1.0 && shares.z() <= 1.0;
}

/// Thinned objects may have smaller triangles.
double scaleFor(const std::vector<RigidBody>& obstacles, const std::map<double, TriangleMesh>& objects) {
  double largest = 0.0;
  for (const auto& [allowance, object] : objects) largest = std::max(largest, fclScale(obstacles, object));
  return largest;
}

struct Span {
  double begin;
  double end;
  int halvings;
};

}  // namespace

/// Obstacles that the object is taken equally thin against. All lengths are multiplied by `scale`, those of the poses
/// that are asked for too.
struct IndependentCheck::Group {
  TriangleMesh object;
  RaySolid objectSolid;
  std::vector<RaySolid> obstacleSolids;
  std::vector<int> numbers;  ///< of the obstacles
  Model objectSurface;
  Model obstacleSurface;
  std::vector<int> bodyOf;  ///< per triangle of the obstacles

  double coordinates;  ///< the largest of the obstacles and of the object in its own frame, together

  Group(const TriangleMesh& mesh, double scale)
      : object(scaled(mesh, Vector3::Constant(scale))), objectSolid(object), coordinates(largestCoordinate(object)) {
    objectSurface.beginModel();
    addTriangles(objectSurface, object);
    objectSurface.endModel();
    obstacleSurface.beginModel();
  }

  void add(const RigidBody& obstacle, int number, double scale) {
    TriangleMesh placed = inWorld(obstacle, scale);
    farthest_ = std::max(farthest_, largestCoordinate(placed));
    addTriangles(obstacleSurface, placed);
    bodyOf.insert(bodyOf.end(), placed.triangles.size(), number);
    numbers.push_back(number);
    obstacleSolids.emplace_back(std::move(placed));
  }

  void finish() {
    coordinates += farthest_;
    if (!bodyOf.empty()) obstacleSurface.endModel();
  }

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

  /// Lower bound on the distance on a whole straight way from there, along which the object does not turn. What
  /// touches no prism's boundary is inside the prism, or nowhere.
  double sweptDistance(const fcl::Transform3d& X_WB, const Vector3& way) const {
    if (bodyOf.empty()) return std::numeric_limits<double>::infinity();
    TriangleMesh placed = object;
    for (Vector3& vertex : placed.vertices) vertex = X_WB * vertex;
    Model swept;
    swept.beginModel();
    addTriangles(swept, sweptBy(placed, way));
    swept.endModel();
    const fcl::Transform3d fixed = fcl::Transform3d::Identity();
    fcl::CollisionResultd touch;
    if (fcl::collide(&obstacleSurface, fixed, &swept, fixed, fcl::CollisionRequestd(), touch) > 0) return 0.0;
    for (const RaySolid& obstacle : obstacleSolids) {
      for (const Vector3& point : obstacle.partPoints()) {
        for (const auto& [a, b, c] : placed.triangles) {
          if (passesOver(placed.vertices[a], placed.vertices[b], placed.vertices[c], way, point)) return 0.0;
        }
      }
    }
    fcl::DistanceResultd gap;
    fcl::distance(&obstacleSurface, fixed, &swept, fixed, fcl::DistanceRequestd(), gap);
    const double error = std::max(errorAt(X_WB.translation()), errorAt(X_WB.translation() + way));
    return std::max(0.0, gap.min_distance * (1.0 - kRelativeError) - error);
  }

  /// Lower bound on the distance while the object turns about the axis from there by any angle, advances along it and
  /// is off that by so much.
  double turnedDistance(const fcl::Transform3d& X_WB, const Vector3& point, const Vector3& axis, double advance,
                        double off) const {
    std::vector<TurnedTriangle> moving;
    for (const auto& [a, b, c] : object.triangles) {
      moving.push_back(
          turned(X_WB * object.vertices[a], X_WB * object.vertices[b], X_WB * object.vertices[c], point, axis));
    }
    std::vector<TurnedTriangle> fixed;
    for (int i = 0; i < (bodyOf.empty() ? 0 : obstacleSurface.num_tris); ++i) {
      const fcl::Triangle& triangle = obstacleSurface.tri_indices[i];
      const auto corner = [&](int k) { return obstacleSurface.vertices[triangle[k]]; };
      fixed.push_back(turned(corner(0), corner(1), corner(2), point, axis));
    }
    const double error = errorAt(X_WB.translation()) + errorAt(X_WB.translation() + advance * axis);
    return std::max(0.0, glissade::turnedDistance(moving, fixed, advance, off) * (1.0 - kRelativeError) - error);
  }

  /// The body that the object is inside of, or around; -1 where there is none.
  int container(const fcl::Transform3d& X_WB) const {
    const fcl::Transform3d X_BW = X_WB.inverse();
    for (std::size_t i = 0; i < obstacleSolids.size(); ++i) {
      for (const Vector3& p : objectSolid.partPoints()) {
        if (obstacleSolids[i].contains(X_WB * p)) return numbers[i];
      }
      for (const Vector3& p : obstacleSolids[i].partPoints()) {
        if (objectSolid.contains(X_BW * p)) return numbers[i];
      }
    }
    return -1;
  }

 private:
  double farthest_ = 0.0;
};

/// The groups, all in the same scale.
struct IndependentCheck::Geometry {
  double scale = 1.0;
  TriangleMesh object;  ///< as it is: no vertex of a thinned one is faster
  std::vector<std::unique_ptr<Group>> groups;

  double errorAt(const Vector3& position) const {
    double error = 0.0;
    for (const auto& group : groups) error = std::max(error, group->errorAt(position));
    return error;
  }
  /// Whether distances along the straight motion are exact enough to be compared with this clearance.
  bool resolves(const Pose& from, const Pose& to, double clearance) const {
    return std::max(errorAt(from.position), errorAt(to.position)) <= kErrorShare * clearance;
  }

  /// Of those of the groups that are asked.
  NearestObstacle nearest(const fcl::Transform3d& X_WB, const std::vector<bool>& asked) const {
    NearestObstacle nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (!asked[i]) continue;
      const NearestObstacle found = groups[i]->nearest(X_WB);
      if (found.distance < nearest.distance) nearest = found;
    }
    return nearest;
  }

  double sweptDistance(const fcl::Transform3d& X_WB, const Vector3& way, const std::vector<bool>& asked) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (asked[i]) least = std::min(least, groups[i]->sweptDistance(X_WB, way));
    }
    return least;
  }

  /// Proves what it can of a turn in a thread, whatever its angle is: those of the groups are no longer asked that keep
  /// the clearance. Returns the least that was proved.
  double proveTurn(const ThreadRule& thread, const Course& course, const Pose& from, const Pose& to, double required,
                   std::vector<bool>& asked) const {
    const Vector3 point = scale * thread.point_W;
    const double advance = (to.position - from.position).dot(thread.axis_W);
    const double off = course.offTurn(point, thread.axis_W, to, object);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const double proved = groups[i]->turnedDistance(course.at(0.0), point, thread.axis_W, advance, off);
      asked[i] = proved < required;
      if (!asked[i]) least = std::min(least, proved);
    }
    return least;
  }

  int container(const fcl::Transform3d& X_WB) const {
    for (const auto& group : groups) {
      if (const int body = group->container(X_WB); body >= 0) return body;
    }
    return -1;
  }
};

std::unique_ptr<const IndependentCheck::Geometry> IndependentCheck::geometryOf(const std::vector<RigidBody>& obstacles,
                                                                               const TriangleMesh& object,
                                                                               const std::vector<double>& allowances) {
  std::map<double, TriangleMesh> objects{{0.0, object}};
  for (const double allowance : allowances) {
    if (objects.count(allowance) == 0) objects.emplace(allowance, thinnedForJudging(object, allowance));
  }
  auto geometry = std::make_unique<Geometry>();
  const double scale = geometry->scale = scaleFor(obstacles, objects);
  geometry->object = scaled(object, Vector3::Constant(scale));
  for (const auto& [allowance, mesh] : objects) {
    auto group = std::make_unique<Group>(mesh, scale);
    for (std::size_t body = 0; body < obstacles.size(); ++body) {
      const double own = body < allowances.size() ? allowances[body] : 0.0;
      if (own == allowance) group->add(obstacles[body], static_cast<int>(body), scale);
    }
    group->finish();
    geometry->groups.push_back(std::move(group));
  }
  return geometry;
}

IndependentCheck::IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                                   const std::vector<double>& allowances, const std::vector<ThreadRule>& threads)
    : geometry_(geometryOf(obstacles, object, allowances)) {
  if (threads.empty()) return;
  std::vector<double> without = allowances;
  for (const ThreadRule& rule : threads) {
    if (!without.empty()) without[static_cast<std::size_t>(rule.obstacle)] = 0.0;
  }
  whole_ = geometryOf(obstacles, object, without);
  threads_ = std::make_unique<const JudgedThreads>(threads, object, obstacles);
}

IndependentCheck::~IndependentCheck() = default;

MotionCertificate IndependentCheck::check(const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                                          const StopToken& stop) const {
  MotionCertificate result;
  const auto turned = threads_ ? threads_->judge(path) : std::vector<JudgedThreads::Edge>();
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const Pose& to = path[std::min(i + 1, path.size() - 1)];
    const bool free = i < turned.size() && !turned[i].engaged;
    const Geometry& geometry = free ? *whole_ : *geometry_;
    const double scale = geometry.scale;
    MotionCertificate edge;
    if (i < turned.size() && turned[i].forbiddenBy >= 0) {
      edge.status = CertificateStatus::Violated;
      edge.againstThread = true;
      edge.nearest.body = turned[i].forbiddenBy;
    } else {
      const ThreadRule* thread = i < turned.size() ? turned[i].thread : nullptr;
      edge = inMetres(checkEdge(geometry, scaledPose(path[i], scale), scaledPose(to, scale),
                                scale * demands[i].clearance, thread, stop),
                      scale);
    }
    addEdge(result, edge, demands[i]);
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
/// until its ends; what is not proved is halved, the earlier half first. Bodies that fit leave gaps of micrometres:
/// there a straight way is proved by what the object sweeps, too.
MotionCertificate IndependentCheck::checkEdge(const Geometry& geometry, const Pose& from, const Pose& to,
                                              double required, const ThreadRule* thread, const StopToken& stop) {
  const Course course(from, to);
  const double speed = course.speed(geometry.object);
  MotionCertificate result;
  result.tolerance = required;
  result.minClearance = result.provedClearance = std::numeric_limits<double>::infinity();
  if (const int body = geometry.container(course.at(0.0)); body >= 0) {
    result.status = CertificateStatus::Violated;
    result.minClearance = result.provedClearance = 0.0;
    result.nearest.body = body;
    return result;
  }
  const double turn = course.turn(geometry.object);
  const bool sweeps = geometry.groups.size() > 1 && turn <= kErrorShare * required;
  if (course.isHalfACircle() || !geometry.resolves(from, to, required)) return result;
  std::vector<bool> asked(geometry.groups.size(), true);
  const auto meet = [&](double t) {
    const NearestObstacle nearest = geometry.nearest(course.at(t), asked);
    if (nearest.distance < result.minClearance) {
      result.minClearance = nearest.distance;
      result.at = t;
      result.nearest = nearest;
    }
    if (nearest.distance < required) result.status = CertificateStatus::Violated;
    return nearest.distance;
  };
  if (sweeps || thread != nullptr) {
    meet(0.0);
    meet(1.0);
    if (result.status == CertificateStatus::Violated) return result;
  }
  if (thread != nullptr) {
    result.provedClearance = geometry.proveTurn(*thread, course, from, to, required, asked);
    if (std::none_of(asked.begin(), asked.end(), [](bool open) { return open; })) {
      result.certified = 1.0;
      result.status = CertificateStatus::Certified;
      return result;
    }
  }
  std::vector<Span> open{{0.0, 1.0, 0}};
  while (!open.empty()) {
    const Span span = open.back();
    open.pop_back();
    if (stop.stopRequested() || ++result.distanceQueries > kMostDistances) return result;
    const double middle = 0.5 * (span.begin + span.end);
    const double distance = meet(middle);
    if (result.status == CertificateStatus::Violated) return result;
    const double length = span.end - span.begin;
    double proved = distance - 0.5 * speed * length;
    bool closely = proved >= std::max(required, kCloseShare * result.minClearance);
    if (!closely && sweeps) {
      proved = geometry.sweptDistance(course.at(span.begin), length * course.way(), asked) - turn;
      closely = proved >= required;
    }
    if (closely) {
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
