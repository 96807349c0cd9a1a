#include "engine/session/session_core.h"

#include <sstream>
#include <utility>

#include "engine/base/cpu_time.h"
#include "engine/base/overloaded.h"
#include "engine/planning/automatic/portfolio_report.h"
#include "engine/planning/automatic/straight_end.h"
#include "engine/planning/coarse/coarse_plan_report.h"
#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/planning/contact/interaction_report.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/session/start_check.h"

namespace glissade {
namespace {

Diagnostic limit(const ParameterSpec& spec, const Message& reason) {
  return {ErrorKind::LimitReached,
          "",
          "",
          reason,
          {GLISSADE_TEXT("Raise the limit (%1), steer the object yourself, or try another seed."), {spec.option}}};
}

std::string grouped(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

/// Processor time of planning so far on this thread and on the planner's own threads.
double cpuSeconds(const Planner& planner) { return threadCpuSeconds() + helpersCpuSecondsOf(planner); }

bool isSamePlaces(const ForbiddenRegionsPtr& a, const ForbiddenRegionsPtr& b) {
  return a == b || (a && b && a->places() == b->places());
}

}  // namespace

void RoadmapPublisher::update(const Planner& planner) {
  const auto& nodes = planner.nodes();
  const auto& edges = planner.edges();
  if (nodes.size() > nodes_ || edges.size() > edges_) {
    auto chunk = std::make_shared<RoadmapChunk>();
    chunk->nodes.assign(nodes.begin() + static_cast<std::ptrdiff_t>(nodes_), nodes.end());
    chunk->edges.assign(edges.begin() + static_cast<std::ptrdiff_t>(edges_), edges.end());
    chunks_.push_back(chunk);  // may throw: the counters change afterwards
    for (const RoadmapNode& node : chunk->nodes) ++nodesByAuthor_[static_cast<std::size_t>(node.author)];
    nodes_ = nodes.size();
    edges_ = edges.size();
  }
  for (std::size_t i = dropped_.size(); i < planner.droppedEdges().size(); ++i) {
    dropped_.push_back(edges[planner.droppedEdges()[i]]);
  }
}

void RoadmapPublisher::reset() { *this = RoadmapPublisher(); }

CatalogueText workOf(const Command& command) {
  if (std::holds_alternative<command::Start>(command)) return GLISSADE_TEXT("starting the planner");
  if (std::holds_alternative<command::SmoothPath>(command)) return GLISSADE_TEXT("smoothing the path");
  if (std::holds_alternative<command::ExaminePath>(command)) return GLISSADE_TEXT("examining the path");
  if (std::holds_alternative<command::Stop>(command)) return GLISSADE_TEXT("stopping the planner");
  return GLISSADE_TEXT("changing the settings of the run");
}

/// The planner's view of the session.
class SessionCore::Host final : public PlannerHost {
 public:
  Host(SessionCore& core, const Hooks& hooks) : core_(core), hooks_(hooks), stop_(core.withTimeLimit(hooks.stop)) {
    core_.logger_.noteHand(hooks_.hand());
  }

  std::optional<OperatorSample> operatorSample() override {
    if (!core_.logger_.held()) return std::nullopt;
    OperatorSample sample = hooks_.operatorSample();
    sample.moves = core_.logger_.handMoves();  // numbered as in a replay
    return sample;
  }
  const ParameterValues& parameters() const override { return core_.parameters_; }
  bool afterStep() override {
    core_.logger_.stepDone(*core_.planner_, hooks_.seconds(), !stop_.stopRequested());
    if (auto reached = core_.limitReached(); reached && core_.planner_->path() == nullptr) {
      core_.fail(*std::move(reached));
      return false;
    }
    if (!hooks_.afterStep()) return false;
    const bool over = core_.planner_->path() != nullptr || core_.planner_->failure();
    if (!over) core_.logger_.noteHand(hooks_.hand());
    return true;
  }
  const StopToken& stopToken() const override { return stop_; }
  SemanticEditsPtr semanticEdits() const override { return core_.problem_.scene.edits; }

 private:
  SessionCore& core_;
  const Hooks& hooks_;
  StopToken stop_;
};

SessionCore::SessionCore(SessionConfig config, PlannerRegistry planners)
    : problem_(std::move(config.problem)),
      registry_(std::move(planners)),
      parameters_(config.parameters),
      plannerId_(std::move(config.plannerId)),
      seed_(config.seed) {
  problem_.world = problem_.world->withForbidden(forbidden_);
}

SessionCore::~SessionCore() = default;

/// Ends a run after an exception. The planner may be left in the middle of a step; its nodes are collected as far as
/// possible.
void SessionCore::endAfterException(Diagnostic why) {
  trouble_ = std::move(why);
  stopClock();
  if (state_ != SessionState::Planning && state_ != SessionState::Paused) return;
  state_ = path_ ? SessionState::Solved : SessionState::Failed;
  const auto second = guarded(GLISSADE_TEXT("completing the roadmap"), [this] {
    trouble_->location = {GLISSADE_TEXT("%1, seed %2"), {plannerId_, seed_}};
    if (planner_) planner_->completeRoadmap();
  });
  if (second) setPlannerAside();
}

void SessionCore::setPlannerAside() {
  if (planner_) plannerAside_ = std::move(planner_);
}

void SessionCore::carryOut(const Command& command, const WorkWatch& watch) {
  const bool running = state_ == SessionState::Planning || state_ == SessionState::Paused;
  const auto replaceState = [this](SessionState from, SessionState to) {
    if (state_ == from) state_ = to;
  };
  std::visit(Overloaded{[&](const command::Start&) {
                          if (!running) startRun(watch.stop);
                        },
                        [&](const command::Pause&) { replaceState(SessionState::Planning, SessionState::Paused); },
                        [&](const command::Resume&) { replaceState(SessionState::Paused, SessionState::Planning); },
                        [&](const command::Stop&) {
                          if (running) endRun(SessionState::Stopped);
                        },
                        [&](const command::SetSeed& seed) { seed_ = seed.seed; },
                        [&](const command::SetPlanner& planner) { setPlanner(planner.id); },
                        [&](const command::SetParameter& parameter) { setParameter(parameter.id, parameter.value); },
                        [&](const command::SetSemantics& semantics) { setSemantics(semantics.edits, watch); },
                        [&](const command::SetKnowledge& known) { problem_.scene.knowledge = known.knowledge; },
                        [&](const command::SetNames& named) { setNames(named.world); },
                        [](const command::SetDevicePose&) {},  // handled by the session's hand
                        [&](const command::SmoothPath& smooth) {
                          if (state_ != SessionState::Solved) return;
                          trouble_.reset();
                          smoothPath(smooth.attempts, watch);
                        },
                        [&](const command::ExaminePath& given) {
                          if (run_ == 0) examine(given, watch);
                        }},
             command);
}

void SessionCore::setPlanner(const std::string& id) {
  if (registry_.find(id) != nullptr) {
    plannerId_ = id;
    return;
  }
  std::string known;
  for (const PlannerEntry& entry : registry_.entries()) known += (known.empty() ? "" : ", ") + entry.id;
  trouble_ = unknownPlanner(id, {GLISSADE_TEXT("Choose one of %1."), {known}});
}

void SessionCore::setParameter(ParameterId id, double value) {
  const Outcome outcome = parameters_.set(id, value);
  if (!outcome) {
    trouble_ = outcome.error();
    return;
  }
  if (state_ == SessionState::Planning || state_ == SessionState::Paused) logger_.note(id, value);
  const int tuned = parameters_.integer(ParameterId::Tuning);
  const int left = tuned & ~tunedSetting(id);
  if (left != tuned) setParameter(ParameterId::Tuning, left);  // the user has set the parameter
}

/// The reason of a run that failed may have the earlier names.
void SessionCore::setNames(const CollisionWorldPtr& world) {
  problem_.world = world->withForbidden(forbidden_);
  forgetFailure();
}

void SessionCore::forgetFailure() {
  if (state_ != SessionState::Failed) return;
  trouble_.reset();
  state_ = SessionState::Idle;
}

/// Sets the edits. The reason of a run that failed was about other edits. A path that leads through a place that is
/// forbidden now does not hold any more, and a refused path is examined again, because a place may be allowed now.
void SessionCore::setSemantics(const SemanticEditsPtr& edits, const WorkWatch& watch) {
  problem_.scene.edits = edits;
  const bool running = state_ == SessionState::Planning || state_ == SessionState::Paused;
  if (running) logger_.note(edits);
  forgetFailure();
  if (!running && !path_ && !refused_) return;  // the forbidden places are computed at the start
  const ForbiddenRegionsPtr before = forbidden_->regions();
  const Outcome known = forbidByEdits(watch.stop);
  if (!known && running) {
    fail(known.error());
  } else if (!known) {
    trouble_ = known.error();
  } else if (isSamePlaces(before, forbidden_->regions())) {
    return;
  } else if (path_) {
    certifyAgain(watch);
  } else if (refused_) {
    judge({refused_->path.points, provenance_}, watch);
  }
}

/// Updates the forbidden places by the edits.
Outcome SessionCore::forbidByEdits(const StopToken& stop) {
  auto regions = prohibitions_.of(problem_, stop);
  if (!regions) return regions.error();
  forbidden_->set(std::move(*regions));
  return Done{};
}

std::optional<std::string> SessionCore::forbiddenOn(const Path& path) const {
  const ForbiddenRegionsPtr regions = forbidden_->regions();
  return regions ? firstForbidden(path.configurations(), *regions) : std::nullopt;
}

/// Certifies the path among the present forbidden places, which its certificate states; a path that leads through one
/// is withdrawn.
void SessionCore::certifyAgain(const WorkWatch& watch) {
  PathExamination examination = examinePath(path_->points, problem_, parameters_, watch);
  if (!examination.complete) return;
  if (examination.holds()) {
    path_ = std::make_shared<const Path>(std::move(examination.path));
    return;
  }
  refused_ = std::make_shared<const PathExamination>(std::move(examination));
  path_ = planned_ = nullptr;
  smoothed_ = false;
  if (state_ == SessionState::Solved) state_ = SessionState::Idle;
}

void SessionCore::startRun(const StopToken& stop) {
  ++run_;
  state_ = SessionState::Planning;
  trouble_.reset();
  path_.reset();
  refused_.reset();
  provenance_ = {plannerId_, seed_};
  planner_.reset();
  plannerAside_.reset();
  roadmap_.reset();
  const SceneDescription& scene = problem_.scene;
  logger_.start({plannerId_, seed_, parameters_, scene.edits,
                 scene.knowledge ? std::make_optional(scene.knowledge->source) : std::nullopt});
  spent_ = std::chrono::duration<double>(0);
  cpuSpent_ = 0.0;
  if (const Outcome known = forbidByEdits(stop); !known) {
    fail(known.error());
    return;
  }
  const Outcome startable = checkStart(problem_, parameters_[ParameterId::RequiredClearance]);
  if (!startable) {
    fail(startable.error());
    return;
  }
  const PlannerEntry* entry = registry_.find(plannerId_);
  if (entry == nullptr) {
    setPlanner(plannerId_);
    state_ = SessionState::Failed;
    return;
  }
  const Outcome milestones = entry->multiLayer ? checkMilestones(problem_) : Outcome(Done{});
  if (!milestones) {
    fail(milestones.error());
    return;
  }
  planner_ = entry->make(problem_, seed_);
}

void SessionCore::plan(const Hooks& hooks) {
  // The clock starts before the host sets its deadline, so that the limit is reached at the deadline.
  planningSince_ = std::chrono::steady_clock::now();
  Host host(*this, hooks);
  cpuBefore_ = cpuSeconds(*planner_);
  const bool solved = planner_->solve(host);
  const auto forbidden = solved ? forbiddenOn(*planner_->path()) : std::nullopt;
  if (forbidden) {
    fail({ErrorKind::NoPath,
          "",
          "",
          {GLISSADE_TEXT("the path that was found leads through '%1', which was forbidden meanwhile"), {*forbidden}},
          GLISSADE_TEXT("Start again.")});
  } else if (solved) {
    deliverPath(hooks.stop);
    endRun(SessionState::Solved);
  } else if (state_ == SessionState::Planning) {
    // The time limit may have interrupted a step, after which the host was not asked.
    const auto failure = planner_->failure();
    if (auto why = failure ? failure : limitReached()) fail(*std::move(why));
  }
  stopClock();
}

void SessionCore::stopClock() {
  if (!planningSince_) return;
  spent_ += std::chrono::steady_clock::now() - *planningSince_;
  cpuSpent_ = planningCpuSeconds();
  planningSince_.reset();
}

/// Delivers the path, smoothed; if smoothing fails, as it was planned. A path that a hand leads is delivered without
/// the detours of the computer.
void SessionCore::deliverPath(const StopToken& stop) {
  planned_ = std::make_shared<const Path>(*planner_->path());
  provenance_.steered = isSteered(planned_->points);
  auto why = guarded(GLISSADE_TEXT("smoothing the path"), [&] {
    const StopToken limited = withTimeLimit(stop);
    if (provenance_.steered && registry_.find(provenance_.planner)->handLeads) {
      planned_ = std::make_shared<const Path>(
          withShortcutsOfComputer(*planned_, problem_, parameters_, provenance_.seed, kUsualShortcuts, limited));
    }
    smoothPath(parameters_.integer(ParameterId::Smoothing), limited);
  });
  if (!why) return;
  trouble_ = std::move(why);
  path_ = planned_;
  smoothed_ = false;
}

void SessionCore::smoothPath(int attempts, const WorkWatch& watch) {
  Path path = *planned_;
  if (attempts > 0) {
    path = withStraightEnd(path, problem_, parameters_, watch.stop);
    path = withShortcuts(path, problem_, parameters_, seed_, attempts, watch);
  }
  const bool another = path_ != nullptr;  // after a stop the delivered path stays
  if (another && watch.stop.stopRequested()) return;
  path_ = std::make_shared<const Path>(std::move(path));
  smoothed_ = attempts > 0;
}

void SessionCore::examine(const command::ExaminePath& given, const WorkWatch& watch) {
  if (const Outcome known = forbidByEdits(watch.stop); !known) {
    trouble_ = known.error();
    return;
  }
  judge(given, watch);
}

/// Certifies a path among the present forbidden places, and shows it as found or as refused.
void SessionCore::judge(const command::ExaminePath& given, const WorkWatch& watch) {
  PathExamination examination = examinePath(given.points, problem_, parameters_, watch);
  if (!examination.complete) return;
  const bool holds = examination.holds();
  provenance_ = given.provenance;
  smoothed_ = false;
  planned_ = path_ = holds ? std::make_shared<const Path>(std::move(examination.path)) : nullptr;
  refused_ = holds ? nullptr : std::make_shared<const PathExamination>(std::move(examination));
  state_ = holds ? SessionState::Solved : SessionState::Idle;
}

void SessionCore::endRun(SessionState state) {
  state_ = state;
  if (planner_) planner_->completeRoadmap();
}

/// Ends the run without a path. Forbidden places may be the reason, so that they are named.
void SessionCore::fail(Diagnostic why) {
  const ForbiddenRegionsPtr regions = forbidden_->regions();
  const bool noPath = why.kind == ErrorKind::NoPath || why.kind == ErrorKind::LimitReached;
  if (regions && noPath && toString(why.reason).find("forbidden") == std::string::npos) {
    why.reason = {GLISSADE_TEXT("%1; forbidden: %2"), {why.reason, regions->names()}};
  }
  trouble_ = std::move(why);
  endRun(SessionState::Failed);
}

std::optional<Diagnostic> SessionCore::limitReached() const {
  const PlannerCounts& counts = planner_->counts();
  const auto reached = [&](ParameterId id, double spent) {
    const double most = parameters_[id];
    return most > 0.0 && spent >= most;
  };
  if (reached(ParameterId::MaxSteps, static_cast<double>(counts.steps))) {
    return limit(specOf(ParameterId::MaxSteps),
                 {GLISSADE_TEXT("the step limit of %1 was reached without a path"), {grouped(counts.steps)}});
  }
  if (reached(ParameterId::MaxSamples, static_cast<double>(counts.randomConfigurations))) {
    return limit(specOf(ParameterId::MaxSamples),
                 {GLISSADE_TEXT("the limit of %1 random configurations was reached without a path"),
                  {grouped(counts.randomConfigurations)}});
  }
  if (reached(ParameterId::TimeLimit, planningSeconds())) {
    std::ostringstream seconds;
    seconds << parameters_[ParameterId::TimeLimit];
    return limit(specOf(ParameterId::TimeLimit),
                 {GLISSADE_TEXT("the time limit of %1 s was reached without a path"), {seconds.str()}});
  }
  return std::nullopt;
}

/// A token that also stops long checks at the time limit.
StopToken SessionCore::withTimeLimit(const StopToken& stop) const {
  const double limit = parameters_[ParameterId::TimeLimit];
  if (limit <= 0.0) return stop;
  const std::chrono::duration<double> left(limit - planningSeconds());
  return stop.withDeadline(StopToken::Clock::now() + std::chrono::ceil<StopToken::Clock::duration>(left));
}

double SessionCore::planningSeconds() const {
  auto total = spent_;
  if (planningSince_) total += std::chrono::steady_clock::now() - *planningSince_;
  return total.count();
}

double SessionCore::planningCpuSeconds() const {
  return planningSince_ ? cpuSpent_ + cpuSeconds(*planner_) - cpuBefore_ : cpuSpent_;
}

void SessionCore::describe(SessionSnapshot& snapshot) {
  snapshot.run = run_;
  snapshot.state = state_;
  snapshot.problem = trouble_;
  snapshot.plannerId = plannerId_;
  snapshot.seed = seed_;
  snapshot.parameters = parameters_;
  snapshot.planningSeconds = planningSeconds();
  snapshot.planningCpuSeconds = planningCpuSeconds();
  snapshot.path = path_;
  snapshot.smoothed = path_ && smoothed_;
  snapshot.refused = refused_;
  snapshot.provenance = provenance_;
  if (planner_) {
    roadmap_.update(*planner_);
    snapshot.counts = planner_->counts();
    snapshot.authority = authorityOf(*planner_);
    snapshot.contactMode = contactModeOf(*planner_);
    snapshot.coarsePlan = coarsePlanOf(*planner_);
    snapshot.member = memberOf(*planner_);
    snapshot.tuning = tuningOf(*planner_);
    snapshot.hand = handReportOf(*planner_);
  }
  snapshot.roadmap = roadmap_.chunks();
  snapshot.nodesByAuthor = roadmap_.nodesByAuthor();
  snapshot.droppedEdges = roadmap_.droppedEdges();
  if (run_ > 0) snapshot.log = logger_.parts(!isRunning(snapshot));
}

}  // namespace glissade
