#include "engine/study/benchmarks/benchmark_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/study/benchmark_samples.h"

namespace glissade {
namespace {

using testing::HasSubstr;

TEST(BenchmarkResults, HaveContextAndTimesInSeconds) {
  const auto run = readBenchmarks(test::kCollisionBenchmarks, "collision.json");
  ASSERT_TRUE(run.ok()) << toString(run.error());
  EXPECT_EQ(run->context.at("commit"), "abc123");
  EXPECT_EQ(run->context.count("num_cpus"), 0U);
  ASSERT_EQ(run->times.size(), 7U);
  EXPECT_EQ(run->times[0].name, "collide/L/near/fcl");
  EXPECT_DOUBLE_EQ(run->times[0].seconds, 8e-6) << "of the processor";
  EXPECT_DOUBLE_EQ(run->times[2].seconds, 9e-6);
}

TEST(BenchmarkResults, PairWhatBothBackendsWereAsked) {
  const auto run = readBenchmarks(test::kCollisionBenchmarks, "collision.json");
  ASSERT_TRUE(run.ok());
  const auto times = backendTimes(run->times);
  ASSERT_EQ(times.size(), 3U) << "the edge was asked of one only";
  EXPECT_EQ(times[0].question, "collide");
  EXPECT_EQ(times[0].place, "L/near");
  EXPECT_DOUBLE_EQ(times[0].ratio(), 40.0);
  EXPECT_NEAR(times[1].ratio(), 90.0, 1e-9);
  EXPECT_NEAR(geometricMean(times, "collide"), 60.0, 1e-9);
  EXPECT_NEAR(geometricMean(times, "distance"), 10.0, 1e-9);
}

TEST(BenchmarkResults, GrowthIsFittedToWhatWasMeasured) {
  const auto run = readBenchmarks(test::kGrowthBenchmarks, "growth.json");
  ASSERT_TRUE(run.ok()) << toString(run.error());
  const auto series = growthSeries(run->times);
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].quantity, "iteration");
  EXPECT_EQ(series[0].who, "RRT");
  ASSERT_EQ(series[0].points.size(), 2U);
  EXPECT_DOUBLE_EQ(series[0].points[0].second, 1e-5) << "the program's own clock";
  ASSERT_TRUE(series[0].exponent.has_value());
  EXPECT_NEAR(*series[0].exponent, 1.0, 1e-9);
  ASSERT_EQ(series[1].points.size(), 1U) << "neither failures nor aggregates";
  EXPECT_EQ(series[1].points[0].first, 128.0) << "the exact size";
  EXPECT_FALSE(series[1].exponent.has_value());
}

TEST(BenchmarkResults, EachFaultIsNamedWithItsPlace) {
  const std::string time = R"("name": "a/b/10", "real_time": 1, "time_unit": "ns")";
  const std::string begin = R"({"context": {}, "benchmarks": [{)";
  const std::pair<std::string, std::string> rows[] = {
      {"", ""},
      {"[]", "/"},
      {"{}", "/context"},
      {R"({"context": 1, "benchmarks": []})", "/context"},
      {R"({"context": {}})", "/benchmarks"},
      {R"({"context": {}, "benchmarks": {}})", "/benchmarks"},
      {R"({"context": {}, "benchmarks": [1]})", "/benchmarks/0"},
      {begin + R"("cpu_time": 1}]})", "/benchmarks/0/name"},
      {begin + R"("name": "", "cpu_time": 1}]})", "/benchmarks/0/name"},
      {begin + time + "}]}", "/benchmarks/0/cpu_time"},
      {begin + time + R"(, "cpu_time": "1"}]})", "/benchmarks/0/cpu_time"},
      {begin + time + R"(, "cpu_time": 0}]})", "/benchmarks/0/cpu_time"},
      {begin + time + R"(, "cpu_time": -1}]})", "/benchmarks/0/cpu_time"},
      {begin + R"("name": "a", "cpu_time": 1, "time_unit": "days"}]})", "/benchmarks/0/time_unit"},
      {begin + R"("name": "a", "cpu_time": 1}]})", "/benchmarks/0/time_unit"},
      {begin + time + R"(, "cpu_time": 1, "run_type": 5}]})", "/benchmarks/0/run_type"},
      {begin + time + R"(, "cpu_time": 1, "error_occurred": "no"}]})", "/benchmarks/0/error_occurred"},
  };
  for (const auto& [text, place] : rows) {
    SCOPED_TRACE(text);
    const auto run = readBenchmarks(text, "broken.json");
    ASSERT_FALSE(run.ok());
    EXPECT_EQ(run.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(run.error().file, "broken.json");
    EXPECT_THAT(toString(run.error().location), HasSubstr(place));
    EXPECT_EQ(run.error().location.empty(), place.empty());
    EXPECT_FALSE(run.error().reason.empty());
  }
}

TEST(BenchmarkResults, NamesThatSayNothingAreLeftOut) {
  const std::vector<BenchmarkTime> times{{"plain", 1.0, {}}, {"a/b", 1.0, {}},          {"a/b/c", 1.0, {}},
                                         {"a/b/0", 1.0, {}}, {"a/b/c/kernel", 1.0, {}}, {"/", 1.0, {}}};
  EXPECT_TRUE(growthSeries(times).empty());
  EXPECT_TRUE(backendTimes(times).empty());
}

}  // namespace
}  // namespace glissade
