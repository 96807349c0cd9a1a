#include "engine/planning/ompl/ompl_planner.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <ompl/util/String.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "engine/base/guarded.h"
#include "engine/base/tolerances.h"
#include "engine/collision/thread_rule.h"
#include "engine/planning/goal_roots.h"
#include "engine/planning/ompl/ompl_prm.h"
#include "engine/planning/ompl/ompl_space.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Longest edge of the planners that have one, relative to the diagonal of the bounds. BKPIECE's trees only meet within
/// a cell: with short edges it needs many times the draws (measured on the window of the tests and on environment 1).
/// EST counts neighbours within a third of its range, to grow where there are few: with short edges no node has any,
/// and its tree does not leave the surroundings of the start (measured on the teaching scenario; OMPL's own choice, 0.2
/// of the extent, is too short as well).
constexpr double kRange = 0.03;
constexpr double kBkpieceRange = 0.06;
constexpr double kEstRange = 0.5;
/// Number of draws after which nodes are collected first. They are collected again whenever the draws have doubled,
/// because collecting takes time proportional to the nodes.
constexpr std::uint64_t kCollectFirst = 64;
/// Draws of a piece with OmplManner::AsItIs. Large pieces keep the cost of our interface out of the comparison.
constexpr int kAsItIsPiece = 64;

bool growsTwoTrees(OmplAlgorithm algorithm) {
  return algorithm == OmplAlgorithm::RrtConnect || algorithm == OmplAlgorithm::Bkpiece ||
         algorithm == OmplAlgorithm::BiTrrt;
}

template <class OmplType>
ob::PlannerPtr withRange(const ob::SpaceInformationPtr& information, const Problem& problem, double range) {
  auto planner = std::make_shared<OmplType>(information);
  planner->setRange(range * problem.bounds.diagonal().norm());
  return planner;
}

ob::PlannerPtr makePlanner(OmplAlgorithm algorithm, const ob::SpaceInformationPtr& information,
                           const OmplWorld& world) {
  switch (algorithm) {
    case OmplAlgorithm::RrtConnect: return withRange<og::RRTConnect>(information, world.problem, kRange);
    case OmplAlgorithm::Bkpiece: return withRange<og::BKPIECE1>(information, world.problem, kBkpieceRange);
    case OmplAlgorithm::Prm: return std::make_shared<OmplPrm>(information, world);
    case OmplAlgorithm::Est: return withRange<og::EST>(information, world.problem, kEstRange);
    case OmplAlgorithm::Rrt: return withRange<og::RRT>(information, world.problem, kRange);
    case OmplAlgorithm::Trrt: return withRange<og::TRRT>(information, world.problem, kRange);
    case OmplAlgorithm::BiTrrt: return withRange<og::BiTRRT>(information, world.problem, kRange);
  }
  return nullptr;
}

/// Sets OMPL's range, which is OMPL's default where the parameter is 0.
void setUpAsItIs(ob::Planner& planner, const ParameterValues& parameters) {
  const auto& space = planner.getSpaceInformation()->getStateSpace();
  space->setLongestValidSegmentFraction(parameters[ParameterId::OmplResolution]);
  planner.getSpaceInformation()->setup();
  const double range = parameters[ParameterId::OmplRange] * space->getMaximumExtent();
  planner.params().setParam("range", ompl::toString(range));
  planner.setup();
}

}  // namespace

/// The OMPL objects. Destroyed in reverse order: the planner frees its states through the space.
struct OmplPlanner::Engine {
  Engine(const Problem& problem, std::uint64_t seed, OmplAlgorithm algorithm, OmplManner manner)
      : world(problem, seed), asItIs(manner == OmplManner::AsItIs), twoTrees(growsTwoTrees(algorithm)) {
    const bool whole = problem.world->variants().empty() && problem.world->threads().empty();
    if (asItIs && whole) world.surfaces.emplace(makeFclGeometry(problem.world->obstacles(), problem.world->object()));
    // PRM repeats its attempts itself, and checks its termination condition between them.
    constexpr unsigned kAttempts = 100;  // OMPL's default
    const std::lock_guard<std::recursive_mutex> lock(omplSeedMutex());
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed((RandomStream(seed, "ompl seed").bits() >> 33U) + 1);
    information = asItIs ? makePlainSpaceInformation(world)
                         : makeSpaceInformation(world, algorithm == OmplAlgorithm::Prm ? 1 : kAttempts);
    definition = std::make_shared<ob::ProblemDefinition>(information);
    const ob::ScopedState<> start = scoped(problem.start);
    definition->addStartState(start);
    auto goal = std::make_shared<ob::GoalStates>(information);
    for (const Pose& q : goalRoots(problem, *world.query)) {
      if (!world.isFree(q)) continue;
      goals.push_back(q);
      goal->addState(scoped(q));
    }
    goal->setThreshold(1e-9 * world.metric.radius());
    definition->setGoal(goal);
    planner = makePlanner(algorithm, information, world);
    planner->setProblemDefinition(definition);
    if (!asItIs) planner->setup();
  }

  /// Applies the parameters before the first piece.
  void begin(const ParameterValues& parameters) {
    if (asItIs && !planner->isSetup()) setUpAsItIs(*planner, parameters);
  }

  ob::ScopedState<> scoped(const Pose& q) const {
    ob::ScopedState<> state(information);
    OmplSpace::setPose(state.get(), q);
    return state;
  }

  /// Runs one draw, or one for each tree: OMPL's planners with two trees begin every call with the start's tree. Throws
  /// what the problem's source throws.
  ob::PlannerStatus solvePiece() {
    const int rounds = asItIs ? kAsItIsPiece : twoTrees ? 2 : 1;
    int done = 0;
    std::uint64_t seen = world.draws;
    const ob::PlannerTerminationCondition ptc([&] {
      if (world.ends()) return true;
      if (world.draws != seen) ++done;
      seen = world.draws;
      return done >= rounds;
    });
    const ob::PlannerStatus status = planner->solve(ptc);
    if (world.sourceError) std::rethrow_exception(world.sourceError);
    return status;
  }

  void restart() {
    definition->clearSolutionPaths();
    planner->clear();
    world.certifyEdges = true;
  }

  OmplWorld world;
  bool asItIs;
  bool twoTrees;
  std::vector<Pose> goals;
  std::unordered_map<std::uint64_t, std::uint32_t> nodeOf;  ///< node by the state's serial number
  std::unordered_set<std::uint64_t> known;                  ///< edges already listed
  ob::SpaceInformationPtr information;
  ob::ProblemDefinitionPtr definition;
  ob::PlannerPtr planner;
};

OmplPlanner::OmplPlanner(const Problem& problem, std::uint64_t seed, OmplAlgorithm algorithm, OmplManner manner) {
  nodes_.push_back({problem.start, Author::Computer, TreeSide::Start});
  counts_.nodes = 1;
  guard(GLISSADE_TEXT("preparing OMPL's planner"), [&] {
    engine_ = std::make_unique<Engine>(problem, seed, algorithm, manner);
    counts_.queries = engine_->world.queryCounts();
    if (engine_->goals.empty()) {
      fail(ErrorKind::NoPath, GLISSADE_TEXT("OMPL's planners need a free goal within the bounds, and there is none"),
           GLISSADE_TEXT("Widen the bounds, or give another goal."));
    }
  });
}

OmplPlanner::~OmplPlanner() = default;

/// Runs `work` and turns an exception of OMPL into a failure of this planner. Other members of a portfolio go on.
template <class Work>
void OmplPlanner::guard(CatalogueText doing, const Work& work) {
  auto why = guarded(doing, work);
  if (!why) return;
  why->advice = GLISSADE_TEXT("Choose another planner.");
  failure_ = std::move(why);
}

void OmplPlanner::fail(ErrorKind kind, const Message& reason, const Message& advice) {
  failure_ = Diagnostic{kind, "", "", reason, advice};
}

bool OmplPlanner::solve(PlannerHost& host) {
  while (owedSteps_ > 0 || (!path_ && !failure_)) {
    if (owedSteps_ == 0) guard(GLISSADE_TEXT("planning with OMPL"), [&] { grow(host); });
    if (owedSteps_ == 0) break;  // planning has failed
    // After a path is found, all steps of its piece are taken together, so that the end of the run does not depend on
    // where the piece is interrupted.
    const std::uint64_t taken = path_ ? owedSteps_ : 1;
    owedSteps_ -= taken;
    counts_.steps += taken;
    // A piece draws many configurations at once; each is counted with its step.
    counts_.randomConfigurations = engine_->world.draws - std::min(owedSteps_, engine_->world.draws);
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void OmplPlanner::completeRoadmap() {
  guard(GLISSADE_TEXT("reading OMPL's roadmap"), [this] {
    if (engine_) collect();
  });
}

void OmplPlanner::grow(PlannerHost& host) {
  OmplWorld& world = engine_->world;
  world.growthStep = host.parameters()[ParameterId::GrowthStep];
  world.extensionStep = host.parameters()[ParameterId::ExtensionStep];
  world.requiredClearance = host.parameters()[ParameterId::RequiredClearance];
  world.stop = host.stopToken();
  engine_->begin(host.parameters());
  const std::uint64_t before = world.draws;
  ++counts_.iterations;
  const ob::PlannerStatus status = engine_->solvePiece();
  if (status == ob::PlannerStatus::INVALID_START || status == ob::PlannerStatus::INVALID_GOAL) {
    fail(ErrorKind::NoPath, GLISSADE_TEXT("OMPL's planner was given no free start within the bounds"),
         GLISSADE_TEXT("Widen the bounds."));
  }
  if (engine_->definition->hasExactSolution()) deliverPath(host);
  engine_->definition->clearSolutionPaths();  // removes the approximate solution that every piece leaves
  owedSteps_ = std::max<std::uint64_t>(1, world.draws - before);
  counts_.queries = world.queryCounts();
  if (world.draws >= nextCollection_ || path_) {
    collect();
    nextCollection_ = std::max(kCollectFirst, 2 * world.draws);
  }
}

void OmplPlanner::deliverPath(PlannerHost& host) {
  const OmplWorld& world = engine_->world;
  const auto solution = std::static_pointer_cast<og::PathGeometric>(engine_->definition->getSolutionPath());
  Path path;
  for (const ob::State* state : solution->getStates())
    path.points.push_back({OmplSpace::poseOf(state), Author::Computer});
  // OMPL copies both ends, but the end may differ from the goal within its threshold.
  const auto nearest = std::min_element(engine_->goals.begin(), engine_->goals.end(),
                                        [&, end = path.points.back().q](const Pose& a, const Pose& b) {
                                          return world.metric.distance(a, end) < world.metric.distance(b, end);
                                        });
  path.points.front().q = world.problem.start;
  path.points.back().q = *nearest;
  path.certificate = certifyPath(*world.query, path.points, host.parameters(), host.stopToken());
  if (path.certificate.status == CertificateStatus::Certified) {
    path_ = std::move(path);
  } else if (!host.stopToken().stopRequested()) {
    collect();
    ++counts_.rejectedPaths;
    if (engine_->asItIs) {
      fail(ErrorKind::NoPath, GLISSADE_TEXT("OMPL's path is not certified: it touches or passes through an obstacle"),
           {GLISSADE_TEXT("Lower %1, or plan with 'auto'."), {specOf(ParameterId::OmplResolution).option}});
    } else {
      engine_->restart();
    }
  }
}

void OmplPlanner::collect() {
  if (collectedAt_ == counts_.iterations && !path_) return;
  collectedAt_ = counts_.iterations;
  ob::PlannerData data(engine_->information);
  engine_->planner->getPlannerData(data);
  struct Fresh {
    std::uint64_t serial;
    const ob::PlannerDataVertex* vertex;
  };
  std::vector<Fresh> fresh;
  const auto serial = [&](unsigned vertex) { return OmplSpace::serialOf(data.getVertex(vertex).getState()); };
  for (unsigned vertex = 0; vertex < data.numVertices(); ++vertex) {
    if (engine_->nodeOf.count(serial(vertex)) > 0) continue;
    if (data.isStartVertex(vertex)) {
      engine_->nodeOf[serial(vertex)] = 0;
    } else {
      fresh.push_back({serial(vertex), &data.getVertex(vertex)});
    }
  }
  std::sort(fresh.begin(), fresh.end(), [](const Fresh& a, const Fresh& b) { return a.serial < b.serial; });
  for (const Fresh& node : fresh) {
    constexpr int kGoalTag = 2;  // tag in OMPL's planners with two trees
    const bool goalTree = engine_->twoTrees && node.vertex->getTag() == kGoalTag;
    engine_->nodeOf[node.serial] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(
        {OmplSpace::poseOf(node.vertex->getState()), Author::Computer, goalTree ? TreeSide::Goal : TreeSide::Start});
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;  // pairs with the later node first
  std::vector<unsigned> neighbours;
  for (unsigned vertex = 0; vertex < data.numVertices(); ++vertex) {
    const std::uint32_t from = engine_->nodeOf.at(serial(vertex));
    data.getEdges(vertex, neighbours);
    for (const unsigned neighbour : neighbours) {
      const std::uint32_t to = engine_->nodeOf.at(serial(neighbour));
      const std::uint64_t key = (std::uint64_t{std::max(from, to)} << 32U) | std::min(from, to);
      if (from != to && engine_->known.insert(key).second) links.emplace_back(std::max(from, to), std::min(from, to));
    }
  }
  std::sort(links.begin(), links.end());
  for (const auto& [later, earlier] : links) edges_.push_back({earlier, later});
  counts_.nodes = nodes_.size();
  counts_.edges = 2 * edges_.size();
}

}  // namespace glissade
