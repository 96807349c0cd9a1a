#include "engine/planning/automatic/path_repair.h"

#include <algorithm>
#include <limits>

#include "engine/planning/automatic/retraction.h"
#include "engine/planning/automatic/tube_sampler.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

constexpr int kAttempts = 12;  // attempts to make a configuration free
/// Standard deviation of the random move in the last attempt, in units of the growth of the object.
constexpr double kSpread = 1.5;
/// Queries of the first search for a gap; each further search has twice as many.
constexpr std::uint64_t kFirstGapWork = 1'000;
/// Number of queries that one motion check counts as.
constexpr std::uint64_t kMotionQueries = 5;
/// Number of configurations by which a gap is widened on either side.
constexpr std::size_t kWidening = 3;

}  // namespace

std::uint64_t queriesOf(const PlannerCounts& counts) {
  return counts.queries.collision + counts.queries.distance + kMotionQueries * counts.queries.motion;
}

PathRepair::PathRepair(const Problem& problem, std::uint64_t seed, std::vector<Pose> way, Options options)
    : problem_(problem),
      options_(std::move(options)),
      seed_(seed),
      stream_(seed, "repair"),
      query_(problem.world->makeQuery()),
      smallerQuery_(options_.smaller->makeQuery()),
      way_(std::move(way)) {}

bool PathRepair::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    step(host);
    updateCounts();
    if (!path_ && queriesOf(counts_) > options_.work) {
      failure_ =
          Diagnostic{ErrorKind::NoPath, "", "",
                     GLISSADE_TEXT("the path of the shrunk object could not be repaired for the full-size object"),
                     GLISSADE_TEXT("Start again with another seed.")};
    }
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void PathRepair::step(PlannerHost& host) {
  ++counts_.iterations;
  ++counts_.steps;
  if (retracted_ + 1 < way_.size()) {
    retractNext();
  } else if (search_) {
    searchGap(host);
  } else if (linked_ + 1 < way_.size()) {
    linkNext(host);
  } else {
    deliver(host);
  }
}

/// Makes the next configuration of the way free, or leaves it out.
void PathRepair::retractNext() {
  const auto at = way_.begin() + static_cast<std::ptrdiff_t>(retracted_);
  if (const auto q = moveToClearance(*at)) {
    *at = *q;
    ++retracted_;
  } else {
    way_.erase(at);
  }
}

std::optional<Pose> PathRepair::moveToClearance(const Pose& q) {
  if (options_.grownBy <= 0.0) return q;
  const double radius = problem_.world->objectRadius();
  Pose from = q;
  for (int attempt = 1; attempt <= kAttempts; ++attempt) {
    const auto free = retracted(*smallerQuery_, from, options_.grownBy, radius);
    if (free && problem_.bounds.contains(free->position) && !query_->collides(*free)) return free;
    from = perturbed(q, kSpread * options_.grownBy * attempt / kAttempts, radius, problem_.bounds, stream_);
  }
  return std::nullopt;
}

void PathRepair::linkNext(PlannerHost& host) {
  const MotionCheck check =
      query_->checkMotion(way_[linked_], way_[linked_ + 1], host.parameters()[ParameterId::RequiredClearance],
                          SeekViolation::Any, host.stopToken());
  if (check.status == CertificateStatus::Certified) {
    ++linked_;
  } else if (!host.stopToken().stopRequested()) {
    first_ = linked_;
    last_ = linked_ + 1;
    gapWork_ = kFirstGapWork;
    startGap();
  }
}

void PathRepair::startGap() {
  Problem part = problem_;
  part.start = way_[first_];
  part.goal = way_[last_];
  const std::vector<Pose> around(way_.begin() + static_cast<std::ptrdiff_t>(first_),
                                 way_.begin() + static_cast<std::ptrdiff_t>(last_) + 1);
  const std::uint64_t seed = RandomStream(seed_, "gap " + std::to_string(++searches_)).bits();
  const double deviation = std::max(options_.grownBy, 0.5 * part.metric().distance(part.start, way_[last_]));
  auto sampler = std::make_unique<TubeSampler>(part, around, deviation, seed);
  auto search = std::make_unique<RrtConnect>(part, seed, options_.search, std::move(sampler));
  search_ = std::make_unique<SubPlanner>(std::move(search), std::numeric_limits<std::uint64_t>::max(), nullptr);
}

void PathRepair::searchGap(PlannerHost& host) {
  const SubPlanner::State state = search_->step(host, gap_);
  if (state == SubPlanner::State::Solved) {
    const std::vector<Pose> bridge = search_->planner().path()->configurations();
    const auto begin = way_.begin() + static_cast<std::ptrdiff_t>(first_);
    way_.erase(begin, begin + static_cast<std::ptrdiff_t>(last_ - first_) + 1);
    way_.insert(way_.begin() + static_cast<std::ptrdiff_t>(first_), bridge.begin(), bridge.end());
    linked_ = first_ + bridge.size() - 1;
    retracted_ = way_.size();
    search_.reset();
  } else if (queriesOf(search_->planner().counts()) > gapWork_) {
    first_ -= std::min(first_, kWidening);
    last_ = std::min(way_.size() - 1, last_ + kWidening);
    gapWork_ *= 2;
    startGap();
  }
}

void PathRepair::deliver(PlannerHost& host) {
  Path path;
  for (const Pose& q : way_) path.points.push_back({q, Author::Computer});
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  // The repair was stopped, because every motion was certified before.
  if (path.certificate.status != CertificateStatus::Certified) return;
  for (const Pose& q : way_) {
    if (!nodes_.empty()) {
      edges_.push_back({static_cast<std::uint32_t>(nodes_.size() - 1), static_cast<std::uint32_t>(nodes_.size())});
    }
    nodes_.push_back({q, Author::Computer, TreeSide::Start});
  }
  path_ = std::move(path);
}

void PathRepair::updateCounts() {
  counts_.queries = query_->counts();
  counts_.queries += smallerQuery_->counts();
  counts_.queries += gap_.counts.queries;
  counts_.randomConfigurations = gap_.counts.randomConfigurations;
  counts_.nodes = nodes_.size();
  counts_.edges = 2 * edges_.size();
}

}  // namespace glissade
