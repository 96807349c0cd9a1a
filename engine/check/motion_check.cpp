#include "engine/check/motion_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/check/evidence_names.h"
#include "engine/check/motion_geometry.h"
#include "engine/check/thread_motion.h"
#include "engine/evidence/turn.h"

namespace glissade::check {
namespace {

constexpr double kRunRounding = 1.0 + 1e-9;

/// Angle, radians, of the part of the rotation about the axis.
double twistOf(const Eigen::Matrix3d& rotation, const Vector3& axis) {
  const Quaternion q(rotation);
  return 2.0 * std::atan2(q.vec().dot(axis), q.w());
}

/// The rise of the edges from `first` to `last` as one motion that turns about an axis from its first configuration.
/// `reach`: largest distance of a vertex from the origin of the moving frame.
/// A straight edge between two configurations deviates from the turn by at most twice their deviation, plus its bow.
Rise riseOf(const std::vector<Pose>& path, std::size_t first, std::size_t last, const Vector3& point,
            const Vector3& axis, double reach) {
  const Pose& start = path[first];
  const Eigen::Matrix3d orientation = start.orientation.toRotationMatrix();
  const Vector3 arm = start.position - point;
  Rise rise;
  double atEnds = 0.0;
  double bow = 0.0;
  for (std::size_t i = first + 1; i <= last + 1; ++i) {
    const Pose& q = path[i];
    const Eigen::Matrix3d now = q.orientation.toRotationMatrix();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(twistOf(now * orientation.transpose(), axis), axis).matrix();
    const double risen = (q.position - start.position).dot(axis);
    rise.least = std::min(rise.least, risen);
    rise.most = std::max(rise.most, risen);
    const Vector3 exact = point + turn * arm + risen * axis;
    const double off = (q.position - exact).norm() + (now - turn * orientation).norm() * reach;
    atEnds = std::max(atEnds, off);
    const Eigen::Matrix3d before = path[i - 1].orientation.toRotationMatrix();
    const double angle = Eigen::AngleAxisd(Eigen::Matrix3d(now * before.transpose())).angle();
    bow = std::max(bow, ((q.position - point).cross(axis).norm() + off) * (1.0 - std::cos(0.5 * angle)));
  }
  rise.off = (2.0 * atEnds + bow) * kRunRounding;
  return rise;
}

/// Number of distances that are measured on a screw motion of many turns.
constexpr std::size_t kDistancesOfHelix = 32;
/// Limit of the parts into which a turn in a thread is divided before its edges are proved one by one.
constexpr std::size_t kPartsOfTurn = 16;
/// Share of the smallest distance met down to which clearances are proved.
constexpr double kCloseShare = 0.5;

TriangleMesh inWorld(const TriangleMesh& whole, const Pose& X_WB, double scale) {
  TriangleMesh mesh = whole;
  const Eigen::Matrix3d rotation = X_WB.orientation.toRotationMatrix();
  for (Vector3& vertex : mesh.vertices) vertex = scale * (rotation * vertex + X_WB.position);
  return mesh;
}

Pose scaledPose(const Pose& pose, double scale) { return {scale * pose.position, pose.orientation}; }

std::vector<Pose> scaledPath(const std::vector<Pose>& path, double scale) {
  std::vector<Pose> scaled;
  for (const Pose& q : path) scaled.push_back(scaledPose(q, scale));
  return scaled;
}

fcl::Transform3d placed(const Pose& q) { return Course(q, q).at(0.0); }

/// Converts lengths of the scaled geometry to metres.
MotionVerdict inMetres(MotionVerdict edge, double scale) {
  edge.demanded /= scale;
  edge.minClearance /= scale;
  edge.provedClearance /= scale;
  edge.nearest.distance /= scale;
  edge.nearest.onBody /= scale;
  edge.nearest.onMoving /= scale;
  return edge;
}

/// Adds the verdict on the next edge to the verdict on its path.
void addEdge(MotionVerdict& path, const MotionVerdict& edge, const Demand& demand) {
  const bool first = path.edges.empty();
  const std::size_t number = path.edges.size();
  path.edges.push_back({edge.status, demand, edge.provedClearance, edge.minClearance, edge.at, edge.nearest});
  path.distances += edge.distances;
  path.demanded = std::max(path.demanded, demand.clearance);
  path.provedClearance = first ? edge.provedClearance : std::min(path.provedClearance, edge.provedClearance);
  const bool refused = edge.status != Status::Certified;
  if (first || refused || edge.minClearance < path.minClearance) {
    path.edge = number;
    path.at = edge.at;
    path.nearest = edge.nearest;
    path.minClearance =
        first || edge.status == Status::Violated ? edge.minClearance : std::min(path.minClearance, edge.minClearance);
  }
  path.status = edge.status;
  path.againstThread = edge.againstThread;
}

}  // namespace

/// The proof of an edge as a part of a turn in a thread, in the scaled geometry.
struct MotionCheck::TurnProof {
  std::vector<bool> open;  ///< groups that still have to be proved as on other edges
  double proved = std::numeric_limits<double>::infinity();
  double minClearance = std::numeric_limits<double>::infinity();  ///< at some configurations of the turn
  Nearest nearest{};
};

MotionCheck::ObstaclePtr MotionCheck::prepare(const TriangleMesh& mesh, const Pose& X_WB, double scale) {
  return std::make_shared<const Obstacle>(inWorld(mesh, X_WB, scale));
}

double MotionCheck::scaleFor(const std::vector<const TriangleMesh*>& meshes, const std::vector<Body>& bodies) {
  double farthest = 0.0;
  for (const Body& body : bodies) farthest = std::max(farthest, body.X_WB.position.cwiseAbs().maxCoeff());
  return fclScale(meshes, farthest);
}

MotionCheck::MotionCheck(const std::vector<Against>& obstacles, const TriangleMesh& object, double scale,
                         const std::vector<Threaded>& threads) {
  std::vector<bool> inThread(obstacles.size(), false);
  for (const Threaded& each : threads) inThread[each.thread.other] = true;
  geometry_ = geometryOf(obstacles, object, scale, inThread);
  if (threads.empty()) return;
  const auto wholeObject = std::make_shared<const TriangleMesh>(object);
  std::vector<Against> whole = obstacles;
  for (const Threaded& each : threads) whole[each.thread.other] = {each.whole, wholeObject};
  whole_ = geometryOf(whole, object, scale, inThread);
  threads_ = std::make_unique<const ThreadMotion>(threads, object);
}

/// Makes separate groups for obstacles with threads: turns in them are proved without the other obstacles.
std::unique_ptr<const MotionCheck::Geometry> MotionCheck::geometryOf(const std::vector<Against>& obstacles,
                                                                     const TriangleMesh& object, double scale,
                                                                     const std::vector<bool>& inThread) {
  auto geometry = std::make_unique<Geometry>();
  geometry->scale = scale;
  geometry->object = scaled(object, Vector3::Constant(scale));
  std::vector<std::pair<MeshPtr, bool>> kinds;  // mesh of the object and thread of each group
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const std::pair<MeshPtr, bool> kind{obstacles[i].object, inThread[i]};
    const auto known = std::find(kinds.begin(), kinds.end(), kind);
    const auto group = static_cast<std::size_t>(known - kinds.begin());
    if (known == kinds.end()) {
      kinds.push_back(kind);
      geometry->groups.push_back(std::make_unique<Group>(*obstacles[i].object, scale));
    }
    geometry->groups[group]->add(obstacles[i].obstacle, static_cast<int>(i));
  }
  for (const auto& group : geometry->groups) group->finish();
  return geometry;
}

MotionCheck::~MotionCheck() = default;

/// Judges screw motions of more than a turn as one motion: all edges get the clearance that is proved for the whole
/// motion, and the smallest distance at some of its configurations. If that proof fails, the edges are judged one by
/// one.
std::vector<std::optional<MotionVerdict>> MotionCheck::judgeHelices(const std::vector<Pose>& path,
                                                                    const std::vector<Demand>& demands,
                                                                    const StopToken& stop) const {
  std::vector<std::optional<MotionVerdict>> known(demands.size());
  if (threads_ || path.size() < 2) return known;  // threads have a rule of their own
  const std::vector<Pose> scaled = scaledPath(path, geometry_->scale);
  for (const Helix& helix : helicesOf(scaled, geometry_->object)) {
    double demanded = 0.0;
    for (std::size_t i = helix.first; i <= helix.last; ++i) demanded = std::max(demanded, demands[i].clearance);
    const MotionVerdict judged = judgeHelix(*geometry_, scaled, helix, geometry_->scale * demanded, stop);
    if (judged.status != Status::Certified) continue;
    for (std::size_t i = helix.first; i <= helix.last; ++i) {
      known[i] = inMetres(judged, geometry_->scale);
      known[i]->demanded = demands[i].clearance;
      if (i > helix.first) known[i]->distances = 0;  // counted once for the motion
    }
  }
  return known;
}

MotionVerdict MotionCheck::judgeHelix(const Geometry& geometry, const std::vector<Pose>& path, const Helix& helix,
                                      double required, const StopToken& stop) {
  MotionVerdict result;
  result.minClearance = std::numeric_limits<double>::infinity();
  const Pose& from = path[helix.first];
  const Pose& to = path[helix.last + 1];
  if (!geometry.resolves(from, to, required) || geometry.container(placed(from)) >= 0) return result;
  const std::vector<bool> all(geometry.groups.size(), true);
  const std::size_t count = helix.last - helix.first + 1;
  const std::size_t step = std::max<std::size_t>(1, count / kDistancesOfHelix);
  for (std::size_t i = 0; i <= count; i += step) {
    if (stop.stopRequested()) return result;
    ++result.distances;
    const Nearest nearest = geometry.nearest(placed(path[helix.first + i]), result.minClearance, all);
    if (nearest.distance >= result.minClearance) continue;
    result.minClearance = nearest.distance;
    result.nearest = nearest;
  }
  double shown = result.minClearance;
  for (const auto& group : geometry.groups) {
    if (shown <= helix.off || stop.stopRequested()) return result;
    shown = std::min(shown, group->helixDistance(placed(from), helix, required + helix.off, shown, stop));
  }
  result.provedClearance = shown - helix.off;
  if (result.provedClearance < required) return result;
  result.certified = 1.0;
  result.status = Status::Certified;
  return result;
}

/// Proves the edges of a turn as one motion; if that fails, in two halves.
void MotionCheck::proveTurns(const std::vector<Pose>& path, const std::vector<Demand>& demands, const Thread& thread,
                             const Run& run, Proofs& proofs, const StopToken& stop) const {
  if (stop.stopRequested()) return;
  double reach = 0.0;
  for (const Vector3& vertex : geometry_->object.vertices) reach = std::max(reach, vertex.norm());
  const Vector3 point = geometry_->scale * thread.point;
  const Rise rise = riseOf(path, run.first, run.last, point, thread.axis, reach);
  double required = 0.0;
  for (std::size_t i = run.first; i <= run.last; ++i) required = std::max(required, demands[i].clearance);
  std::vector<bool> open = proofs[run.first]->open;
  const double proved =
      geometry_->proveTurn(placed(path[run.first]), point, thread.axis, rise, geometry_->scale * required, open, stop);
  for (std::size_t i = run.first; i <= run.last; ++i) {
    proofs[i]->open = open;
    proofs[i]->proved = std::min(proofs[i]->proved, proved);
  }
  const bool done = std::none_of(open.begin(), open.end(), [](bool each) { return each; });
  if (done || run.last - run.first < run.least || run.first == run.last) return;
  const std::size_t middle = (run.first + run.last) / 2;
  proveTurns(path, demands, thread, {run.first, middle, run.least}, proofs, stop);
  proveTurns(path, demands, thread, {middle + 1, run.last, run.least}, proofs, stop);
}

/// Consecutive edges that turn in one thread are one motion.
MotionCheck::Proofs MotionCheck::turnProofs(const std::vector<Pose>& path, const std::vector<Demand>& demands,
                                            const std::vector<const Thread*>& turned, const StopToken& stop) const {
  Proofs proofs(demands.size());
  const std::vector<bool> all(geometry_->groups.size(), true);
  for (std::size_t first = 0; first < turned.size() && path.size() > 1; ++first) {
    if (turned[first] == nullptr) continue;
    Run run{first, first, 0};
    while (run.last + 1 < turned.size() && turned[run.last + 1] == turned[first]) ++run.last;
    const std::size_t count = run.last - first + 1;
    run.least = count / kPartsOfTurn;
    for (std::size_t i = first; i <= run.last; ++i) proofs[i].emplace().open = all;
    proveTurns(path, demands, *turned[first], run, proofs, stop);
    TurnProof met;
    for (std::size_t i = 0; i <= count; i += std::max<std::size_t>(1, count / kDistancesOfHelix)) {
      if (stop.stopRequested()) return proofs;
      const Nearest nearest = geometry_->nearest(placed(path[first + i]), met.minClearance, all);
      if (nearest.distance >= met.minClearance) continue;
      met.minClearance = nearest.distance;
      met.nearest = nearest;
    }
    for (std::size_t i = first; i <= run.last; ++i) {
      proofs[i]->minClearance = met.minClearance;
      proofs[i]->nearest = met.nearest;
    }
    first = run.last;
  }
  return proofs;
}

MotionVerdict MotionCheck::check(const std::vector<Pose>& path, const std::vector<Demand>& demands,
                                 const WorkWatch& watch) const {
  const StopToken& stop = watch.stop;
  MotionVerdict result;
  const auto helices = judgeHelices(path, demands, stop);
  const auto threaded = threads_ ? threads_->judge(path, stop) : std::vector<ThreadMotion::Edge>();
  std::vector<const Thread*> turned;
  for (const ThreadMotion::Edge& edge : threaded) {
    turned.push_back(edge.forbiddenBy < 0 && edge.thread != nullptr && edge.thread->mayTurn ? edge.thread : nullptr);
  }
  const std::vector<Pose> scaled = scaledPath(path, geometry_->scale);
  std::optional<Nearest> atEnd;
  const Geometry* askedBefore = nullptr;
  const Proofs proofs = turnProofs(scaled, demands, turned, stop);
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const Pose& to = scaled[std::min(i + 1, path.size() - 1)];
    const bool free = i < threaded.size() && !threaded[i].engaged;
    const Geometry& geometry = free ? *whole_ : *geometry_;
    MotionVerdict edge;
    if (helices[i]) {
      edge = *helices[i];
      askedBefore = nullptr;
    } else if (i < threaded.size() && threaded[i].forbiddenBy >= 0) {
      edge.status = Status::Violated;
      edge.againstThread = true;
      edge.nearest.body = threaded[i].forbiddenBy;
    } else {
      const TurnProof* proof = proofs[i] ? &*proofs[i] : nullptr;
      if (proof != nullptr || askedBefore != &geometry) atEnd.reset();
      const double required = geometry.scale * demands[i].clearance;
      edge = inMetres(checkEdge(geometry, scaled[i], to, required, proof, atEnd, stop), geometry.scale);
      askedBefore = proof == nullptr ? &geometry : nullptr;
    }
    addEdge(result, edge, demands[i]);
    watch.report(static_cast<double>(i + 1) / static_cast<double>(demands.size()));
    if (result.status != Status::Certified) break;
  }
  return result;
}

Message MotionCheck::whyUndecided(const Pose& from, const Pose& to, double requiredClearance) const {
  const double scale = geometry_->scale;
  const Pose begin = scaledPose(from, scale);
  const Pose end = scaledPose(to, scale);
  if (Course(begin, end).isHalfACircle()) {
    return GLISSADE_TEXT(
        "the edge turns by half a circle, and rounding decides which way; insert a configuration between its ends");
  }
  if (!geometry_->resolves(begin, end, scale * requiredClearance)) {
    return GLISSADE_TEXT(
        "the rounding of coordinates of this size is not small against the required clearance; move the scene to "
        "the origin, or require more clearance");
  }
  return {
      GLISSADE_TEXT("the clearance is so close to the required one that %1 comparisons of triangles do not prove it; "
                    "require less clearance, or divide the edge"),
      {EdgeProof::kMostCompared}};
}

/// Works in the scaled geometry. A motion that is straight, or nearly so, is proved by the volume that the object
/// sweeps; other motions, and those whose sweep comes too near, triangle by triangle.
MotionVerdict MotionCheck::checkEdge(const Geometry& geometry, const Pose& from, const Pose& to, double required,
                                     const TurnProof* turned, std::optional<Nearest>& atEnd, const StopToken& stop) {
  const Course course(from, to);
  MotionVerdict result;
  result.demanded = required;
  result.minClearance = result.provedClearance = std::numeric_limits<double>::infinity();
  // The object stays outside of bodies from one edge to the next, so containment is tested only where an edge has no
  // predecessor.
  if (const int body = atEnd ? -1 : geometry.container(course.at(0.0)); body >= 0) {
    result.status = Status::Violated;
    result.minClearance = result.provedClearance = 0.0;
    result.nearest.body = body;
    return result;
  }
  if (course.isHalfACircle() || !geometry.resolves(from, to, required)) return result;
  std::vector<bool> asked(geometry.groups.size(), true);
  if (turned != nullptr) {
    asked = turned->open;
    result.provedClearance = turned->proved;
    result.minClearance = turned->minClearance;
    result.nearest = turned->nearest;
  }
  if (std::none_of(asked.begin(), asked.end(), [](bool open) { return open; })) {
    result.status = Status::Certified;
  } else {
    meetEnds(geometry, course, asked, atEnd, result);
    if (stop.stopRequested() || result.status == Status::Violated) return result;
    if (!proveStanding(geometry, course, result) && !proveBySweep(geometry, course, asked, result))
      proveByPieces(geometry, course, asked, stop, result);
  }
  if (result.status == Status::Certified) result.certified = 1.0;
  return result;
}

/// Measures the distances at the ends. `atEnd`: the distance at the end of the previous edge, if known; afterwards that
/// of this edge.
void MotionCheck::meetEnds(const Geometry& geometry, const Course& course, const std::vector<bool>& asked,
                           std::optional<Nearest>& atEnd, MotionVerdict& result) {
  const auto meet = [&](double t) {
    const Nearest& nearest = *atEnd;
    if (nearest.distance < result.minClearance) {
      result.minClearance = nearest.distance;
      result.at = t;
      result.nearest = nearest;
    }
    if (nearest.distance < result.demanded) result.status = Status::Violated;
  };
  const auto nearestAt = [&](double t) {
    ++result.distances;
    return geometry.nearest(course.at(t), std::numeric_limits<double>::infinity(), asked);
  };
  if (!atEnd) atEnd = nearestAt(0.0);
  meet(0.0);
  atEnd = nearestAt(1.0);
  meet(1.0);
}

/// Proves an edge without motion.
bool MotionCheck::proveStanding(const Geometry& geometry, const Course& course, MotionVerdict& result) {
  if (course.speed(geometry.object) > 0.0) return false;
  result.provedClearance = std::min(result.provedClearance, result.minClearance);
  result.status = Status::Certified;
  return true;
}

/// The sweep approaches obstacles as the object does, except for the object's turn, whose effect is subtracted.
bool MotionCheck::proveBySweep(const Geometry& geometry, const Course& course, const std::vector<bool>& asked,
                               MotionVerdict& result) {
  const double turn = course.turn(geometry.object);
  if (turn > distances::kErrorShare * result.demanded) return false;
  ++result.distances;
  const double enough = std::max(2.0 * result.demanded, result.minClearance);
  const Nearest swept = geometry.nearestToSweep(course.at(0.0), course.way(), enough, asked);
  if (swept.distance - turn < result.demanded) return false;
  if (swept.distance < result.minClearance) {
    result.minClearance = swept.distance;
    result.nearest = swept;
    result.at = 0.5;
  }
  result.provedClearance = std::min(result.provedClearance, swept.distance - turn);
  result.status = Status::Certified;
  return true;
}

/// Proves the clearance down to a share of the smallest distance met, which includes distances of triangles.
void MotionCheck::proveByPieces(const Geometry& geometry, const Course& course, const std::vector<bool>& asked,
                                const StopToken& stop, MotionVerdict& result) {
  EdgeProof proof(course, stop);
  const auto wanted = [&] { return std::max(result.demanded, kCloseShare * result.minClearance); };
  for (std::size_t i = 0; i < geometry.groups.size(); ++i) {
    const Group& group = *geometry.groups[i];
    const double error =
        std::max(group.errorAt(course.at(0.0).translation()), group.errorAt(course.at(1.0).translation()));
    const double motion = 0.5 * course.speed(group.object) + error;
    for (std::size_t k = 0; asked[i] && k < group.obstacles.size(); ++k) {
      if (group.leastDistance(*group.obstacles[k], course.at(0.5)) - motion >= wanted()) continue;
      MetOnEdge met;
      auto answer = EdgeProof::Answer::Near;
      while (answer == EdgeProof::Answer::Near) {
        ++result.distances;
        answer =
            proof.stayApart(group.objectSurface.pieces(), group.obstacles[k]->surface.pieces(), wanted(), error, met);
        if (answer == EdgeProof::Answer::Open) return;
        if (answer == EdgeProof::Answer::Apart) break;
        result.minClearance = met.distance;
        result.at = met.at;
        result.nearest = {met.distance, group.numbers[k], met.onFixed, met.onMoving};
        if (met.distance >= result.demanded) continue;
        result.status = Status::Violated;
        return;
      }
    }
  }
  result.provedClearance = std::min(result.provedClearance, wanted());
  result.status = Status::Certified;
}

}  // namespace glissade::check
