#include "engine/planning/difficulty/least_penetration.h"

#include <algorithm>

#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/path_repair.h"
#include "engine/planning/automatic/rrt_connect.h"

namespace glissade {
namespace {

/// The smallest and the largest erosion to try, in radii of the object, and the number of erosions.
constexpr double kFirst = 0.01;
constexpr double kLast = 0.64;
constexpr double kErosions = 7.0;
constexpr double kRange = 0.03;
/// Share of the progress that is reported for the searches.
constexpr double kSearching = 0.6;
/// Share of its erosion by which the object grows back in a round; halved where the way cannot be repaired.
constexpr double kFirstStep = 0.4;
constexpr double kLastStep = 0.02;

/// Lets a planner run until its queries are used up.
class LimitedHost final : public PlannerHost {
 public:
  LimitedHost(const Planner& planner, const ParameterValues& parameters, std::uint64_t work, const StopToken& stop)
      : planner_(planner), parameters_(parameters), work_(work), stop_(stop) {}

  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return parameters_; }
  bool afterStep() override {
    const QueryCounts& spent = planner_.counts().queries;
    return spent.collision + spent.distance < work_ && !stop_.stopRequested();
  }
  const StopToken& stopToken() const override { return stop_; }

 private:
  const Planner& planner_;
  const ParameterValues& parameters_;
  std::uint64_t work_;
  const StopToken& stop_;
};

class Search {
 public:
  Search(const Problem& problem, const ParameterValues& parameters, std::uint64_t seed, const PenetrationBudget& budget,
         const WorkWatch& watch)
      : problem_(problem),
        parameters_(parameters),
        seed_(seed),
        budget_(budget),
        watch_(watch),
        worlds_(problem.world) {
    options_.range = searchRange(problem, kRange);
  }

  std::optional<LeastPenetration> run() {
    const double radius = problem_.world->objectRadius();
    double tried = 0.0;
    for (double share = kFirst; share <= kLast && way_.empty() && !watch_.stop.stopRequested(); share *= 2.0) {
      watch_.report(kSearching * tried++ / kErosions);
      if (!search(share * radius)) worlds_.keepOnly(0.0);
    }
    if (way_.empty()) return std::nullopt;
    double step = kFirstStep;
    for (int round = 0; round < budget_.rounds && step > kLastStep && !watch_.stop.stopRequested(); ++round) {
      watch_.report(kSearching + (1.0 - kSearching) * round / budget_.rounds);
      if (!repair(erosion_ * (1.0 - step), round)) step *= 0.5;
      worlds_.keepOnly(erosion_);
    }
    return deepest();
  }

 private:
  bool search(double erosion) {
    const Problem part = eroded(erosion);
    RrtConnect planner(part, seed_, options_, std::make_unique<UniformSampler>(part, seed_));
    return take(planner, budget_.searchWork, erosion);
  }

  bool repair(double erosion, int round) {
    const std::uint64_t seed = RandomStream(seed_, "round " + std::to_string(round)).bits();
    const PathRepair::Options options{worlds_.at(erosion_), erosion_ - erosion, options_, budget_.repairWork};
    PathRepair planner(eroded(erosion), seed, way_, options);
    return take(planner, budget_.repairWork, erosion);
  }

  Problem eroded(double erosion) {
    Problem part = problem_;
    part.world = worlds_.at(erosion);
    return part;
  }

  bool take(Planner& planner, std::uint64_t work, double erosion) {
    LimitedHost host(planner, parameters_, work, watch_.stop);
    if (!planner.solve(host)) return false;
    way_ = planner.path()->configurations();
    erosion_ = erosion;
    return true;
  }

  /// Finds the deepest configuration: where the eroded object has the least clearance, the whole object penetrates
  /// most.
  LeastPenetration deepest() {
    const auto query = worlds_.at(erosion_)->makeQuery();
    const MotionCertificate certificate = certifyPath(*query, way_, parameters_[ParameterId::RequiredClearance]);
    LeastPenetration result;
    const std::size_t edge = std::min(certificate.edge, way_.size() - 1);
    result.q = interpolate(way_[edge], way_[std::min(edge + 1, way_.size() - 1)], certificate.at);
    result.depth = std::max(0.0, erosion_ - certificate.minClearance);
    result.body = certificate.nearest.body;
    result.way = way_;
    return result;
  }

  const Problem& problem_;
  const ParameterValues& parameters_;
  std::uint64_t seed_;
  const PenetrationBudget& budget_;
  const WorkWatch& watch_;
  ErodedWorlds worlds_;
  RrtConnect::Options options_;
  std::vector<Pose> way_;
  double erosion_ = 0.0;  ///< erosion of the object for which the way is free
};

}  // namespace

std::optional<LeastPenetration> leastPenetration(const Problem& problem, const ParameterValues& parameters,
                                                 std::uint64_t seed, const PenetrationBudget& budget,
                                                 const WorkWatch& watch) {
  return Search(problem, parameters, seed, budget, watch).run();
}

}  // namespace glissade
