#include "engine/planning/threaded_planner.h"

#include <algorithm>
#include <utility>

#include "engine/planning/path_certificate.h"

namespace glissade {
/// Collects the nodes of the inner planner before the run's host sees them.
class ThreadedPlanner::Host final : public PlannerHost {
 public:
  Host(PlannerHost& host, ThreadedPlanner& planner) : host_(host), planner_(planner) {}

  std::optional<OperatorSample> operatorSample() override { return host_.operatorSample(); }
  const ParameterValues& parameters() const override { return host_.parameters(); }
  bool afterStep() override {
    planner_.takeGrown();
    return host_.afterStep();
  }
  const StopToken& stopToken() const override { return host_.stopToken(); }
  SemanticEditsPtr semanticEdits() const override { return host_.semanticEdits(); }

 private:
  PlannerHost& host_;
  ThreadedPlanner& planner_;
};

ThreadedPlanner::ThreadedPlanner(Problem problem, Make make, std::unique_ptr<const ScrewWays> ways)
    : problem_(std::move(problem)),
      make_(std::move(make)),
      ways_(std::move(ways)),
      query_(problem_.world->makeQuery()) {
  addChain({problem_.start}, TreeSide::Start);
}

bool ThreadedPlanner::solve(PlannerHost& host) {
  if (!prepared_ && !prepare(host)) return path_.has_value();
  Host collecting(host, *this);
  const bool solved = rest_->solve(collecting);
  takeGrown();
  return solved && deliver(host, rest_->path()->points);
}

/// Finds the screw motions. False if no planner is needed for the rest, or it cannot be reached.
bool ThreadedPlanner::prepare(PlannerHost& host) {
  const double required = host.parameters()[ParameterId::RequiredClearance];
  const Pose* goal = std::get_if<Pose>(&problem_.goal);
  if (goal != nullptr) {
    out_ = ways_->between(*query_, problem_.start, *goal, required, host.stopToken());
    if (!out_.empty()) {
      deliver(host, {});
      return false;
    }
  }
  if (!findWays(problem_.start, host, out_)) return false;
  if (goal != nullptr && !findWays(*goal, host, in_)) return false;
  if (host.stopToken().stopRequested()) return false;
  prepared_ = true;
  Problem rest = problem_;
  if (!out_.empty()) rest.start = out_.back();
  if (!in_.empty()) rest.goal = in_.back();
  nodes_.clear();
  edges_.clear();
  addChain(out_.empty() ? std::vector<Pose>{problem_.start} : out_, TreeSide::Start);
  addChain(in_, TreeSide::Goal);
  ownNodes_ = nodes_.size();
  ownEdges_ = edges_.size();
  counts_.nodes = nodes_.size();
  counts_.edges = 2 * edges_.size();
  rest_ = make_(rest);
  return true;
}

/// Finds the shortest screw motion; for the goal "out", one after which the way straight ahead is free is preferred.
bool ThreadedPlanner::findWays(const Pose& end, PlannerHost& host, std::vector<Pose>& way) {
  const double required = host.parameters()[ParameterId::RequiredClearance];
  ScrewSearch search = ways_->out(*query_, end, required, host.stopToken());
  counts_.queries = query_->counts();
  if (!search.engaged || host.stopToken().stopRequested()) return true;
  if (search.ways.empty()) {
    failure_ = Diagnostic{ErrorKind::NoPath, "", "", search.why,
                          GLISSADE_TEXT("Remove what is named first, or change the thread.")};
    return false;
  }
  const double ahead = 2.0 * (problem_.world->obstaclesBox().diagonal().norm() + problem_.world->objectRadius());
  const auto leadsOut = [&](const ScrewWay& each) {
    Pose far = each.configurations.back();
    far.position += ahead * each.direction_W;
    return query_->checkMotion(each.configurations.back(), far, required, SeekViolation::Any, host.stopToken())
               .status == CertificateStatus::Certified;
  };
  const auto best = std::find_if(search.ways.begin(), search.ways.end(), leadsOut);
  way = std::move((best == search.ways.end() ? search.ways.begin() : best)->configurations);
  return true;
}

void ThreadedPlanner::addChain(const std::vector<Pose>& poses, TreeSide side) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    if (i > 0) edges_.push_back({number - 1, number});
    nodes_.push_back({poses[i], Author::Computer, side});
  }
}

void ThreadedPlanner::takeGrown() {
  const auto shift = static_cast<std::uint32_t>(ownNodes_);
  const auto& nodes = rest_->nodes();
  const auto& edges = rest_->edges();
  for (std::size_t i = nodes_.size() - ownNodes_; i < nodes.size(); ++i) nodes_.push_back(nodes[i]);
  for (std::size_t i = edges_.size() - ownEdges_; i < edges.size(); ++i) {
    edges_.push_back({edges[i].from + shift, edges[i].to + shift});
  }
  const auto& dropped = rest_->droppedEdges();
  for (std::size_t i = dropped_.size(); i < dropped.size(); ++i) {
    dropped_.push_back(dropped[i] + static_cast<std::uint32_t>(ownEdges_));
  }
  counts_ = rest_->counts();
  counts_.nodes += ownNodes_;
  counts_.edges += 2 * ownEdges_;
}

void ThreadedPlanner::completeRoadmap() {
  if (!rest_) return;
  rest_->completeRoadmap();
  takeGrown();
}

std::optional<Diagnostic> ThreadedPlanner::failure() const { return failure_ || !rest_ ? failure_ : rest_->failure(); }

bool ThreadedPlanner::deliver(PlannerHost& host, const std::vector<PathPoint>& middle) {
  Path path;
  path.points = computedPoints(out_);
  if (!path.points.empty() && !middle.empty()) path.points.pop_back();
  path.points.insert(path.points.end(), middle.begin(), middle.end());
  if (!in_.empty()) {
    path.points.pop_back();
    const std::vector<PathPoint> in = computedPoints({in_.rbegin(), in_.rend()});
    path.points.insert(path.points.end(), in.begin(), in.end());
  }
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status != CertificateStatus::Certified) {
    if (host.stopToken().stopRequested()) return false;
    failure_ =
        Diagnostic{ErrorKind::NoPath, "", "", GLISSADE_TEXT("the path through the threads could not be certified"),
                   GLISSADE_TEXT("Require less clearance.")};
    return false;
  }
  path_ = std::move(path);
  return true;
}

}  // namespace glissade
