#include "engine/planning/interactive/hand_planner.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// Steps of a turn. The way of the hand has the first turn, so that it is kept where it is of use.
constexpr std::uint64_t kStepsOfTurn = 2'000;

SubPlanner withoutLimit(std::unique_ptr<Planner> planner) {
  return {std::move(planner), std::numeric_limits<std::uint64_t>::max(), nullptr};
}

bool isComputerAlone(const ParameterValues& parameters) {
  return parameters[ParameterId::Alpha] >= 1.0 && (parameters.integer(ParameterId::Tuning) & kTunedAlpha) == 0;
}

/// Appends a part that begins where the path ends.
void appendPart(const std::vector<PathPoint>& part, std::vector<PathPoint>& path) {
  if (!path.empty() && !part.empty()) path.back().author = part.front().author;
  path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
}

}  // namespace

/// The planners that finish a run.
struct HandPlanner::Rest {
  std::vector<PathPoint> way;        ///< of the hand; empty: there is none
  std::optional<SubPlanner> before;  ///< from the start to the way; nothing: it begins there
  std::optional<SubPlanner> after;   ///< from the way to the goal; nothing: it ends there
  SubPlanner whole;
  std::uint64_t steps = 0;

  static bool isMissing(const std::optional<SubPlanner>& leg) { return leg && leg->planner().path() == nullptr; }
  bool isJoined() const { return !way.empty() && !isMissing(before) && !isMissing(after); }
  /// The planner whose turn it is.
  SubPlanner& next() {
    const bool wayHasTurn = !way.empty() && steps / kStepsOfTurn % 2 == 0;
    if (wayHasTurn && isMissing(before)) return *before;
    if (wayHasTurn && isMissing(after)) return *after;
    return whole;
  }
};

HandPlanner::HandPlanner(const Problem& problem, std::uint64_t seed)
    : problem_(problem),
      seed_(seed),
      query_(problem.world->makeQuery()),
      hand_(new InteractiveContactBirrt(problem, seed, OperatorUse::GuideContactAndTrail)),
      handSteps_(withoutLimit(std::unique_ptr<Planner>(hand_))) {
  handSteps_.collect(roadmap_);
  updateCounts();
}

HandPlanner::~HandPlanner() = default;

bool HandPlanner::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    if (isComputerAlone(host.parameters())) {
      stepOfComputer(host);
    } else {
      stepOfHand(host);
    }
    updateCounts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

const Planner* HandPlanner::inner() const { return rest_ ? &rest_->next().planner() : hand_; }

void HandPlanner::completeRoadmap() {
  if (!rest_) return;
  for (auto* leg : {&rest_->before, &rest_->after}) {
    if (*leg) (*leg)->complete(roadmap_);
  }
  rest_->whole.complete(roadmap_);
  updateCounts();
}

void HandPlanner::stepOfHand(PlannerHost& host) {
  rest_.reset();
  if (handSteps_.step(host, roadmap_) == SubPlanner::State::Solved) path_ = *hand_->path();
}

void HandPlanner::stepOfComputer(PlannerHost& host) {
  if (!rest_) beginRest(host);
  SubPlanner& planner = rest_->next();
  const SubPlanner::State state = planner.step(host, roadmap_);
  ++rest_->steps;
  if (state == SubPlanner::State::Running) return;
  if (&planner == &rest_->whole) {
    if (state == SubPlanner::State::Solved) path_ = *planner.planner().path();
    failure_ = planner.planner().failure();
  } else if (state == SubPlanner::State::Failed) {
    rest_->way.clear();
  } else if (rest_->isJoined()) {
    deliverRest(host);
  }
}

void HandPlanner::beginRest(PlannerHost& host) {
  const auto automatic = [this](const Problem& problem) {
    return withoutLimit(std::make_unique<AutomaticPlanner>(problem, seed_));
  };
  InteractiveContactBirrt::HandWay way = hand_->handWay(host);
  std::optional<SubPlanner> before;
  std::optional<SubPlanner> after;
  if (!way.points.empty() && !way.fromStart) {
    Problem part = problem_;
    part.goal = way.points.front().q;
    before = automatic(part);
  }
  if (!way.points.empty() && !way.toGoal) {
    Problem part = problem_;
    part.start = way.points.back().q;
    after = automatic(part);
  }
  rest_ = std::make_unique<Rest>(Rest{std::move(way.points), std::move(before), std::move(after), automatic(problem_)});
}

/// Delivers the way of the hand with the parts that were planned before and after it.
void HandPlanner::deliverRest(PlannerHost& host) {
  Path path;
  if (rest_->before) appendPart(rest_->before->planner().path()->points, path.points);
  appendPart(rest_->way, path.points);
  if (rest_->after) appendPart(rest_->after->planner().path()->points, path.points);
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status == CertificateStatus::Certified) {
    path_ = std::move(path);
  } else {
    rest_->way.clear();
  }
}

void HandPlanner::updateCounts() {
  PlannerCounts& counts = roadmap_.counts;
  counts.nodes = roadmap_.nodes.size();
  counts.edges = 2 * (roadmap_.edges.size() - roadmap_.droppedEdges.size());
  counts.droppedEdges = roadmap_.droppedEdges.size();
}

}  // namespace glissade
