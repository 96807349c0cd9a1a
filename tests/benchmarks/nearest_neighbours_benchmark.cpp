// Compares the nearest neighbour in a growing tree with a plain scan over all configurations.
#include <limits>

#include "engine/planning/nearest_neighbours.h"
#include "tests/benchmarks/benchmark_program.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

const Se3Metric kMetric(0.7);

std::vector<Pose> configurations(std::int64_t count) {
  RandomStream stream(1, "configurations");
  std::vector<Pose> poses;
  for (std::int64_t i = 0; i < count; ++i) poses.push_back(randomPose(stream, 1.0));
  return poses;
}

void treeOfBoxes(benchmark::State& state) {
  NearestNeighbours neighbours(kMetric);
  for (const Pose& q : configurations(state.range(0))) neighbours.add(0, q);
  RandomStream stream(2, "questions");
  for (auto _ : state) benchmark::DoNotOptimize(neighbours.nearest(randomPose(stream, 1.0)));
}
BENCHMARK(treeOfBoxes)->Name("nearest/tree")->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMicrosecond);

void plainScan(benchmark::State& state) {
  const std::vector<Pose> poses = configurations(state.range(0));
  RandomStream stream(2, "questions");
  for (auto _ : state) {
    const Pose q = randomPose(stream, 1.0);
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& pose : poses) least = std::min(least, kMetric.distance(pose, q));
    benchmark::DoNotOptimize(least);
  }
}
BENCHMARK(plainScan)->Name("nearest/scan")->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace glissade

GLISSADE_BENCHMARK_MAIN()
