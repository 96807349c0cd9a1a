#include "engine/planning/automatic/direct_motions.h"

#include <algorithm>
#include <numbers>

#include "engine/planning/automatic/straight_ways_out.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// Height by which an object is lifted before it crosses, in its radii.
constexpr double kLifts[] = {0.5, 2.0};
/// Turn of a screw motion on the way out, radians, and the number of straight motions that it is made of.
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kScrewPieces = 16;

}  // namespace

DirectMotions::DirectMotions(const Problem& problem) : problem_(problem), query_(problem.world->makeQuery()) {
  nodes_.push_back({problem_.start, Author::Computer, TreeSide::Start});
  counts_.nodes = 1;
  const std::vector<Vector3> directions = likelyDirections(problem_);
  if (const Pose* goal = std::get_if<Pose>(&problem_.goal)) {
    addMotionsAcross(*goal, directions);
  } else if (!problem_.world->obstaclesBox().isEmpty()) {
    addMotionsOut(directions);
  }
}

void DirectMotions::addMotionsOut(const std::vector<Vector3>& directions) {
  for (const Vector3& direction : directions) {
    Pose out = problem_.start;
    out.position += distanceOut(problem_, problem_.start.position, direction) * direction;
    add({problem_.start, out});
  }
  for (const Vector3& direction : directions) {
    const double distance = distanceOut(problem_, problem_.start.position, direction);
    for (const double turn : {kTurn, -kTurn}) {
      std::vector<Pose> screw;
      for (int piece = 0; piece <= kScrewPieces; ++piece) {
        const double t = static_cast<double>(piece) / kScrewPieces;
        Pose q = problem_.start;
        q.position += t * distance * direction;
        q.orientation = (Quaternion(Eigen::AngleAxisd(t * turn, direction)) * q.orientation).normalized();
        screw.push_back(piece == 0 ? problem_.start : q);
      }
      add(std::move(screw));
    }
  }
}

void DirectMotions::addMotionsAcross(const Pose& goal, const std::vector<Vector3>& directions) {
  add({problem_.start, goal});
  for (const double lift : kLifts) {
    for (const Vector3& direction : directions) {
      const Vector3 by = lift * problem_.world->objectRadius() * direction;
      Pose above = problem_.start;
      Pose beyond = goal;
      above.position += by;
      beyond.position += by;
      add({problem_.start, above, beyond, goal});
    }
  }
}

void DirectMotions::add(std::vector<Pose> motion) {
  const bool within =
      std::all_of(motion.begin(), motion.end(), [&](const Pose& q) { return problem_.bounds.contains(q.position); });
  if (within) candidates_.push_back(std::move(motion));
}

bool DirectMotions::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    ++counts_.iterations;
    ++counts_.steps;
    tryNext(host);
    counts_.queries = query_->counts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void DirectMotions::tryNext(PlannerHost& host) {
  if (next_ == candidates_.size()) {
    failure_ = Diagnostic{ErrorKind::NoPath, "", "", GLISSADE_TEXT("no direct motion is free"),
                          GLISSADE_TEXT("Choose a planner that searches.")};
    return;
  }
  const std::vector<Pose>& motion = candidates_[next_];
  Path path;
  for (const Pose& q : motion) path.points.push_back({q, Author::Computer});
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status != CertificateStatus::Certified) {
    if (!host.stopToken().stopRequested()) ++next_;
    return;
  }
  for (std::size_t i = 1; i < motion.size(); ++i) {
    edges_.push_back({static_cast<std::uint32_t>(nodes_.size() - 1), static_cast<std::uint32_t>(nodes_.size())});
    nodes_.push_back({motion[i], Author::Computer, TreeSide::Start});
  }
  counts_.nodes = nodes_.size();
  counts_.edges = 2 * edges_.size();
  path_ = std::move(path);
}

}  // namespace glissade
