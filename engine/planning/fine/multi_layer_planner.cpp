#include "engine/planning/fine/multi_layer_planner.h"

#include <algorithm>

#include "engine/planning/goal_roots.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// Most random configurations of a step between two publications of its counts.
constexpr std::uint64_t kPublishEvery = 64;
/// Number of pairs of coarse paths with a reduced limit for each step. Each pair has four times the limit of the pair
/// before.
constexpr std::uint64_t kCautiousPairs = 3;
/// Least number of random configurations in a turn of the search of the whole workspace.
constexpr std::uint64_t kShortestTurn = 200;
/// Planner of the search of the whole workspace.
constexpr const char* kWholePlanner = "contact-birrt";

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// "the topological graph has no way from start to goal; forbidden: P4"
Message noWay(const CoarsePlan& plan) {
  Message reason = GLISSADE_TEXT("the topological graph has no path from start to goal");
  if (!plan.forbidden.empty()) reason = {GLISSADE_TEXT("%1; forbidden: %2"), {reason, joined(plan.forbidden)}};
  if (!plan.infiniteCost.empty()) {
    reason = {GLISSADE_TEXT("%1; of infinite cost by the rules: %2"), {reason, joined(plan.infiniteCost)}};
  }
  return reason;
}

/// True if the search of the whole workspace has used the limit of one step. It then ends where forbidden places leave
/// no coarse path.
bool isSpent(const SubPlanner& whole, const ParameterValues& parameters) {
  return whole.randomConfigurations() >= static_cast<std::uint64_t>(parameters[ParameterId::StepSamples]);
}

}  // namespace

MultiLayerPlanner::MultiLayerPlanner(const Problem& problem, std::uint64_t seed, StrategyRules rules)
    : problem_(problem),
      seed_(seed),
      rules_(std::move(rules)),
      query_(problem.world->makeQuery()),
      locals_(makeLocalPlannerRegistry()),
      edits_(problem.scene.edits) {
  const std::vector<Pose> goals = goalRoots(problem_, *query_);
  if (!goals.empty()) goal_ = goals.front();
  roadmap_.nodes.push_back({problem_.start, Author::Computer, TreeSide::Start});
}

MultiLayerPlanner::~MultiLayerPlanner() = default;

bool MultiLayerPlanner::inContactMode() const { return local_ && contactModeOf(local_->planner()); }

bool MultiLayerPlanner::solve(PlannerHost& host) {
  while (!path_ && !failure_) {
    noticeEdits(host);
    advance(host);
    PlannerCounts& counts = roadmap_.counts;
    counts.nodes = roadmap_.nodes.size();
    counts.edges = 2 * (roadmap_.edges.size() - roadmap_.droppedEdges.size());
    counts.droppedEdges = roadmap_.droppedEdges.size();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void MultiLayerPlanner::advance(PlannerHost& host) {
  switch (phase_) {
    case Phase::Prepare: prepare(host); break;
    case Phase::Coarse: planCoarsely(); break;
    case Phase::Milestones: drawMilestone(host); break;
    case Phase::Fine: crossPlace(host); break;
    case Phase::Deliver: deliver(host); break;
    case Phase::LastResort: searchWorkspace(host); break;
  }
}

/// Takes the environment model, or builds it where it is missing, and reads the rules.
void MultiLayerPlanner::prepare(PlannerHost& host) {
  knowledge_ = problem_.scene.knowledge;
  if (!knowledge_) {
    auto built = buildSceneKnowledge(problem_, host.parameters()[ParameterId::RequiredClearance], host.stopToken());
    if (!built && built.error().kind == ErrorKind::Interrupted) return;
    if (!built) {
      failure_ = built.error();
      return;
    }
    knowledge_ = std::move(*built);
    roadmap_.counts.randomConfigurations += knowledge_->randomConfigurations();
    roadmap_.counts.steps += knowledge_->randomConfigurations();
    plan_.coarseConfigurations += knowledge_->randomConfigurations();
  }
  if (!goal_) {
    fail(GLISSADE_TEXT("the workspace has no configuration outside the product"),
         GLISSADE_TEXT("Widen the workspace."));
    return;
  }
  coarse_.emplace(problem_, *goal_, knowledge_, rules_, edits_);
  phase_ = Phase::Coarse;
}

/// Takes over an edit while planning. A new coarse plan is made at once. Milestones and crossings that the edit does
/// not touch are kept.
void MultiLayerPlanner::noticeEdits(PlannerHost& host) {
  SemanticEditsPtr now = host.semanticEdits();
  if (!now || now == edits_) return;
  edits_ = std::move(now);
  if (coarse_ && coarse_->setEdits(edits_)) crossed_.clear();
  if (coarse_) coarse_->forgetBlocked(*query_);
  std::erase_if(crossed_, [&](const auto& each) {
    return firstRefusedEdge(*query_, each.second.points, host.parameters(), host.stopToken()).has_value();
  });
  if (phase_ != Phase::Prepare) phase_ = Phase::Coarse;
  local_.reset();
}

void MultiLayerPlanner::planCoarsely() {
  auto next = coarse_->plan(learnt_);
  if (!next) {
    failure_ = next.error();
    return;
  }
  next->attempt = plan_.attempt + 1;
  next->coarseConfigurations = plan_.coarseConfigurations;
  next->fineConfigurations = plan_.fineConfigurations;
  plan_ = std::move(*next);
  at_ = 0;
  local_.reset();
  milestoneSampler_.reset();
  milestoneDraws_ = 0;
  if (!plan_.nodes.empty()) {
    phase_ = Phase::Milestones;
  } else if (coarse_->rules().loop) {
    phase_ = Phase::LastResort;
    turn_ = 0;
  } else {
    fail(noWay(plan_), GLISSADE_TEXT("Check the semantic attributes of the places, or use strategy G."));
  }
  publish();
}

/// One step of drawing milestones: takes the known milestone, or draws one random configuration in the border.
void MultiLayerPlanner::drawMilestone(PlannerHost& host) {
  TopologicalStep& step = current();
  const TopologicalStep* next = at_ + 1 < plan_.steps.size() ? &plan_.steps[at_ + 1] : nullptr;
  std::optional<Pose> milestone = milestoneSampler_ ? std::nullopt : coarse_->knownMilestone(step, next, *query_);
  if (!milestone) {
    if (!milestoneSampler_) {
      milestoneSampler_.emplace(knowledge_->environment->map, step.border,
                                seedOf("milestones, attempt " + std::to_string(plan_.attempt)));
    }
    ++roadmap_.counts.randomConfigurations;
    ++roadmap_.counts.steps;
    ++plan_.coarseConfigurations;
    ++step.randomConfigurations;
    ++milestoneDraws_;
    milestone = milestoneSampler_->draw(*query_, problem_.bounds);
  }
  if (milestone) {
    step.to = *milestone;
    step.milestone = true;
    if (step.border >= 0) coarse_->keep(step.border, *milestone);
    milestoneSampler_.reset();
    milestoneDraws_ = 0;
    if (++at_ < plan_.steps.size()) return;
    at_ = 0;
    phase_ = Phase::Fine;
    publish();
  } else if (milestoneDraws_ >= static_cast<std::uint64_t>(host.parameters()[ParameterId::BorderSamples])) {
    stepFailed(host, {GLISSADE_TEXT("no free milestone in border %1"), {step.borderName}});
  }
}

void MultiLayerPlanner::crossPlace(PlannerHost& host) {
  TopologicalStep& step = current();
  if (!local_) {
    step.from = at_ == 0 ? problem_.start : plan_.steps[at_ - 1].to;
    const auto known = crossed_.find({step.place, borderBefore(), step.border});
    if (known != crossed_.end()) {
      show(known->second.choice);
      step.why = {GLISSADE_TEXT("%1; crossed before"), {step.why}};
      step.points = known->second.points;
      stepSolved();
      return;
    }
    choice_ = chooseFor(step, *knowledge_, coarse_->semantics(), coarse_->rules());
    startLocalPlanner(host);
    return;
  }
  const std::uint64_t before = local_->randomConfigurations();
  const SubPlanner::State state = local_->step(host, roadmap_);
  local_->complete(roadmap_);
  authority_ = authorityOf(local_->planner());
  const std::uint64_t spent = local_->randomConfigurations() - before;
  step.randomConfigurations += spent;
  plan_.fineConfigurations += spent;
  if (state == SubPlanner::State::Solved) {
    step.points = local_->planner().path()->points;
    crossed_[{step.place, borderBefore(), step.border}] = {choice_, step.points};
    stepSolved();
  } else if (state == SubPlanner::State::Failed) {
    if (local_->planner().failure() && choice_.local != coarse_->rules().fine.front().local) {
      choice_ = fallbackFor(coarse_->rules(), choice_);
      startLocalPlanner(host);
    } else {
      stepFailed(host, {GLISSADE_TEXT("no way through place %1"), {step.placeName}});
    }
  } else if (spent > 0 && step.randomConfigurations % kPublishEvery == 0) {
    publish();
  }
}

void MultiLayerPlanner::show(const FineChoice& choice) {
  TopologicalStep& step = current();
  step.planner = choice.local;
  step.geometrical = choice.geometrical;
  step.why = choice.why;
}

void MultiLayerPlanner::startLocalPlanner(PlannerHost& host) {
  TopologicalStep& step = current();
  show(choice_);
  step.result = StepResult::Running;
  step.region = areaOf(*knowledge_, step.place, borderBefore(), step.border, choice_.geometrical, step.from, step.to,
                       problem_.world->objectRadius(), host.stopToken());
  Problem part = problem_;
  part.start = step.from;
  part.goal = step.to;
  part.region = step.region;
  const std::string use = "step " + std::to_string(at_) + ", attempt " + std::to_string(plan_.attempt);
  const PlannerEntry* entry = locals_.find(choice_.local);
  local_ = std::make_unique<SubPlanner>(entry->make(part, seedOf(use)), stepBudget(host.parameters()), step.region);
  publish();
}

void MultiLayerPlanner::stepSolved() {
  current().result = StepResult::Solved;
  local_.reset();
  if (++at_ == plan_.steps.size()) phase_ = Phase::Deliver;
  publish();
}

/// With the loop, raises the cost of the failed step and tries the next best coarse path.
void MultiLayerPlanner::stepFailed(PlannerHost& host, const Message& reason) {
  TopologicalStep& step = current();
  step.result = StepResult::Failed;
  step.why = step.why.empty() ? reason : joined({step.why, reason}, "; ");
  publish();
  local_.reset();
  milestoneSampler_.reset();
  milestoneDraws_ = 0;
  if (!coarse_->rules().loop) {
    fail(reason, GLISSADE_TEXT("Relax its attributes, or use Layers (gts)."));
    return;
  }
  // The milestones are drawn anew, because they may be the reason for the failure.
  coarse_->forget(step.border);
  coarse_->forget(borderBefore());
  for (auto crossing = crossed_.begin(); crossing != crossed_.end();) {
    const auto& [place, from, to] = crossing->first;
    const bool stale = (from >= 0 && !coarse_->keeps(from)) || (to >= 0 && !coarse_->keeps(to));
    crossing = stale ? crossed_.erase(crossing) : std::next(crossing);
  }
  double& raised = learnt_.crossing[{step.place, step.border}];
  raised += std::max(raised, 0.5 * knowledge_->environment->map.grid.frame.side);
  turn_ = std::max<std::uint64_t>(kShortestTurn, roadmap_.counts.randomConfigurations);
  if (plan_.attempt >= static_cast<std::uint64_t>(host.parameters()[ParameterId::CoarsePaths])) turn_ = 0;
  phase_ = Phase::LastResort;
}

/// The row of the search of the whole workspace, after the steps that it replaces.
TopologicalStep& MultiLayerPlanner::wholeWorkspaceStep() {
  if (!plan_.steps.empty() && plan_.steps.back().place == TopologicalStep::kWholeWorkspace) return plan_.steps.back();
  TopologicalStep step;
  step.place = TopologicalStep::kWholeWorkspace;
  step.placeName = "the whole workspace";
  step.borderName = "G";
  step.from = problem_.start;
  step.to = *goal_;
  step.planner = kWholePlanner;
  step.why = GLISSADE_TEXT("searched from start to goal after the coarse paths");
  step.result = StepResult::Running;
  step.randomConfigurations = whole_->randomConfigurations();
  plan_.steps.push_back(std::move(step));
  publish();
  return plan_.steps.back();
}

/// The search of the whole workspace: in turn with the loop, or alone if turn_ is 0.
void MultiLayerPlanner::searchWorkspace(PlannerHost& host) {
  if (!whole_) {
    Problem whole = problem_;
    whole.region.reset();
    whole_ = std::make_unique<SubPlanner>(locals_.find(kWholePlanner)->make(whole, seedOf("whole workspace")),
                                          std::numeric_limits<std::uint64_t>::max(), nullptr);
  }
  TopologicalStep& step = wholeWorkspaceStep();
  const std::uint64_t before = whole_->randomConfigurations();
  const SubPlanner::State state = whole_->step(host, roadmap_);
  whole_->complete(roadmap_);
  authority_ = authorityOf(whole_->planner());
  const std::uint64_t spent = whole_->randomConfigurations() - before;
  step.randomConfigurations += spent;
  plan_.fineConfigurations += spent;
  if (state == SubPlanner::State::Solved) {
    path_ = *whole_->planner().path();
    for (TopologicalStep& other : plan_.steps) other.points.clear();  // they are not part of the path
    step.points = path_->points;
    step.result = StepResult::Solved;
    publish();
  } else if (!plan_.forbidden.empty() && isSpent(*whole_, host.parameters())) {
    fail(noWay(plan_), GLISSADE_TEXT("Allow one of these places again, or raise the samples a step."));
  } else if (turn_ > 0) {
    turn_ -= std::min(turn_, std::max<std::uint64_t>(spent, 1));
    if (turn_ == 0) phase_ = Phase::Coarse;
  }
}

void MultiLayerPlanner::deliver(PlannerHost& host) {
  Path path;
  for (const TopologicalStep& step : plan_.steps) {
    const bool first = path.points.empty();
    path.points.insert(path.points.end(), step.points.begin() + (first ? 0 : 1), step.points.end());
  }
  path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status == CertificateStatus::Certified) {
    path_ = std::move(path);
  } else if (!host.stopToken().stopRequested()) {
    fail(GLISSADE_TEXT("the steps together cannot be certified"),
         GLISSADE_TEXT("Please report it with the scenario and the seed."));
  }
  publish();
}

std::uint64_t MultiLayerPlanner::stepBudget(const ParameterValues& parameters) const {
  const auto limit = static_cast<std::uint64_t>(parameters[ParameterId::StepSamples]);
  if (!coarse_->rules().loop) return limit;
  const std::uint64_t pair = std::min((plan_.attempt - 1) / 2, kCautiousPairs);
  return std::max<std::uint64_t>(1, limit >> (2 * (kCautiousPairs - pair)));
}

std::uint64_t MultiLayerPlanner::seedOf(const std::string& use) const { return RandomStream(seed_, use).bits(); }

void MultiLayerPlanner::fail(const Message& reason, const Message& advice) {
  failure_ = Diagnostic{ErrorKind::NoPath, "", "", reason, advice};
}

void MultiLayerPlanner::publish() { published_ = std::make_shared<const CoarsePlan>(plan_); }

}  // namespace glissade
