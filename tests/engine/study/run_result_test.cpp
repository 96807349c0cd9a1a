#include "engine/study/run_result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <new>

#include "engine/base/guarded.h"

namespace glissade {
namespace {

constexpr const char* kSolved =
    R"({"solved": true, "status": "solved", "planning_s": 1.5, "planning_cpu_s": 1.25, "virtual_s": 20.25,
  "nodes": 100, "edges": 198, "iterations": 90, "steps": 110, "random_configurations": 12,
  "nodes_by_author": {"computer": 60, "operator": 30, "contact": 10},
  "path": {"configurations": 7, "length_m": 3.5, "rotation_rad": 1.25},
  "certificate": {"status": "certified", "min_clearance_m": 0.002, "tolerance_m": 1e-05}})";

ChildEnd saying(const std::string& output, int exitCode = 0) {
  ChildEnd end;
  end.output = output;
  end.exitCode = exitCode;
  end.wallSeconds = 2.5;
  end.cpuSeconds = 2.25;
  return end;
}

std::optional<double> numberOf(const RunResult& result, std::string_view column) {
  for (std::size_t i = 0; i < kResultColumnCount; ++i) {
    if (resultColumns()[i].name == column) return result.numbers[i];
  }
  ADD_FAILURE() << "no column " << column;
  return std::nullopt;
}

TEST(RunResult, ReadsTheReportOfARun) {
  const RunOutcome outcome = outcomeOf(saying(kSolved), 60.0);
  EXPECT_EQ(outcome.result.status, RunStatus::Solved);
  EXPECT_EQ(numberOf(outcome.result, "nodes"), 100.0);
  EXPECT_EQ(numberOf(outcome.result, "virtual_s"), 20.25);
  EXPECT_EQ(numberOf(outcome.result, "nodes_operator"), 30.0);
  EXPECT_EQ(numberOf(outcome.result, "min_clearance_m"), 0.002);
  EXPECT_EQ(numberOf(outcome.result, "path_length_m"), 3.5);
  EXPECT_EQ(numberOf(outcome.result, "coarse_configurations"), std::nullopt);
  EXPECT_EQ(numberOf(outcome.result, "sequence_steps"), std::nullopt);
  EXPECT_EQ(outcome.result.certificate, "certified");
  EXPECT_EQ(outcome.timing.planningSeconds, 1.5);
  EXPECT_EQ(outcome.timing.planningCpuSeconds, 1.25);
  EXPECT_EQ(outcome.timing.wallSeconds, 2.5);
  EXPECT_EQ(outcome.timing.cpuSeconds, 2.25);
}

/// The message of a session without memory.
std::string outOfMemory() {
  return toString(guarded(GLISSADE_TEXT("planning"), [] { throw std::bad_alloc(); })->reason);
}

TEST(RunResult, ReadsTheReportOfASequence) {
  const auto plan = [](const std::string& end) {
    return saying(R"({"format": "glissade-plan", "parts": 5, "removed": 3, "steps": [1, 2], "end": ")" + end +
                  R"(", "certified": true, "wall_s": 1.75})");
  };
  const RunOutcome outcome = outcomeOf(plan("stuck"), 60.0);
  EXPECT_EQ(outcome.result.status, RunStatus::NoPath);
  EXPECT_EQ(outcome.result.certificate, "certified");
  EXPECT_EQ(numberOf(outcome.result, "parts"), 5.0);
  EXPECT_EQ(numberOf(outcome.result, "parts_removed"), 3.0);
  EXPECT_EQ(numberOf(outcome.result, "sequence_steps"), 2.0);
  EXPECT_EQ(numberOf(outcome.result, "steps"), std::nullopt) << "those of a planner";
  EXPECT_EQ(outcome.timing.planningSeconds, 1.75);
  EXPECT_EQ(outcomeOf(plan("complete"), 60.0).result.status, RunStatus::Solved);
  EXPECT_EQ(outcomeOf(plan("time_limit"), 60.0).result.status, RunStatus::Time);
}

TEST(RunResult, TellsTheWaysToEndApart) {
  const auto status = [](const ChildEnd& end) { return outcomeOf(end, 60.0).result.status; };
  const auto report = [](const std::string& said, const std::string& reason, double seconds) {
    return R"({"status": ")" + said + R"(", "planning_s": )" + std::to_string(seconds) +
           R"(, "path": null, "certificate": null, "error": {"reason": ")" + reason + "\"}}";
  };
  EXPECT_EQ(status(saying(report("limit-reached", "the step limit", 3.0), 5)), RunStatus::LimitReached);
  EXPECT_EQ(status(saying(report("limit-reached", "the time limit", 60.01), 5)), RunStatus::Time);
  EXPECT_EQ(status(saying(report("no-path", "no way", 3.0), 1)), RunStatus::NoPath);
  EXPECT_EQ(status(saying(report("not-certified", "it touches", 3.0), 1)), RunStatus::NotCertified);
  EXPECT_EQ(status(saying(report("in-collision", "start", 0.0), 4)), RunStatus::InCollision);
  EXPECT_EQ(status(saying(report("limit-reached", outOfMemory(), 3.0), 5)), RunStatus::Memory);
  EXPECT_EQ(status(saying(report("error", "the planner failed: x", 3.0), 70)), RunStatus::Error);
  EXPECT_EQ(status(saying(R"({"error": {"reason": "cannot be opened"}})", 3)), RunStatus::Error);
  EXPECT_EQ(status(saying("", 70)), RunStatus::Crashed);
  EXPECT_EQ(status(saying("{\"status\": \"sol", 0)), RunStatus::Crashed);
  EXPECT_EQ(status(saying("[1]", 0)), RunStatus::Crashed);
  EXPECT_EQ(status(saying(R"({"status": "interrupted"})", 130)), RunStatus::Crashed);
  ChildEnd crashed = saying("");
  crashed.signal = SIGSEGV;
  EXPECT_EQ(status(crashed), RunStatus::Crashed);
  crashed.errors = "terminate called after throwing an instance of 'std::bad_alloc'";
  EXPECT_EQ(status(crashed), RunStatus::Memory);
  ChildEnd full = saying("", 5);
  full.errors = "glissade-cli: out of memory\n";
  EXPECT_EQ(status(full), RunStatus::Memory);
  full.errors = "glissade-cli: out of memory.json: cannot be opened\n";
  EXPECT_EQ(status(full), RunStatus::Crashed);
  ChildEnd killed = saying("");
  killed.ending = ChildEnding::TimeOver;
  killed.signal = SIGKILL;
  EXPECT_EQ(status(killed), RunStatus::Time);
}

TEST(RunResult, FilesReadBackAsTheyWere) {
  RunRow row{"hash", 3, 18446744073709551615ULL, outcomeOf(saying(kSolved), 60.0)};
  row.outcome.result.message = "two \"words\", a comma";
  const auto back = readRunRow(writeRunRow(row), "run.json");
  ASSERT_TRUE(back.ok()) << toString(back.error());
  EXPECT_EQ(back->plan, "hash");
  EXPECT_EQ(back->cell, 3U);
  EXPECT_EQ(back->seed, row.seed);
  EXPECT_EQ(back->outcome.result, row.outcome.result);
  EXPECT_EQ(back->outcome.timing.planningSeconds, 1.5);
}

TEST(RunResult, TornFilesAreRefused) {
  const std::string whole = writeRunRow({"hash", 1, 1, outcomeOf(saying(kSolved), 60.0)});
  for (std::size_t length = 0; length + 2 < whole.size(); length += 5) {
    EXPECT_FALSE(readRunRow(whole.substr(0, length), "run.json").ok()) << length;
  }
}

TEST(RunRow, OlderRowsWithoutProcessorTimesStayReadable) {
  auto older = nlohmann::json::parse(writeRunRow({"plan", 1, 7, {}}));
  older["timing"].erase("cpu_s");
  older["timing"].erase("planning_cpu_s");
  const auto row = readRunRow(older.dump(), "run.json");
  ASSERT_TRUE(row.ok()) << toString(row.error());
  EXPECT_EQ(row->seed, 7U);
  EXPECT_FALSE(row->outcome.timing.cpuSeconds.has_value());
  EXPECT_FALSE(row->outcome.timing.planningCpuSeconds.has_value());
}

}  // namespace
}  // namespace glissade
