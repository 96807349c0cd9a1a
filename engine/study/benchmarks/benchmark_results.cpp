#include "engine/study/benchmarks/benchmark_results.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/base/json_reader.h"
#include "engine/base/number_text.h"
#include "engine/study/statistics.h"

namespace glissade {
namespace {

constexpr const char* kOwnClock = "manual_time";

/// Parts of a name, without those that Google Benchmark adds ("iterations:1", "manual_time").
std::vector<std::string> partsOf(const std::string& name) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    if (part.find(':') == std::string::npos && part != kOwnClock) parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

std::string joined(const std::vector<std::string>& parts, std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t i = first; i < last; ++i) text += (text.empty() ? "" : "/") + parts[i];
  return text;
}

double secondsIn(const JsonCursor& unit) {
  const std::map<std::string, double> units{{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}};
  const auto found = units.find(unit.text());
  if (found == units.end()) unit.fail(GLISSADE_TEXT("is not ns, us, ms or s"));
  return found->second;
}

/// False for Google Benchmark's own numeric keys of an entry.
bool isCounter(const std::string& key) {
  static constexpr const char* kOwn[] = {"family_index", "per_family_instance_index",
                                         "repetitions",  "repetition_index",
                                         "threads",      "iterations",
                                         "real_time",    "cpu_time"};
  return std::find(std::begin(kOwn), std::end(kOwn), key) == std::end(kOwn);
}

bool isAggregate(const JsonCursor& at) {
  const auto type = at.find("run_type");
  return type && type->text() == "aggregate";
}

/// True for a run, or for the median of several runs; other aggregates are not read.
bool isMeasured(const JsonCursor& at) {
  const auto failed = at.find("error_occurred");
  if (failed && failed->boolean()) return false;
  const auto aggregate = at.find("aggregate_name");
  return !isAggregate(at) || (aggregate && aggregate->text() == "median");
}

BenchmarkTime readTime(const JsonCursor& at) {
  BenchmarkTime time;
  time.name = at.at(isAggregate(at) ? "run_name" : "name").nonEmptyText();
  const JsonCursor measured = at.at(hasOwnClock(time.name) ? "real_time" : "cpu_time");
  time.seconds = measured.positiveNumber() * secondsIn(at.at("time_unit"));
  for (const auto& item : at.json().items()) {
    if (item.value().is_number() && isCounter(item.key())) time.counters[item.key()] = at.at(item.key()).number();
  }
  return time;
}

BenchmarkRun readRun(const JsonCursor& root) {
  BenchmarkRun run;
  const JsonCursor context = root.at("context");
  context.expectObject();
  for (const auto& item : context.json().items()) {
    if (item.value().is_string()) run.context[item.key()] = context.at(item.key()).text();
  }
  const JsonCursor list = root.at("benchmarks");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonCursor at = list.element(i);
    at.expectObject();
    if (isMeasured(at)) run.times.push_back(readTime(at));
  }
  return run;
}

}  // namespace

bool hasOwnClock(const std::string& benchmarkName) { return benchmarkName.find(kOwnClock) != std::string::npos; }

Result<BenchmarkRun> readBenchmarks(const std::string& text, const std::string& file) {
  return readJson(text, file, readRun);
}

std::vector<BackendTimes> backendTimes(const std::vector<BenchmarkTime>& times) {
  std::map<std::string, double> fcl;
  for (const BenchmarkTime& time : times) {
    const auto parts = partsOf(time.name);
    if (parts.back() == "fcl") fcl[joined(parts, 0, parts.size() - 1)] = time.seconds;
  }
  std::vector<BackendTimes> pairs;
  for (const BenchmarkTime& time : times) {
    const auto parts = partsOf(time.name);
    if (parts.size() < 3 || parts.back() != "kernel") continue;
    const auto peer = fcl.find(joined(parts, 0, parts.size() - 1));
    if (peer == fcl.end()) continue;
    pairs.push_back({parts.front(), joined(parts, 1, parts.size() - 1), time.seconds, peer->second});
  }
  // Repetitions of all queries are mixed during the measurement, so that they are sorted here.
  std::sort(pairs.begin(), pairs.end(), [](const BackendTimes& a, const BackendTimes& b) {
    return std::tie(a.question, a.place) < std::tie(b.question, b.place);
  });
  return pairs;
}

double geometricMean(const std::vector<BackendTimes>& times, const std::string& question) {
  double sum = 0.0;
  double count = 0.0;
  for (const BackendTimes& pair : times) {
    if (pair.question != question) continue;
    sum += std::log(pair.ratio());
    ++count;
  }
  return std::exp(sum / count);
}

std::vector<GrowthSeries> growthSeries(const std::vector<BenchmarkTime>& times) {
  std::vector<GrowthSeries> all;
  for (const BenchmarkTime& time : times) {
    const auto parts = partsOf(time.name);
    const auto named = parts.size() == 3 ? toNumber(parts[2]) : std::nullopt;
    const auto counted = time.counters.find("size");
    if (!named || *named <= 0.0) continue;
    auto found = std::find_if(all.begin(), all.end(), [&](const GrowthSeries& series) {
      return series.quantity == parts[0] && series.who == parts[1];
    });
    if (found == all.end()) found = all.insert(all.end(), {parts[0], parts[1], {}, {}});
    const bool exact = counted != time.counters.end() && counted->second > 0.0;
    found->points.emplace_back(exact ? counted->second : *named, time.seconds);
  }
  for (GrowthSeries& series : all) series.exponent = fittedExponent(series.points);
  return all;
}

}  // namespace glissade
