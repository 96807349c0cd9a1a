#include "engine/planning/automatic/member.h"

#include <iterator>

#include "engine/base/tolerances.h"
#include "engine/planning/automatic/assembly_sampler.h"
#include "engine/planning/automatic/direct_motions.h"
#include "engine/planning/automatic/modelled_threads.h"
#include "engine/planning/automatic/shrink_repair.h"
#include "engine/planning/fine/multi_layer_planner.h"
#include "engine/planning/ompl/ompl_planner.h"
#include "engine/planning/threaded_planner.h"

namespace glissade {
namespace {

/// Direct motions first, then two trees: what is left of a path after a screw motion is simple, mostly.
class DirectThenTrees final : public Planner {
 public:
  DirectThenTrees(const Problem& problem, std::uint64_t seed, const RrtConnect::Options& options)
      : direct_(problem), trees_(problem, seed, options, std::make_unique<UniformSampler>(problem, seed)) {}

  bool solve(PlannerHost& host) override {
    if (current_ == &direct_) {
      if (direct_.solve(host)) return true;
      if (!direct_.failure()) return false;
      current_ = &trees_;
      if (host.stopToken().stopRequested()) return false;
    }
    return trees_.solve(host);
  }
  void completeRoadmap() override { current_->completeRoadmap(); }

  const std::vector<RoadmapNode>& nodes() const override { return current_->nodes(); }
  const std::vector<RoadmapEdge>& edges() const override { return current_->edges(); }
  const std::vector<std::uint32_t>& droppedEdges() const override { return current_->droppedEdges(); }
  const PlannerCounts& counts() const override { return current_->counts(); }
  const Path* path() const override { return current_->path(); }
  std::optional<Diagnostic> failure() const override { return current_->failure(); }

 private:
  DirectMotions direct_;
  RrtConnect trees_;
  Planner* current_ = &direct_;
};

using Worlds = std::shared_ptr<ErodedWorlds>;

/// First lives and patience, in work as AutomaticPlanner counts it. They are a few times the work that a typical
/// problem of the member needs; shorter lives would restart it too early.
constexpr std::uint64_t kShortPatience = 500'000;
constexpr std::uint64_t kShortFirstLife = 1'000'000;
constexpr std::uint64_t kFirstLife = 2'500'000;
constexpr std::uint64_t kLongFirstLife = 10'000'000;
/// Work of the quick members before the other members enter.
constexpr std::uint64_t kHardEntry = 600'000;
/// Work before the member with the environment model enters: a fixed part and a part for each triangle of the
/// obstacles. Building the model counts as no work, and its time grows with the triangles. The model is built after the
/// other members have used about as much time.
constexpr std::uint64_t kModelEntry = 7'000'000;
constexpr std::uint64_t kModelEntryPerTriangle = 20'000;

std::uint64_t obstacleTriangles(const Problem& problem) {
  std::uint64_t triangles = 0;
  for (const RigidBody& body : problem.world->obstacles()) triangles += body.mesh->triangles.size();
  return triangles;
}

/// Work that the two trees have before the other quick members. Among detailed parts the two trees are the quickest
/// member (for the pump, in both directions, in less than half the time). Among a few bars and walls they are not.
std::uint64_t headStart(const Problem& problem) {
  constexpr std::uint64_t kDetailed = 10'000;
  return obstacleTriangles(problem) < kDetailed ? 0 : kHardEntry;
}

Member directMotions(const Problem& problem) {
  return {"direct-motions",
          {1.0, 0, 0, Restart::Never, 0},
          [problem](std::uint64_t, std::uint64_t) -> std::unique_ptr<Planner> {
            return std::make_unique<DirectMotions>(problem);
          }};
}

std::unique_ptr<ConfigurationSampler> shared(std::unique_ptr<ConfigurationSampler> own, std::uint64_t seed, bool slides,
                                             const SamplerMaker& sampler) {
  return sampler ? sampler(std::move(own), seed, slides) : std::move(own);
}

/// Makes a member's own sampler for a life with this seed.
using OwnSampler = std::function<std::unique_ptr<ConfigurationSampler>(std::uint64_t seed)>;

OwnSampler uniform(const Problem& problem) {
  return [problem](std::uint64_t seed) { return std::make_unique<UniformSampler>(problem, seed); };
}

OwnSampler inAssembly(const Problem& problem, double nearShare) {
  return
      [problem, nearShare](std::uint64_t seed) { return std::make_unique<AssemblySampler>(problem, seed, nearShare); };
}

Member rrtConnect(std::string name, const Contender& contender, const Problem& problem,
                  const RrtConnect::Options& options, const OwnSampler& own, const SamplerMaker& sampler) {
  return {std::move(name), contender,
          [problem, options, own, sampler](std::uint64_t seed, std::uint64_t) -> std::unique_ptr<Planner> {
            return std::make_unique<RrtConnect>(problem, seed, options,
                                                shared(own(seed), seed, options.slides, sampler));
          },
          true};
}

/// The quickest member in open space with a few bars and walls.
Member bkpiece(const Problem& problem) {
  return {"ompl-bkpiece",
          {4.0, kShortPatience, kShortFirstLife, Restart::Luby, headStart(problem)},
          [problem](std::uint64_t seed, std::uint64_t) -> std::unique_ptr<Planner> {
            return std::make_unique<OmplPlanner>(problem, seed, OmplAlgorithm::Bkpiece);
          }};
}

/// One tree from the start, for leaving an assembly.
Member turningRrt(const Problem& problem, const SamplerMaker& sampler) {
  RrtConnect::Options options = turning(problem, 0.03, 0.02);
  options.growth = RrtConnect::Growth::FromStart;
  return rrtConnect("turning-rrt", {2.0, kFirstLife, kFirstLife, Restart::Luby, headStart(problem)}, problem, options,
                    uniform(problem), sampler);
}

/// Two trees with a dynamic domain, so that they do not stay trapped for long.
RrtConnect::Options twoTrees(const Problem& problem) {
  RrtConnect::Options options = turning(problem, 0.02, 0.1);
  options.domain = 10.0;
  return options;
}

/// Begins with long extensions among a few bars and walls. Among detailed parts long extensions are blocked.
Member dynamicDomain(const Problem& problem, const SamplerMaker& sampler) {
  constexpr std::uint64_t kLongDraws = 1'000;
  RrtConnect::Options options = twoTrees(problem);
  options.longDraws = headStart(problem) == 0 ? kLongDraws : 0;
  return rrtConnect("dynamic-domain", {4.5, kLongFirstLife, kLongFirstLife, Restart::Luby, 0}, problem, options,
                    uniform(problem), sampler);
}

/// Two trees whose extensions slide on in contact: along walls, into dead ends and out of them.
Member slidingTrees(const Problem& problem, const SamplerMaker& sampler) {
  constexpr double kNearShare = 0.75;
  RrtConnect::Options options = turning(problem, 0.02, 1.0);
  options.slides = true;
  return rrtConnect("sliding-trees", {1.5, kFirstLife, kFirstLife, Restart::Luby, kHardEntry}, problem, options,
                    inAssembly(problem, kNearShare), sampler);
}

/// Sliding trees with short extensions, for tunnels in which both moves and turns are small.
Member slidingSteps(const Problem& problem, const SamplerMaker& sampler) {
  constexpr double kNearShare = 0.5;
  RrtConnect::Options options = turning(problem, 0.005, 0.3);
  options.slides = true;
  return rrtConnect("sliding-steps", {2.0, kLongFirstLife, kLongFirstLife, Restart::Luby, kHardEntry}, problem, options,
                    inAssembly(problem, kNearShare), sampler);
}

/// Depths of erosion, in radii of the object. They are few because a world is built for each depth and each level.
constexpr double kErosions[] = {0.06, 0.07, 0.08};
/// Work before the member enters, for each triangle of the object, because eroding counts as no work.
constexpr std::uint64_t kErosionEntryPerTriangle = 100;

/// This planner ends its lives itself: most first levels that succeed do so at once, so that a life ends early. Each
/// life draws its own depth of erosion.
Member shrinkRepair(const Problem& problem, const Worlds& worlds) {
  constexpr double kShare = 4.0;
  constexpr std::uint64_t kFirstWork = 5'000;
  ShrinkRepair::Options base;
  base.growth = tolerance::kContactGap * problem.world->objectRadius();
  base.search.range = searchRange(problem, 0.03);
  const std::uint64_t entry = kHardEntry + kErosionEntryPerTriangle * problem.world->object().triangles.size();
  return {"shrink-repair",
          {kShare, kFirstLife, 0, Restart::Luby, entry},
          [problem, worlds, base](std::uint64_t seed, std::uint64_t life) -> std::unique_ptr<Planner> {
            ShrinkRepair::Options options = base;
            const double draw = RandomStream(seed, "erosion").uniform() * std::size(kErosions);
            options.erosion = kErosions[static_cast<std::size_t>(draw)] * problem.world->objectRadius();
            options.firstWork = kFirstWork * lubyTerm(life);
            return std::make_unique<ShrinkRepair>(problem, seed, options, worlds);
          }};
}

/// Takes guidance from the environment model: early where the model exists already, else late.
Member multiLayer(const Problem& problem) {
  const std::uint64_t model = kModelEntry + kModelEntryPerTriangle * obstacleTriangles(problem);
  const std::uint64_t entry = problem.scene.knowledge ? 0 : model;
  return {"gts",
          {1.0, kFirstLife, 0, Restart::Never, entry},
          [problem](std::uint64_t seed, std::uint64_t) -> std::unique_ptr<Planner> {
            return std::make_unique<MultiLayerPlanner>(problem, seed, rulesOf(problem, "gts"));
          }};
}

/// A modelled thread holds the object at the start or at the goal.
bool beginsInThread(const Problem& problem) {
  if (!findModelledThreads(*problem.world, problem.start).empty()) return true;
  const Pose* goal = std::get_if<Pose>(&problem.goal);
  return goal != nullptr && !findModelledThreads(*problem.world, *goal).empty();
}

/// Turns the object out of modelled threads at the start, and into those at the goal.
Member screwMotions(const Problem& problem) {
  return {"screw-motions",
          {4.0, 0, 0, Restart::Never, 0},
          [problem](std::uint64_t seed, std::uint64_t) -> std::unique_ptr<Planner> {
            const auto rest = [seed](const Problem& left) -> std::unique_ptr<Planner> {
              return std::make_unique<DirectThenTrees>(left, seed, twoTrees(left));
            };
            return std::make_unique<ThreadedPlanner>(problem, rest,
                                                     std::make_unique<ModelledThreadWays>(problem.world));
          }};
}

}  // namespace

RrtConnect::Options turning(const Problem& problem, double range, double turnWeight) {
  RrtConnect::Options options;
  options.turnWeight = turnWeight;
  options.range = searchRange(problem, range, turnWeight);
  return options;
}

std::vector<Member> makeMembers(const Problem& problem, const Worlds& worlds, const SamplerMaker& sampler) {
  std::vector<Member> members{directMotions(problem),         dynamicDomain(problem, sampler),
                              turningRrt(problem, sampler),   bkpiece(problem),
                              slidingTrees(problem, sampler), slidingSteps(problem, sampler),
                              shrinkRepair(problem, worlds),  multiLayer(problem)};
  if (beginsInThread(problem)) members.push_back(screwMotions(problem));
  return members;
}

std::vector<Member> makeMembers(const Problem& problem) {
  return makeMembers(problem, std::make_shared<ErodedWorlds>(problem.world), nullptr);
}

}  // namespace glissade
