#include "engine/planning/direct_planner.h"

#include <algorithm>
#include <cmath>

#include "engine/planning/goal_roots.h"
#include "engine/planning/path_certificate.h"

namespace glissade {

DirectPlanner::DirectPlanner(const Problem& problem) : problem_(problem), query_(problem.world->makeQuery()) {
  const std::vector<Pose> goals = goalRoots(problem_, *query_);
  if (!goals.empty()) goal_ = goals.front();
  nodes_.push_back({problem_.start, Author::Computer, TreeSide::Start});
  counts_.nodes = 1;
}

void DirectPlanner::giveUp(const Message& reason) {
  failure_ = Diagnostic{ErrorKind::NoPath, "", "", reason, GLISSADE_TEXT("Choose a planner that searches.")};
}

bool DirectPlanner::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    ++counts_.iterations;
    ++counts_.steps;
    bool done = false;
    const auto q = goal_ ? next(nodes_.back().q, done, host) : std::nullopt;
    if (q) {
      edges_.push_back({static_cast<std::uint32_t>(nodes_.size() - 1), static_cast<std::uint32_t>(nodes_.size())});
      nodes_.push_back({*q, Author::Computer, TreeSide::Start});
    } else if (!host.stopToken().stopRequested()) {
      giveUp(GLISSADE_TEXT("the direct path to the goal is blocked"));
    }
    if (done) {
      Path path;
      for (const RoadmapNode& node : nodes_) path.points.push_back({node.q, node.author});
      path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
      if (path.certificate.status == CertificateStatus::Certified) {
        path_ = std::move(path);
      } else if (!host.stopToken().stopRequested()) {
        giveUp(GLISSADE_TEXT("the direct path to the goal is not free"));
      }
    }
    counts_.nodes = nodes_.size();
    counts_.edges = 2 * edges_.size();
    counts_.queries = query_->counts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

std::optional<Pose> LinearPlanner::next(const Pose& q, bool& done, PlannerHost& host) {
  const double free = freeFraction(query(), q, *goal(), host.parameters()[ParameterId::GrowthStep], host.stopToken());
  if (free < 1.0) return std::nullopt;
  done = true;
  return goal();
}

std::optional<Pose> PotentialFieldPlanner::next(const Pose& q, bool& done, PlannerHost& host) {
  constexpr int kPatience = 60;
  constexpr double kLeastGain = 1e-3;
  const Se3Metric metric = problem().metric();
  const double radius = metric.radius();
  const double distance = metric.distance(q, *goal());
  if (distance < bestDistance_ - kLeastGain * radius) {
    bestDistance_ = distance;
    stepsWithoutGain_ = 0;
  } else if (++stepsWithoutGain_ > kPatience) {
    return std::nullopt;
  }
  const double step = 0.1 * radius;
  const NearestObstacle nearest = query().nearestObstacle(q);
  const bool straight =
      freeFraction(query(), q, *goal(), host.parameters()[ParameterId::GrowthStep], host.stopToken()) >= 1.0;
  if (straight) {
    done = true;
    return goal();
  }
  // Attraction is a unit vector; repulsion grows from zero at `influence` to infinity at contact.
  const double influence = 0.5 * radius;
  Vector3 force = (goal()->position - q.position).normalized();
  if (nearest.distance < influence) {
    const Vector3 normal = nearest.normal_W();
    const double pushed = force.dot(normal);
    if (pushed < 0.0) force -= pushed * normal;  // slides along the surface
    force += 0.3 * (influence / std::max(nearest.distance, 1e-3 * influence) - 1.0) * normal;
  }
  Pose ahead = interpolate(q, *goal(), std::min(1.0, step / distance));
  if (force.norm() > 1e-9) ahead.position = q.position + std::min(step, nearest.distance) * force.normalized();
  const double free = freeFraction(query(), q, ahead, host.parameters()[ParameterId::GrowthStep], host.stopToken());
  if (free >= 1.0 && problem().bounds.contains(ahead.position)) return ahead;
  ahead.orientation = q.orientation;  // the turn caused the collision
  const double freeWithoutTurn =
      freeFraction(query(), q, ahead, host.parameters()[ParameterId::GrowthStep], host.stopToken());
  if (freeWithoutTurn < 0.1 || !problem().bounds.contains(ahead.position)) return std::nullopt;
  return interpolate(q, ahead, 0.9 * freeWithoutTurn);
}

}  // namespace glissade
