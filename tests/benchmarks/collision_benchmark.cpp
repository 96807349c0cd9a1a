// The kernel against FCL (OBBRSS) in one run: same meshes, same poses, one core. Repetitions of all queries are mixed,
// so that a load of the machine affects both. Prints the ratios of the medians and their geometric means.
#include <cmath>
#include <cstdio>
#include <map>

#include "tests/benchmarks/benchmark_program.h"
#include "tests/benchmarks/collision_models.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

constexpr std::size_t kPoses = 1000;

void ask(const std::string& name, std::size_t count, const std::function<void(std::size_t)>& question) {
  benchmark::RegisterBenchmark(name.c_str(), [count, question](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) question(i++ % count);
  });
}

/// Prints as the console reporter, and keeps the medians.
class Times : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name == "median") times[run.run_name.function_name] = run.GetAdjustedCPUTime();
    }
    ConsoleReporter::ReportRuns(runs);
  }

  std::map<std::string, double> times;
};

void printRatios(const std::vector<CollisionQuestion>& questions, const std::map<std::string, double>& times) {
  std::map<std::string, std::pair<double, int>> logarithms;
  std::printf("\n%-32s %12s %12s %8s\n", "question/model/poses", "FCL, us", "kernel, us", "ratio");
  for (const CollisionQuestion& question : questions) {
    const auto fcl = times.find(question.place() + "/fcl");
    const auto kernel = times.find(question.place() + "/kernel");
    if (fcl == times.end() || kernel == times.end()) continue;
    const double ratio = fcl->second / kernel->second;
    std::printf("%-32s %12.3f %12.3f %8.1f\n", question.place().c_str(), 1e-3 * fcl->second, 1e-3 * kernel->second,
                ratio);
    auto& [sum, count] = logarithms[question.what];
    sum += std::log(ratio);
    ++count;
  }
  for (const auto& [what, sum] : logarithms) {
    std::printf("geometric mean, %-16s %8.1f\n", what.c_str(), std::exp(sum.first / sum.second));
  }
}

int run(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  std::string repetitions = "--benchmark_repetitions=5";
  std::string mixed = "--benchmark_enable_random_interleaving=true";
  std::string medians = "--benchmark_report_aggregates_only=true";
  std::string seconds = "--benchmark_min_time=0.1";
  arguments.insert(arguments.begin() + 1, {repetitions.data(), mixed.data(), medians.data(), seconds.data()});
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  addMachineContext();
  const std::vector<CollisionQuestion> questions = collisionQuestions(test::sourceDirectory(), kPoses);
  for (const CollisionQuestion& question : questions) {
    ask(question.place() + "/fcl", question.count, question.fcl);
    ask(question.place() + "/kernel", question.count, question.kernel);
  }
  Times times;
  benchmark::RunSpecifiedBenchmarks(&times);
  printRatios(questions, times.times);
  return 0;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) { return glissade::run(argc, argv); }
