// Growth of times: a planner's iteration with its tree, a collision check with its triangles, for our code, OMPL and
// FCL. Benchmarks are named quantity/who/size; the exponents are printed at the end.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>

#include "engine/collision/fcl_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/planning/contact/interactive_contact_birrt.h"
#include "engine/planning/ompl/ompl_planner.h"
#include "engine/planning/rrt.h"
#include "tests/benchmarks/benchmark_program.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// --- planners ---

/// Fifty tilted boxes in a hall of 10 m; the goal is walled in, so that trees grow for ever.
Problem endlessProblem() {
  RandomStream stream(1, "hall");
  std::vector<RigidBody> bodies;
  for (int i = 0; i < 50; ++i) {
    const Vector3 size(stream.uniform(0.3, 1.5), stream.uniform(0.3, 1.5), stream.uniform(0.3, 1.5));
    Pose X_WB = randomPose(stream, 4.0);
    X_WB.position.x() -= 1.5;  // away from the goal
    bodies.push_back(boxBody("box " + std::to_string(i), size, X_WB));
  }
  const Vector3 goal(4.3, 4.3, 4.3);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vector3 size = Vector3::Constant(1.3);
      size[axis] = 0.05;
      Vector3 centre = goal;
      centre[axis] += 0.62 * side;
      bodies.push_back(boxBody("wall", size, Pose::translation(centre)));
    }
  }
  Problem problem;
  problem.world =
      CollisionWorld::build(std::move(bodies), std::make_shared<const TriangleMesh>(makeBox({0.4, 0.2, 0.2})));
  problem.bounds = Box3(Vector3::Constant(-5.0), Vector3::Constant(5.0));
  problem.start = Pose::translation({4.6, -4.6, -4.6});
  problem.goal = Pose::translation(goal);
  return problem;
}

/// Ends a run after a number of random configurations.
class DrawingHost final : public PlannerHost {
 public:
  DrawingHost(const Planner& planner, double radius) : planner_(planner), values_(radius) {}

  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return values_; }
  bool afterStep() override { return planner_.counts().randomConfigurations < until_; }
  const StopToken& stopToken() const override { return stop_; }

  void allow(std::uint64_t draws) { until_ = planner_.counts().randomConfigurations + draws; }

 private:
  const Planner& planner_;
  ParameterValues values_;
  StopToken stop_;
  std::uint64_t until_ = 0;
};

using MakePlanner = std::function<std::unique_ptr<Planner>(const Problem&, std::uint64_t seed)>;

/// Trees of a given size that continue to grow; small ones of several seeds.
class Growth {
 public:
  Growth(const MakePlanner& make, std::uint64_t nodes) : nodes_(nodes) {
    const Problem problem = endlessProblem();
    const std::uint64_t seeds = nodes < 100'000 ? 8 : 1;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      planners_.push_back(make(problem, seed));
      hosts_.push_back(std::make_unique<DrawingHost>(*planners_.back(), problem.world->objectRadius()));
      while (planners_.back()->counts().nodes < nodes) {
        grow(planners_.size() - 1, nodes / 8);
        planners_.back()->completeRoadmap();
      }
    }
  }

  /// Processor time of an iteration, which is a random configuration, over a tenth of the nodes.
  double secondsPerIteration() {
    const std::uint64_t drawsBefore = draws();
    const std::clock_t before = std::clock();
    for (std::size_t i = 0; i < planners_.size(); ++i) grow(i, nodes_ / 10);
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    return seconds / static_cast<double>(draws() - drawsBefore);
  }

  double meanNodes() {
    double sum = 0.0;
    for (const auto& planner : planners_) sum += static_cast<double>(planner->counts().nodes);
    return sum / static_cast<double>(planners_.size());
  }

 private:
  void grow(std::size_t i, std::uint64_t draws) {
    hosts_[i]->allow(draws);
    planners_[i]->solve(*hosts_[i]);
  }

  std::uint64_t draws() const {
    std::uint64_t sum = 0;
    for (const auto& planner : planners_) sum += planner->counts().randomConfigurations;
    return sum;
  }

  std::uint64_t nodes_;
  std::vector<std::unique_ptr<Planner>> planners_;
  std::vector<std::unique_ptr<DrawingHost>> hosts_;
};

void registerPlanner(const std::string& who, const MakePlanner& make, std::int64_t most) {
  const auto measure = [make](benchmark::State& state) {
    Growth growth(make, static_cast<std::uint64_t>(state.range(0)));
    state.counters["size"] = growth.meanNodes();
    for (auto _ : state) state.SetIterationTime(growth.secondsPerIteration());
  };
  benchmark::RegisterBenchmark(("iteration/" + who).c_str(), measure)
      ->RangeMultiplier(10)
      ->Range(1000, most)
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

void registerPlanners() {
  const auto ompl = [](OmplAlgorithm algorithm) {
    return [algorithm](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
      return std::make_unique<OmplPlanner>(problem, seed, algorithm, OmplManner::AsItIs);
    };
  };
  registerPlanner(
      "RRT", [](const Problem& problem, std::uint64_t seed) { return std::make_unique<Rrt>(problem, seed); },
      1'000'000);
  registerPlanner(
      "BiRRT",
      [](const Problem& problem, std::uint64_t seed) {
        return std::make_unique<InteractiveContactBirrt>(problem, seed, OperatorUse::None);
      },
      1'000'000);
  // A tree of a million nodes takes OMPL's planners more than an hour.
  registerPlanner("OMPL's RRT", ompl(OmplAlgorithm::Rrt), 100'000);
  registerPlanner("OMPL's RRT-Connect", ompl(OmplAlgorithm::RrtConnect), 100'000);
}

// --- collision checks ---

/// A square sheet with waves, with about `triangles` triangles. It is open, so that nothing is inside.
TriangleMesh wavySheet(double size, std::int64_t triangles) {
  const auto cells =
      static_cast<std::uint32_t>(std::max(1.0, std::round(std::sqrt(static_cast<double>(triangles) / 2.0))));
  TriangleMesh mesh;
  const double step = size / cells;
  for (std::uint32_t i = 0; i <= cells; ++i) {
    for (std::uint32_t j = 0; j <= cells; ++j) {
      const double x = i * step - size / 2.0;
      const double y = j * step - size / 2.0;
      mesh.vertices.emplace_back(x, y, 0.1 * std::sin(4.0 * x) * std::cos(3.0 * y));
    }
  }
  for (std::uint32_t i = 0; i < cells; ++i) {
    for (std::uint32_t j = 0; j < cells; ++j) {
      const std::uint32_t corner = i * (cells + 1) + j;
      mesh.triangles.push_back({corner, corner + cells + 1, corner + cells + 2});
      mesh.triangles.push_back({corner, corner + cells + 2, corner + 1});
    }
  }
  return mesh;
}

/// Two sheets with a given number of triangles together, and difficult poses in near contact.
struct Sheets {
  static constexpr std::size_t kPoses = 64;

  explicit Sheets(std::int64_t triangles) : object(wavySheet(1.0, triangles / 2)) {
    RigidBody body;
    body.id = "sheet";
    body.mesh = std::make_shared<const TriangleMesh>(wavySheet(3.0, triangles / 2));
    obstacles.push_back(body);
    const auto geometry = std::make_shared<const KernelGeometry>(obstacles, object);
    KernelQuery query(geometry);
    RandomStream stream(3, "sheets");
    while (poses.size() < kPoses) {
      Pose colliding = randomPose(stream, 1.0);
      if (!query.touches(colliding)) continue;
      Pose free = colliding;
      free.position.z() += 3.0;
      while ((free.position - colliding.position).norm() > 1e-3) {
        const Pose middle = interpolate(free, colliding, 0.5);
        (query.touches(middle) ? colliding : free) = middle;
      }
      poses.push_back(free);
    }
  }

  /// A pose moved by 5 % of the larger sheet along it.
  Pose after(std::size_t i) const {
    Pose to = poses[i];
    to.position.x() += 0.15;
    return to;
  }

  std::vector<RigidBody> obstacles;
  TriangleMesh object;
  std::vector<Pose> poses;
};

using MakeQuery = std::function<std::unique_ptr<SurfaceQuery>(const Sheets&)>;
using Ask = std::function<void(SurfaceQuery&, const Sheets&, std::size_t)>;

void registerCheck(const std::string& quantity, const std::string& who, const MakeQuery& make, const Ask& ask,
                   std::int64_t most) {
  const auto measure = [make, ask](benchmark::State& state) {
    const Sheets sheets(state.range(0));
    const auto query = make(sheets);
    state.counters["size"] =
        static_cast<double>(sheets.object.triangles.size() + sheets.obstacles.front().mesh->triangles.size());
    std::size_t i = 0;
    for (auto _ : state) ask(*query, sheets, i++ % Sheets::kPoses);
  };
  benchmark::RegisterBenchmark((quantity + "/" + who).c_str(), measure)
      ->RangeMultiplier(10)
      ->Range(100, most)
      ->Unit(benchmark::kMicrosecond);
}

void registerChecks() {
  constexpr std::int64_t kMost = 1'000'000;
  const MakeQuery kernel = [](const Sheets& sheets) {
    return std::make_unique<KernelQuery>(std::make_shared<const KernelGeometry>(sheets.obstacles, sheets.object));
  };
  const MakeQuery fcl = [](const Sheets& sheets) {
    return std::make_unique<FclSurfaceQuery>(makeFclGeometry(sheets.obstacles, sheets.object));
  };
  const Ask collide = [](SurfaceQuery& query, const Sheets& sheets, std::size_t i) {
    benchmark::DoNotOptimize(query.touches(sheets.poses[i]));
  };
  const Ask distance = [](SurfaceQuery& query, const Sheets& sheets, std::size_t i) {
    benchmark::DoNotOptimize(query.nearest(sheets.poses[i], kInfinity));
  };
  const Ask edge = [](SurfaceQuery& query, const Sheets& sheets, std::size_t i) {
    benchmark::DoNotOptimize(query.checkMotion(sheets.poses[i], sheets.after(i), 1e-6, SeekViolation::Any, {}));
  };
  const Ask samples = [](SurfaceQuery& query, const Sheets& sheets, std::size_t i) {
    bool free = true;
    for (int k = 1; k <= 20 && free; ++k)
      free = !query.touches(interpolate(sheets.poses[i], sheets.after(i), k / 20.0));
    benchmark::DoNotOptimize(free);
  };
  registerCheck("collide", "kernel", kernel, collide, kMost);
  registerCheck("collide", "fcl", fcl, collide, kMost);
  registerCheck("distance", "kernel", kernel, distance, kMost);
  registerCheck("distance", "fcl", fcl, distance, kMost);
  registerCheck("edge", "kernel", kernel, edge, kMost);
  registerCheck("edge", "fcl", fcl, samples, kMost);
}

// --- results ---

using PointsOfSeries = std::map<std::string, std::vector<std::pair<double, double>>>;

/// The exponent k of y = c x^k, by least squares of the logarithms. Nothing for a single size.
std::optional<double> fittedExponent(const std::vector<std::pair<double, double>>& points) {
  double meanX = 0.0;
  double meanY = 0.0;
  for (const auto& [x, y] : points) {
    meanX += std::log(x) / static_cast<double>(points.size());
    meanY += std::log(y) / static_cast<double>(points.size());
  }
  double squares = 0.0;
  double products = 0.0;
  for (const auto& [x, y] : points) {
    squares += (std::log(x) - meanX) * (std::log(x) - meanX);
    products += (std::log(x) - meanX) * (std::log(y) - meanY);
  }
  if (squares <= 1e-12) return std::nullopt;
  return products / squares;
}

/// Prints as the console reporter, and keeps the points (size, time) of each "quantity/who".
class Points : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto size = run.counters.find("size");
      if (size == run.counters.end()) continue;
      const std::string name = run.benchmark_name();
      const bool ownClock = name.find("manual_time") != std::string::npos;
      series[name.substr(0, name.find('/', name.find('/') + 1))].emplace_back(
          size->second.value, ownClock ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime());
    }
    ConsoleReporter::ReportRuns(runs);
  }

  PointsOfSeries series;
};

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  addMachineContext();
  registerPlanners();
  registerChecks();
  Points points;
  benchmark::RunSpecifiedBenchmarks(&points);
  for (const auto& [name, series] : points.series) {
    if (const auto exponent = fittedExponent(series)) std::printf("%-40s grows by n^%.2f\n", name.c_str(), *exponent);
  }
  return 0;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) { return glissade::run(argc, argv); }
