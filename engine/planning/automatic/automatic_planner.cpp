#include "engine/planning/automatic/automatic_planner.h"

#include <algorithm>
#include <limits>

#include "engine/planning/goal_roots.h"

namespace glissade {
namespace {

/// The work of members, in quarters of a yes/no query. An iteration searches neighbours. A draw that is discarded at
/// once costs almost nothing, so steps do not count, except one for each turn.
constexpr std::uint64_t kCollisionWork = 4;
constexpr std::uint64_t kDistanceWork = 16;
constexpr std::uint64_t kMotionWork = 80;
constexpr std::uint64_t kIterationWork = 8;
constexpr std::uint64_t kTurnWork = 1;

std::uint64_t workOf(const PlannerCounts& counts) {
  return kCollisionWork * counts.queries.collision + kDistanceWork * counts.queries.distance +
         kMotionWork * counts.queries.motion + kIterationWork * counts.iterations;
}

std::vector<Contender> contendersOf(const std::vector<Member>& members) {
  std::vector<Contender> contenders;
  contenders.reserve(members.size());
  for (const Member& member : members) contenders.push_back(member.contender);
  return contenders;
}

/// Work of a slot in a round. It takes some milliseconds, so that waiting for the slowest slot costs little and
/// commands and snapshots come often enough. The quantum begins lower and doubles with each round, so that an easy
/// problem ends early.
constexpr std::uint64_t kQuantum = 10'000;
constexpr std::uint64_t kFirstQuantum = 300;
/// The name of the partner's own planner beside those of the members.
constexpr const char* kPartner = "hand";

}  // namespace

SlotResult runSlot(SubPlanner& life, PlannerHost& host, std::uint64_t quantum) {
  SlotResult result;
  const std::uint64_t before = workOf(life.collected());  // a new life pays for its making, too
  const std::size_t stagesBefore = stagesDoneOf(life.planner());
  do {
    result.state = life.advance(host);
    ++result.turns;
    result.work = workOf(life.planner().counts()) - before + kTurnWork * result.turns;
  } while (result.state == SubPlanner::State::Running && result.work < quantum && !host.stopToken().stopRequested());
  result.madeProgress = stagesDoneOf(life.planner()) > stagesBefore;
  return result;
}

AutomaticPlanner::AutomaticPlanner(const Problem& problem, std::uint64_t seed, std::size_t mostThreads,
                                   std::unique_ptr<PortfolioPartner> partner)
    : seed_(seed),
      mostThreads_(std::max<std::size_t>(1, mostThreads)),
      metric_(problem.metric()),
      partner_(std::move(partner)),
      members_(membersOf(problem)),
      portfolio_(contendersOf(members_)),
      lives_(members_.size()),
      livesBegun_(members_.size(), 0),
      quantum_(kFirstQuantum) {
  roadmap_.nodes.push_back({problem.start, Author::Computer, TreeSide::Start});
  updateCounts();
  const auto query = problem.world->makeQuery();
  if (goalRoots(problem, *query).empty()) {
    failure_ =
        Diagnostic{ErrorKind::NoPath, "", "", GLISSADE_TEXT("the workspace has no configuration outside the product"),
                   GLISSADE_TEXT("Widen the workspace.")};
  }
}

AutomaticPlanner::~AutomaticPlanner() = default;

std::vector<Member> AutomaticPlanner::membersOf(const Problem& problem) const {
  if (!partner_) return makeMembers(problem);
  return makeMembers(problem, partner_->worlds(),
                     [partner = partner_.get()](auto own, std::uint64_t seed, bool slides) {
                       return partner->sampler(std::move(own), seed, slides);
                     });
}

std::string AutomaticPlanner::member() const {
  if (path_) return solver_;
  std::string names;
  for (const Part& part : parts_) {
    if (part.index == 0) names += (names.empty() ? "" : ", ") + members_[part.member].name;
  }
  return names;
}

bool AutomaticPlanner::solve(PlannerHost& host) {
  while (owedTurns_ > 0 || (!path_ && !failure_)) {
    if (owedTurns_ == 0) round(host);
    --owedTurns_;
    updateCounts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void AutomaticPlanner::round(PlannerHost& host) {
  if (partner_ && partner_->takesTurn(host)) {
    runPartner(host);
    return;
  }
  const auto slots = static_cast<std::size_t>(host.parameters().integer(ParameterId::Slots));
  const std::uint64_t quantum = partner_ ? std::min(quantum_, partner_->mostWork()) : quantum_;
  const std::size_t edgesBefore = roadmap_.edges.size();
  assignSlots(slots, quantum);
  runParts(host, slots, quantum);
  for (const Part& part : parts_) {
    Life& life = lifeOf(part);
    life.planner->collect(roadmap_);
    life.work += part.result.work;
    portfolio_.charge(part.member, part.result.work);
    owedTurns_ += part.result.turns;
  }
  deliver();
  for (const Part& part : parts_) settle(part);
  if (partner_) reportToPartner(quantum, edgesBefore);
  quantum_ = std::min(2 * quantum_, kQuantum);
}

void AutomaticPlanner::runPartner(PlannerHost& host) {
  SubPlanner& planner = partner_->planner();
  const SlotResult result = runSlot(planner, host, 0);
  planner.collect(roadmap_);
  owedTurns_ += result.turns;
  partner_->turnDone(result.work);
  if (result.state != SubPlanner::State::Solved) return;
  path_ = *planner.planner().path();
  partner_->solved(*path_, true);
  solver_ = kPartner;
}

void AutomaticPlanner::reportToPartner(std::uint64_t quantum, std::size_t edgesBefore) {
  RoundOutcome outcome;
  outcome.quantum = quantum;
  for (const Part& part : parts_) {
    outcome.turns += part.result.turns;
    outcome.work += part.result.work;
  }
  for (std::size_t i = edgesBefore; i < roadmap_.edges.size(); ++i) {
    const RoadmapEdge& edge = roadmap_.edges[i];
    outcome.reach = std::max(outcome.reach, metric_.distance(roadmap_.nodes[edge.from].q, roadmap_.nodes[edge.to].q));
  }
  partner_->roundDone(outcome);
  const auto solver =
      std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return m.name == solver_; });
  if (path_) partner_->solved(*path_, solver != members_.end() && solver->shares);
}

/// The lives of a member are sorted by completed stages, most first.
void AutomaticPlanner::assignSlots(std::size_t slots, std::uint64_t quantum) {
  const auto stages = [](const Life& life) { return life.planner ? stagesDoneOf(life.planner->planner()) : 0; };
  for (std::vector<Life>& lives : lives_) {
    if (lives.size() < 2) continue;
    std::stable_sort(lives.begin(), lives.end(), [&](const Life& a, const Life& b) { return stages(a) > stages(b); });
  }
  std::vector<std::size_t> dealt(members_.size(), 0);
  parts_.clear();
  for (const std::size_t member : portfolio_.next(slots, quantum)) {
    const Part& part = parts_.emplace_back(Part{member, dealt[member]++, {}});
    if (part.index == lives_[member].size()) lives_[member].emplace_back();
    Life& life = lifeOf(part);
    if (life.number == 0) life.number = ++livesBegun_[member];
  }
}

/// With a single slot every turn has one step.
void AutomaticPlanner::runParts(PlannerHost& host, std::size_t slots, std::uint64_t quantum) {
  if (slots == 1) {
    work(parts_.front(), host, 0);
    return;
  }
  if (!team_) team_ = std::make_unique<ThreadTeam>(std::min(slots, mostThreads_) - 1);
  RoundHost roundHost(host);
  team_->run(parts_.size(), [&](std::size_t i) { work(parts_[i], roundHost, quantum); });
}

void AutomaticPlanner::work(Part& part, PlannerHost& host, std::uint64_t quantum) {
  Life& life = lifeOf(part);
  if (!life.planner) {
    auto planner = members_[part.member].make(seedOf(part.member, life.number), life.number);
    life.planner = std::make_unique<SubPlanner>(std::move(planner), std::numeric_limits<std::uint64_t>::max(), nullptr);
  }
  part.result = runSlot(*life.planner, host, quantum);
}

/// Delivers the path that took the least work in this round, the first among equals.
void AutomaticPlanner::deliver() {
  const Part* best = nullptr;
  for (const Part& part : parts_) {
    const bool solved = part.result.state == SubPlanner::State::Solved;
    if (solved && (best == nullptr || part.result.work < best->result.work)) best = &part;
  }
  if (best == nullptr) return;
  path_ = *lifeOf(*best).planner->planner().path();
  solver_ = members_[best->member].name;
}

/// Ends the lives that are over, which makes room for new ones.
void AutomaticPlanner::settle(const Part& part) {
  Life& life = lifeOf(part);
  const Contender& contender = members_[part.member].contender;
  const SubPlanner::State state = part.result.state;
  if (part.result.madeProgress) portfolio_.reward(part.member);
  if (state == SubPlanner::State::Solved) return;
  const bool failed = state == SubPlanner::State::Failed;
  if (!failed && life.work < lifeLength(contender, life.number)) return;
  if (failed && contender.restart == Restart::Never) {
    portfolio_.retire(part.member);
    if (!path_ && portfolio_.next() == Portfolio::kNobody) failure_ = life.planner->planner().failure();
  }
  life.planner->complete(roadmap_);
  life = {};
}

void AutomaticPlanner::completeRoadmap() {
  for (std::vector<Life>& lives : lives_) {
    for (Life& life : lives) {
      if (life.planner) life.planner->complete(roadmap_);
    }
  }
  updateCounts();
}

void AutomaticPlanner::updateCounts() {
  counts_ = roadmap_.counts;
  counts_.steps -= std::min(owedTurns_, counts_.steps);
  counts_.nodes = roadmap_.nodes.size();
  counts_.droppedEdges = roadmap_.droppedEdges.size();
  counts_.edges = 2 * (roadmap_.edges.size() - roadmap_.droppedEdges.size());
}

std::uint64_t AutomaticPlanner::seedOf(std::size_t member, std::uint64_t life) const {
  return RandomStream(seed_, members_[member].name + " life " + std::to_string(life)).bits();
}

}  // namespace glissade
