// The kernel against FCL (OBBRSS) in one run: same meshes, same poses, one core. Surfaces alone in both,
// so that neither pays for our test of containment. Prints the ratios and their geometric means.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>

#include "engine/base/random_stream.h"
#include "engine/collision/fcl_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/scenario/scenario_io.h"
#include "tests/benchmarks/benchmark_program.h"

namespace glissade {
namespace {

constexpr std::size_t kPoses = 1000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Edge {
  Pose from;
  Pose to;
};

/// One problem with its poses sorted by what they meet, as FCL sees it.
struct Model {
  std::string name;
  LoadedScenario scenario;
  std::shared_ptr<const FclGeometry> fcl;
  std::shared_ptr<const KernelGeometry> kernel;
  std::map<std::string, std::vector<Pose>> poses;
  std::map<std::string, std::vector<Edge>> edges;
};

Pose randomPose(const Box3& bounds, RandomStream& stream) {
  Pose q;
  for (int axis = 0; axis < 3; ++axis) q.position[axis] = stream.uniform(bounds.min()[axis], bounds.max()[axis]);
  q.orientation = Quaternion(stream.normal(), stream.normal(), stream.normal(), stream.normal()).normalized();
  return q;
}

/// 5 % of the bounds' diagonal in any direction, and 15 degrees.
Pose stepFrom(const Pose& from, const Box3& bounds, RandomStream& stream) {
  const Vector3 direction(stream.normal(), stream.normal(), stream.normal());
  const Vector3 axis(stream.normal(), stream.normal(), stream.normal());
  Pose to = from;
  to.position += 0.05 * bounds.diagonal().norm() * direction.normalized();
  to.orientation = from.orientation * Quaternion(Eigen::AngleAxisd(std::acos(-1.0) / 12.0, axis.normalized()));
  return to;
}

/// Between a free and a colliding pose, down to a thousandth of the object: on the free side.
Pose nearContact(FclSurfaceQuery& fcl, Pose free, Pose colliding, double size) {
  while ((free.position - colliding.position).norm() > 1e-3 * size) {
    const Pose middle = interpolate(free, colliding, 0.5);
    (fcl.touches(middle) ? colliding : free) = middle;
  }
  return free;
}

void drawPoses(Model& model) {
  FclSurfaceQuery fcl(model.fcl);
  RandomStream stream(1, model.name);
  const Box3& bounds = model.scenario.problem.bounds;
  const double size = model.scenario.problem.world->objectRadius();
  auto& free = model.poses["free"];
  auto& colliding = model.poses["colliding"];
  while (free.size() < kPoses || colliding.size() < kPoses) {
    const Pose q = randomPose(bounds, stream);
    auto& list = fcl.touches(q) ? colliding : free;
    if (list.size() < kPoses) list.push_back(q);
  }
  for (std::size_t i = 0; i < kPoses; ++i) {
    model.poses["near"].push_back(nearContact(fcl, free[i], colliding[i], size));
  }
  for (const auto& [kind, poses] : model.poses) {
    for (const Pose& q : poses) model.edges[kind].push_back({q, stepFrom(q, bounds, stream)});
  }
}

std::vector<Model> loadModels() {
  const std::filesystem::path root = GLISSADE_SOURCE_DIR;
  const std::vector<std::pair<std::string, std::filesystem::path>> files{
      {"L", root / "samples/environment-1/scenario.json"},
      {"pump", root / "samples/pump/mount.json"},
      {"Twistycool", root / "../shared/problems/omplapp/Twistycool.cfg"},
      {"alpha-1.5", root / "../shared/problems/omplapp/alpha-1.5.cfg"}};
  std::vector<Model> models;
  for (const auto& [name, file] : files) {
    if (!std::filesystem::exists(file)) {
      std::printf("%s is not there: left out\n", file.c_str());
      continue;
    }
    auto loaded = loadScenario(file.string());
    if (!loaded) {
      std::printf("%s\n", toString(loaded.error()).c_str());
      continue;
    }
    Model model;
    model.name = name;
    model.fcl = makeFclGeometry(loaded->obstacles, *loaded->object.mesh);
    model.kernel = std::make_shared<const KernelGeometry>(loaded->obstacles, *loaded->object.mesh);
    model.scenario = std::move(*loaded);
    drawPoses(model);
    models.push_back(std::move(model));
  }
  return models;
}

using Question = std::function<void(std::size_t)>;

void ask(const std::string& name, const Question& question) {
  benchmark::RegisterBenchmark(name.c_str(), [question](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) question(i++ % kPoses);
  });
}

/// Both backends asked the same, under "question/model/kind/backend".
void registerQuestions(const Model& model, const std::string& kind) {
  const auto fcl = std::make_shared<FclSurfaceQuery>(model.fcl);
  const auto kernel = std::make_shared<KernelQuery>(model.kernel);
  const auto* poses = &model.poses.at(kind);
  const auto* edges = &model.edges.at(kind);
  const std::string place = "/" + model.name + "/" + kind;
  ask("collide" + place + "/fcl", [=](std::size_t i) { benchmark::DoNotOptimize(fcl->touches((*poses)[i])); });
  ask("collide" + place + "/kernel", [=](std::size_t i) { benchmark::DoNotOptimize(kernel->touches((*poses)[i])); });
  ask("distance" + place + "/fcl",
      [=](std::size_t i) { benchmark::DoNotOptimize(fcl->nearest((*poses)[i], kInfinity)); });
  ask("distance" + place + "/kernel", [=](std::size_t i) {
    // As the world asks it: a yes/no first, the distance where there is one.
    if (!kernel->touches((*poses)[i])) benchmark::DoNotOptimize(kernel->nearest((*poses)[i], kInfinity));
  });
  ask("edge" + place + "/fcl", [=](std::size_t i) {
    const auto& [from, to] = (*edges)[i];
    bool free = true;
    for (int k = 1; k <= 20 && free; ++k) free = !fcl->touches(interpolate(from, to, k / 20.0));
    benchmark::DoNotOptimize(free);
  });
  const double required = model.scenario.parameters[ParameterId::RequiredClearance];
  ask("edge" + place + "/kernel", [=](std::size_t i) {
    benchmark::DoNotOptimize(kernel->checkMotion((*edges)[i].from, (*edges)[i].to, required, {}));
  });
}

/// Prints as usual, and keeps the times.
class Times : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) times[run.benchmark_name()] = run.GetAdjustedCPUTime();
    ConsoleReporter::ReportRuns(runs);
  }

  std::map<std::string, double> times;
};

void printRatios(const std::map<std::string, double>& times) {
  std::map<std::string, std::pair<double, int>> logarithms;
  std::printf("\n%-32s %12s %12s %8s\n", "question/model/poses", "FCL, us", "kernel, us", "ratio");
  for (const auto& [name, time] : times) {
    const std::size_t suffix = name.rfind("/kernel");
    if (suffix == std::string::npos) continue;
    const std::string place = name.substr(0, suffix);
    const auto fcl = times.find(place + "/fcl");
    if (fcl == times.end()) continue;
    const double ratio = fcl->second / time;
    std::printf("%-32s %12.3f %12.3f %8.1f\n", place.c_str(), 1e-3 * fcl->second, 1e-3 * time, ratio);
    auto& [sum, count] = logarithms[place.substr(0, place.find('/'))];
    sum += std::log(ratio);
    ++count;
  }
  for (const auto& [question, sum] : logarithms) {
    std::printf("geometric mean, %-16s %8.1f\n", question.c_str(), std::exp(sum.first / sum.second));
  }
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  addMachineContext();
  const std::vector<Model> models = loadModels();
  for (const Model& model : models) {
    for (const auto& [kind, poses] : model.poses) registerQuestions(model, kind);
  }
  Times times;
  benchmark::RunSpecifiedBenchmarks(&times);
  printRatios(times.times);
  return 0;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) { return glissade::run(argc, argv); }
