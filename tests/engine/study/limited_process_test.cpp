#include "engine/study/limited_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <thread>

#include "engine/base/number_text.h"

namespace glissade {
namespace {

using testing::HasSubstr;

ProcessEnd endOf(const std::string& script, const ProcessLimits& limits = {}) {
  auto process = LimitedProcess::start("/bin/sh", {"-c", script}, limits);
  EXPECT_TRUE(process.ok());
  while (true) {
    if (auto end = (*process)->poll()) return *end;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

bool isGone(pid_t pid) { return ::kill(pid, 0) != 0; }

void expectGoneSoon(pid_t pid) {
  for (int i = 0; i < 500 && !isGone(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(isGone(pid));
}

TEST(LimitedProcess, GivesWhatItSaidAndHowItEnded) {
  const ProcessEnd end = endOf("echo out; echo err >&2; read x; exit 7");
  EXPECT_EQ(end.output, "out\n");
  EXPECT_EQ(end.errors, "err\n");
  EXPECT_EQ(end.exitCode, 7);
  EXPECT_EQ(end.signal, 0);
  EXPECT_FALSE(end.killed);
  EXPECT_GT(end.peakMemoryMb, 0.1);
}

TEST(LimitedProcess, CountsTheProcessorsTimeAndNotTheWaiting) {
  const ProcessEnd waiting = endOf("sleep 0.3");
  EXPECT_GE(waiting.wallSeconds, 0.3);
  EXPECT_LT(waiting.cpuSeconds, waiting.wallSeconds);
  const ProcessEnd working = endOf("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done");
  EXPECT_GT(working.cpuSeconds, waiting.cpuSeconds);
}

TEST(LimitedProcess, MuchOutputDoesNotBlockIt) {
  const ProcessEnd end = endOf("head -c 3000000 /dev/zero; exit 3");
  EXPECT_EQ(end.output.size(), 3'000'000U);
  EXPECT_EQ(end.exitCode, 3);
}

TEST(LimitedProcess, TellsTheSignalOfACrash) { EXPECT_EQ(endOf("kill -SEGV $$").signal, SIGSEGV); }

TEST(LimitedProcess, IsKilledOverItsTimeWithAllThatItStarted) {
  const ProcessEnd end = endOf("sleep 1000 & echo $!; wait", {0.2, 0});
  EXPECT_TRUE(end.killed);
  EXPECT_EQ(end.signal, SIGKILL);
  const auto grandchild = toNumber(end.output.substr(0, end.output.find('\n')));
  ASSERT_TRUE(grandchild.has_value());
  expectGoneSoon(static_cast<pid_t>(*grandchild));
}

TEST(LimitedProcess, HasItsMemoryLimit) {
  if (!kMemoryCanBeLimited) GTEST_SKIP() << "not under this sanitizer";
  EXPECT_EQ(endOf("ulimit -v", {0.0, 100}).output, "102400\n");
}

TEST(LimitedProcess, DiesWithItsObject) {
  auto process = LimitedProcess::start("/bin/sh", {"-c", "exec sleep 1000"}, {});
  ASSERT_TRUE(process.ok());
  process->reset();  // would wait for ever if it did not kill
}

TEST(LimitedProcess, AProgramThatIsNotThereEndsAtOnce) {
  auto process = LimitedProcess::start("/nowhere/program", {}, {});
  ASSERT_TRUE(process.ok());
  std::optional<ProcessEnd> end;
  while (!end) end = (*process)->poll();
  EXPECT_EQ(end->exitCode, 127);
}

}  // namespace
}  // namespace glissade
