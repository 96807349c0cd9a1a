#include "engine/check/motion_setup.h"

#include <algorithm>
#include <map>

namespace glissade::check {
namespace {

/// The mesh to whose triangles the allowances belong.
const MeshPtr& meshOf(const Body& body, const MeshPtr& divided, const std::vector<double>& allowances) {
  return divided && !allowances.empty() ? divided : body.mesh;
}

}  // namespace
JudgedMotion judgeMotion(const MotionQuestion& question, MotionBodies& prepared, const WorkWatch& watch) {
  // After a stop, the question may lack pairs.
  if (watch.stop.stopRequested()) return {{}, GLISSADE_TEXT("the check was stopped")};
  std::map<MeshPtr, MeshPtr> inPathFrame;  // shapes of the object in the frame of the path
  const auto placed = [&](const MeshPtr& mesh) {
    MeshPtr& known = inPathFrame[mesh];
    if (!known) known = std::make_shared<const TriangleMesh>(transformed(*mesh, question.X_PB));
    return known;
  };
  const MeshPtr whole = placed(question.moving.mesh);
  std::vector<MeshPtr> objects;  // the object's shape for each pair
  std::vector<MeshPtr> others;
  std::vector<const TriangleMesh*> meshes{whole.get()};
  std::vector<Body> bodies{question.moving};
  for (const MotionPair& pair : question.pairs) {
    if (watch.stop.stopRequested()) return {{}, GLISSADE_TEXT("the check was stopped")};
    const PairFit& fit = pair.fit;
    objects.push_back(placed(fit.hollowMoving ? fit.hollowMoving
                                              : prepared.taken(meshOf(question.moving, fit.meshOfMoving, fit.moving),
                                                               fit.moving, fit.share, fit.coreOfMoving())));
    others.push_back(fit.hollowOther ? fit.hollowOther
                                     : prepared.taken(meshOf(*pair.other, fit.meshOfOther, fit.other), fit.other,
                                                      fit.share, fit.coreOfOther()));
    for (const MeshPtr& mesh : {objects.back(), others.back()}) meshes.push_back(mesh.get());
    bodies.push_back(*pair.other);
  }
  const double scale = prepared.scaleFor(meshes, bodies);
  std::vector<MotionCheck::Against> against;
  std::vector<MotionCheck::Threaded> threads;
  for (std::size_t i = 0; i < question.pairs.size(); ++i) {
    if (watch.stop.stopRequested()) return {{}, GLISSADE_TEXT("the check was stopped")};
    const MotionPair& pair = question.pairs[i];
    against.push_back({prepared.obstacle(others[i], pair.other->X_WB, scale), objects[i]});
    if (!pair.fit.thread) continue;
    Thread thread = *pair.fit.thread;
    thread.other = i;
    thread.assembled = thread.assembled * inverse(question.X_PB);
    const auto wholeOther = prepared.obstacle(pair.other->mesh, pair.other->X_WB, scale);
    threads.push_back({thread, pair.other->mesh, pair.other->X_WB, wholeOther});
  }
  const MotionCheck check(against, *whole, scale, threads);
  JudgedMotion judged{check.check(question.path, question.demands, watch), {}};
  MotionVerdict& verdict = judged.verdict;
  const std::size_t edge = verdict.edge;
  if (verdict.status == Status::Undecided) {
    const std::size_t end = std::min(edge + 1, question.path.size() - 1);
    judged.why = watch.stop.stopRequested()
                     ? Message(GLISSADE_TEXT("the check was stopped"))
                     : check.whyUndecided(question.path[edge], question.path[end], question.demands[edge].clearance);
  }
  const auto named = [&](int& body) {
    if (body >= 0) body = static_cast<int>(question.pairs[static_cast<std::size_t>(body)].body);
  };
  named(verdict.nearest.body);
  for (EdgeVerdict& each : verdict.edges) named(each.nearest.body);
  return judged;
}

std::vector<Pose> configurationsOf(const std::vector<Point>& points) {
  std::vector<Pose> path;
  for (const Point& point : points) path.push_back({point.q.position, point.q.orientation.normalized()});
  return path;
}

std::vector<Demand> demandsOf(const std::vector<Point>& points, double required, double contactGap) {
  constexpr double kGapShare = 0.5;
  std::vector<Demand> demands;
  const std::size_t edges = std::max<std::size_t>(1, points.size() - 1);
  for (std::size_t i = 0; i < edges; ++i) {
    const bool sliding = points[i].contact || points[std::min(i + 1, points.size() - 1)].contact;
    demands.push_back({sliding ? std::min(required, kGapShare * contactGap) : required, sliding});
  }
  return demands;
}

}  // namespace glissade::check
