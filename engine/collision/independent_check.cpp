#include "engine/collision/independent_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "engine/collision/fcl_scale.h"
#include "engine/collision/judged_geometry.h"
#include "engine/collision/judged_thinning.h"
#include "engine/collision/judged_threads.h"

namespace glissade {
namespace {

/// Distances that are asked for on a screw motion of many turns.
constexpr std::size_t kDistancesOfHelix = 32;
/// Clearances are proved down to this share of the smallest distance met.
constexpr double kCloseShare = 0.5;
/// Distances asked for on one edge before it is given up as undecided.
constexpr std::uint64_t kMostDistances = 400'000;
/// An interval of time that was halved this often is as short as numbers allow.
constexpr int kMostHalvings = 48;

TriangleMesh inWorld(const RigidBody& body, double scale) {
  TriangleMesh mesh = *body.mesh;
  const Eigen::Matrix3d rotation = body.X_WB.orientation.toRotationMatrix();
  for (Vector3& vertex : mesh.vertices) vertex = scale * (rotation * vertex + body.X_WB.position);
  return mesh;
}

Pose scaledPose(const Pose& pose, double scale) { return {scale * pose.position, pose.orientation}; }

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

struct Span {
  double begin;
  double end;
  int halvings;
};

}  // namespace

IndependentCheck::ObstaclePtr IndependentCheck::prepare(const RigidBody& body, double scale) {
  return std::make_shared<const Obstacle>(inWorld(body, scale));
}

double IndependentCheck::scaleFor(const std::vector<RigidBody>& bodies) {
  return bodies.empty() ? 1.0 : fclScale(bodies, *bodies.front().mesh);
}

IndependentCheck::IndependentCheck(const std::vector<RigidBody>& obstacles, const TriangleMesh& object,
                                   const std::vector<double>& allowances, const std::vector<ThreadRule>& threads) {
  std::map<double, MeshPtr> objects{{0.0, std::make_shared<const TriangleMesh>(object)}};
  double scale = fclScale(obstacles, object);
  for (const double allowance : allowances) {
    MeshPtr& thinner = objects[allowance];
    if (thinner) continue;
    thinner = std::make_shared<const TriangleMesh>(thinnedForJudging(object, allowance));
    // Thinned objects may have smaller triangles.
    scale = std::max(scale, fclScale(obstacles, *thinner));
  }
  std::vector<Against> against;
  for (std::size_t body = 0; body < obstacles.size(); ++body) {
    const double allowance = body < allowances.size() ? allowances[body] : 0.0;
    against.push_back({prepare(obstacles[body], scale), objects[allowance], allowance > 0.0});
  }
  std::vector<Thread> threaded;
  for (const ThreadRule& rule : threads) {
    const RigidBody& body = obstacles[static_cast<std::size_t>(rule.obstacle)];
    threaded.push_back({rule, body, against[static_cast<std::size_t>(rule.obstacle)].obstacle});
  }
  build(against, object, scale, threaded);
}

IndependentCheck::IndependentCheck(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
                                   const std::vector<Thread>& threads) {
  build(obstacles, object, scale, threads);
}

void IndependentCheck::build(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
                             const std::vector<Thread>& threads) {
  geometry_ = geometryOf(obstacles, object, scale);
  if (threads.empty()) return;
  const auto wholeObject = std::make_shared<const TriangleMesh>(object);
  std::vector<Against> whole = obstacles;
  std::vector<RigidBody> bodies(obstacles.size());
  std::vector<ThreadRule> rules;
  for (const Thread& thread : threads) {
    const auto number = static_cast<std::size_t>(thread.rule.obstacle);
    whole[number] = {thread.whole, wholeObject, false};
    bodies[number] = thread.body;
    rules.push_back(thread.rule);
  }
  whole_ = geometryOf(whole, object, scale);
  threads_ = std::make_unique<const JudgedThreads>(rules, object, bodies);
}

std::unique_ptr<const IndependentCheck::Geometry> IndependentCheck::geometryOf(const std::vector<Against>& obstacles,
                                                                               const TriangleMesh& object,
                                                                               double scale) {
  auto geometry = std::make_unique<Geometry>();
  geometry->scale = scale;
  geometry->object = scaled(object, Vector3::Constant(scale));
  std::vector<MeshPtr> meshes;  // of the groups
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    geometry->hasFits = geometry->hasFits || obstacles[i].fits;
    const auto known = std::find(meshes.begin(), meshes.end(), obstacles[i].object);
    const auto group = static_cast<std::size_t>(known - meshes.begin());
    if (known == meshes.end()) {
      meshes.push_back(obstacles[i].object);
      geometry->groups.push_back(std::make_unique<Group>(*obstacles[i].object, scale));
    }
    geometry->groups[group]->add(obstacles[i].obstacle, static_cast<int>(i));
  }
  for (const auto& group : geometry->groups) group->finish();
  return geometry;
}

IndependentCheck::~IndependentCheck() = default;

/// Screw motions of more than a turn are judged as one: all of their edges have the clearance that is shown for the
/// whole, and the smallest distance that was met at some of its configurations. Where that does not show what is
/// demanded, the edges are judged one by one.
std::vector<std::optional<MotionCertificate>> IndependentCheck::judgeHelices(const std::vector<Pose>& path,
                                                                             const std::vector<EdgeDemand>& demands,
                                                                             const StopToken& stop) const {
  std::vector<std::optional<MotionCertificate>> known(demands.size());
  if (threads_ || path.size() < 2) return known;  // threads have a rule of their own
  std::vector<Pose> scaledPath;
  for (const Pose& q : path) scaledPath.push_back(scaledPose(q, geometry_->scale));
  for (const JudgedHelix& helix : helicesOf(scaledPath, geometry_->object)) {
    double demanded = 0.0;
    for (std::size_t i = helix.first; i <= helix.last; ++i) demanded = std::max(demanded, demands[i].clearance);
    const MotionCertificate judged = judgeHelix(*geometry_, scaledPath, helix, geometry_->scale * demanded, stop);
    if (judged.status != CertificateStatus::Certified) continue;
    for (std::size_t i = helix.first; i <= helix.last; ++i) {
      known[i] = inMetres(judged, geometry_->scale);
      known[i]->tolerance = demands[i].clearance;
    }
  }
  return known;
}

MotionCertificate IndependentCheck::judgeHelix(const Geometry& geometry, const std::vector<Pose>& path,
                                               const JudgedHelix& helix, double required, const StopToken& stop) {
  MotionCertificate result;
  result.minClearance = std::numeric_limits<double>::infinity();
  const Pose& from = path[helix.first];
  const Pose& to = path[helix.last + 1];
  const auto placed = [](const Pose& q) { return JudgedCourse(q, q).at(0.0); };
  if (!geometry.resolves(from, to, required) || geometry.container(placed(from)) >= 0) return result;
  const std::vector<bool> all(geometry.groups.size(), true);
  const std::size_t count = helix.last - helix.first + 1;
  const std::size_t step = std::max<std::size_t>(1, count / kDistancesOfHelix);
  for (std::size_t i = 0; i <= count; i += step) {
    if (stop.stopRequested()) return result;
    ++result.distanceQueries;
    const NearestObstacle nearest = geometry.nearest(placed(path[helix.first + i]), all);
    if (nearest.distance >= result.minClearance) continue;
    result.minClearance = nearest.distance;
    result.nearest = nearest;
  }
  double shown = result.minClearance;
  for (const auto& group : geometry.groups) {
    if (shown <= helix.off || stop.stopRequested()) return result;
    shown = std::min(shown, group->helixDistance(placed(from), helix, required + helix.off, shown));
  }
  result.provedClearance = shown - helix.off;
  if (result.provedClearance < required) return result;
  result.certified = 1.0;
  result.status = CertificateStatus::Certified;
  return result;
}

MotionCertificate IndependentCheck::check(const std::vector<Pose>& path, const std::vector<EdgeDemand>& demands,
                                          const StopToken& stop) const {
  MotionCertificate result;
  const auto helices = judgeHelices(path, demands, stop);
  const auto turned = threads_ ? threads_->judge(path) : std::vector<JudgedThreads::Edge>();
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const Pose& to = path[std::min(i + 1, path.size() - 1)];
    const bool free = i < turned.size() && !turned[i].engaged;
    const Geometry& geometry = free ? *whole_ : *geometry_;
    const double scale = geometry.scale;
    MotionCertificate edge;
    if (helices[i]) {
      edge = *helices[i];
    } else if (i < turned.size() && turned[i].forbiddenBy >= 0) {
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
  if (JudgedCourse(begin, end).isHalfACircle()) {
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
  const JudgedCourse course(from, to);
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
  const bool sweeps = geometry.hasFits && turn <= judged::kErrorShare * required;
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
      proved = geometry.sweptDistance(course.at(span.begin), length * course.way(), 2.0 * required, asked) - turn;
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
