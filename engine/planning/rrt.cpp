#include "engine/planning/rrt.h"

#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/planning/goal_roots.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

constexpr double kGoalBias = 0.05;

}  // namespace

Rrt::Rrt(const Problem& problem, std::uint64_t seed, Limit limit)
    : problem_(problem),
      limit_(limit),
      query_(problem.world->makeQuery()),
      goalStream_(seed, "goal bias"),
      randomShooter_(problem, seed),
      roadmap_(problem.metric()) {
  startRoot_ = roadmap_.addRoot({problem_.start, Author::Computer, TreeSide::Start});
  goals_ = goalRoots(problem_, *query_);
  counts_.nodes = roadmap_.nodes().size();
}

bool Rrt::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    iterate(host);
    counts_.nodes = roadmap_.nodes().size();
    counts_.edges = roadmap_.directedEdgeCount();
    counts_.droppedEdges = roadmap_.droppedEdges().size();
    counts_.queries = query_->counts();
    if (!path_ && limit_ == Limit::GlobalSamples &&
        static_cast<double>(counts_.randomConfigurations) >= host.parameters()[ParameterId::GlobalSamples]) {
      failure_ = Diagnostic{ErrorKind::LimitReached, "", "", "strategy G found no path within its limit of samples",
                            "Raise --global-samples, or use strategy gts."};
    }
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void Rrt::iterate(PlannerHost& host) {
  ++counts_.iterations;
  ++counts_.steps;
  ++counts_.randomConfigurations;
  const double draw = goalStream_.uniform();
  const bool towardsGoal = draw < kGoalBias && !goals_.empty();
  const auto which = static_cast<std::size_t>(draw / kGoalBias * static_cast<double>(goals_.size()));
  const Pose q = towardsGoal ? goals_[which] : randomShooter_.shoot();
  const auto extension = extend(q, host);
  if (towardsGoal && extension && extension->reached) deliverPath(extension->node, host);
}

std::optional<Rrt::Extension> Rrt::extend(const Pose& q, PlannerHost& host) {
  const auto near = roadmap_.nearest(roadmap_.componentOf(startRoot_), q);
  const double radius = problem_.world->objectRadius();
  if (near.distance == 0.0) return Extension{near.index, true};
  const Pose from = roadmap_.nodes()[near.index].q;
  const ParameterValues& parameters = host.parameters();
  const double free = freeFraction(*query_, from, q, parameters[ParameterId::GrowthStep], host.stopToken());
  double t = 1.0;
  if (free < 1.0) {
    const double step = parameters[ParameterId::ExtensionStep];
    t = std::floor(free * near.distance / step) * step / near.distance;
    if (t * near.distance < tolerance::kSameConfiguration * radius) return std::nullopt;
  }
  const RoadmapGraph::Node node =
      roadmap_.addChild(near.index, {t < 1.0 ? interpolate(from, q, t) : q, Author::Computer, TreeSide::Start});
  return Extension{node, t >= 1.0};
}

void Rrt::deliverPath(RoadmapGraph::Node goal, PlannerHost& host) {
  const auto way = roadmap_.way(startRoot_, goal);
  if (!way) return;
  Path path;
  for (const RoadmapGraph::Node node : way->nodes) path.points.push_back({roadmap_.nodes()[node].q, Author::Computer});
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status == CertificateStatus::Certified) {
    path_ = std::move(path);
  } else if (!host.stopToken().stopRequested()) {
    roadmap_.dropEdge(way->edges[path.certificate.edge]);
  }
}

}  // namespace glissade
