#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// One benchmark of a program, whose name has parts: "collide/L/near/kernel", "nearest/tree/1000".
struct BenchmarkTime {
  std::string name;
  double seconds = 0.0;  ///< processor time for one iteration
  std::map<std::string, double> counters;
};

/// Output of a program of tests/benchmarks with --benchmark_out.
struct BenchmarkRun {
  std::map<std::string, std::string> context;  ///< date, machine, libraries, commit, ...
  std::vector<BenchmarkTime> times;
};

/// Reads Google Benchmark's JSON. Benchmarks that ended with an error, and aggregates other than the median, are left
/// out. Any other form is MalformedInput.
Result<BenchmarkRun> readBenchmarks(const std::string& text, const std::string& file);

/// Times of the same query by our kernel and by FCL: "question/model/poses/kernel" and ".../fcl".
struct BackendTimes {
  std::string question;
  std::string place;  ///< model and poses, for example "L/near"
  double kernel = 0.0;
  double fcl = 0.0;  ///< both in seconds

  double ratio() const { return fcl / kernel; }
};
/// Sorted by query and place; queries that were not measured with both are left out.
std::vector<BackendTimes> backendTimes(const std::vector<BenchmarkTime>& times);
/// Geometric mean of the ratios for one query. Precondition: there are some.
double geometricMean(const std::vector<BackendTimes>& times, const std::string& question);

/// Growth of a time with the size: "quantity/who/size". The counter "size", if present, has the exact size.
struct GrowthSeries {
  std::string quantity;
  std::string who;
  std::vector<std::pair<double, double>> points;  ///< size, seconds
  std::optional<double> exponent;                 ///< exponent of the size; nothing for one size
};
std::vector<GrowthSeries> growthSeries(const std::vector<BenchmarkTime>& times);

/// True for the ending that Google Benchmark adds if the program measured the time itself.
bool hasOwnClock(const std::string& benchmarkName);

}  // namespace glissade
