#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// One benchmark of a program, named by parts: "collide/L/near/kernel", "nearest/tree/1000".
struct BenchmarkTime {
  std::string name;
  double seconds = 0.0;  ///< of the processor, for one iteration
  std::map<std::string, double> counters;
};

/// What a program of tests/benchmarks wrote with --benchmark_out.
struct BenchmarkRun {
  std::map<std::string, std::string> context;  ///< date, machine, libraries, commit, ...
  std::vector<BenchmarkTime> times;
};

/// Google Benchmark's JSON. Benchmarks that ended with an error, and aggregates of repetitions, are left
/// out; anything that is not of this form is MalformedInput.
Result<BenchmarkRun> readBenchmarks(const std::string& text, const std::string& file);

/// The same question asked of our kernel and of FCL: "question/model/poses/kernel" and ".../fcl".
struct BackendTimes {
  std::string question;
  std::string place;  ///< "L/near"
  double kernel = 0.0;
  double fcl = 0.0;  ///< both in seconds

  double ratio() const { return fcl / kernel; }
};
/// By question and place; questions that were not asked of both are left out.
std::vector<BackendTimes> backendTimes(const std::vector<BenchmarkTime>& times);
/// Of the ratios of one question. Precondition: there are some.
double geometricMean(const std::vector<BackendTimes>& times, const std::string& question);

/// How a time grows: "quantity/who/size". The counter "size", where there is one, has the exact size.
struct GrowthSeries {
  std::string quantity;
  std::string who;
  std::vector<std::pair<double, double>> points;  ///< size, seconds
  std::optional<double> exponent;                 ///< of the power of the size; nothing for one size
};
std::vector<GrowthSeries> growthSeries(const std::vector<BenchmarkTime>& times);

/// Google Benchmark's ending of names whose time a program took itself.
bool hasOwnClock(const std::string& benchmarkName);

}  // namespace glissade
