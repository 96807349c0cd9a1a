#include "engine/base/child_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "engine/base/number_text.h"

namespace glissade {
namespace {

using testing::HasSubstr;

ChildCommand shell(const std::string& script, const ChildLimits& limits = {}) {
  ChildCommand command;
  command.program = "/bin/sh";
  command.arguments = {"-c", script};
  command.limits = limits;
  return command;
}

ChildEnd endOf(const ChildCommand& command, const StopToken& stop = {}) {
  auto end = runChild(command, stop);
  EXPECT_TRUE(end.ok()) << (end ? "" : toString(end.error()));
  return end ? *end : ChildEnd{};
}

ChildEnd endOf(const std::string& script, const ChildLimits& limits = {}) { return endOf(shell(script, limits)); }

ChildLimits seconds(double value) {
  ChildLimits limits;
  limits.seconds = value;
  return limits;
}

/// True if a process has ended: it is gone, or its new parent has not collected it yet.
bool hasEnded(pid_t pid) {
  const std::string file = "/proc/" + std::to_string(pid) + "/stat";
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return true;
  std::string text(400, '\0');
  const ssize_t count = ::read(fd, text.data(), text.size());
  ::close(fd);
  return count <= 0 || text.find(") Z ") != std::string::npos;
}

void expectEndOf(pid_t pid) {
  for (int i = 0; i < 500 && !hasEnded(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(hasEnded(pid)) << pid;
}

pid_t firstNumberOf(const std::string& text) {
  return static_cast<pid_t>(toNumber(text.substr(0, text.find('\n'))).value_or(0.0));
}

TEST(ChildProcess, GivesItsOutputAndItsExitCode) {
  const ChildEnd end = endOf("echo out; echo err >&2; read x; exit 7");
  EXPECT_EQ(end.output, "out\n");
  EXPECT_EQ(end.errors, "err\n");
  EXPECT_EQ(end.ending, ChildEnding::Exited);
  EXPECT_EQ(end.exitCode, 7);
  EXPECT_EQ(end.signal, 0);
  EXPECT_GT(end.peakMemoryMb, 0.1);
}

TEST(ChildProcess, ReadsTheGivenBytes) {
  std::string bytes(3'000'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  ChildCommand command = shell("exec cat");
  command.input = bytes;
  EXPECT_EQ(endOf(command).output, bytes);
}

TEST(ChildProcess, CannotChangeItsInput) {
  ChildCommand command = shell("echo x >&0");
  command.input = "unchanged";
  const ChildEnd end = endOf(command);
  EXPECT_TRUE(end.exitCode != 0 || end.signal != 0);
}

TEST(ChildProcess, PollDoesNotWait) {
  auto child = ChildProcess::start(shell("echo $$; exec sleep 1000"));
  ASSERT_TRUE(child.ok());
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(child->poll().has_value());
}

TEST(ChildProcess, CountsProcessorTimeAndNotTheWaiting) {
  // The clock starts when the child runs, so that its own time may be a little longer.
  const ChildEnd waiting = endOf("sleep 0.2");
  EXPECT_GT(waiting.wallSeconds, 0.1);
  EXPECT_LT(waiting.cpuSeconds, waiting.wallSeconds);
  const ChildEnd working = endOf("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done");
  EXPECT_GT(working.cpuSeconds, waiting.cpuSeconds);
}

TEST(ChildProcess, MuchOutputOnBothStreamsDoesNotBlockIt) {
  const ChildEnd end = endOf("head -c 3000000 /dev/zero >&2; head -c 3000000 /dev/zero; exit 3");
  EXPECT_EQ(end.output.size(), 3'000'000U);
  EXPECT_EQ(end.errors.size(), std::size_t{1} << 20U);
  EXPECT_EQ(end.exitCode, 3);
}

TEST(ChildProcess, EndlessOutputEndsAtItsLimit) {
  ChildLimits limits;
  limits.outputBytes = 1'000'000;
  const ChildEnd end = endOf("exec cat /dev/zero", limits);
  EXPECT_EQ(end.ending, ChildEnding::OutputTooLarge);
  EXPECT_EQ(end.output.size(), limits.outputBytes);
}

TEST(ChildProcess, EndlessErrorsEndAtTheTimeLimit) {
  const ChildEnd end = endOf("exec cat /dev/zero >&2", seconds(0.2));
  EXPECT_EQ(end.ending, ChildEnding::TimeOver);
  EXPECT_EQ(end.errors.size(), std::size_t{1} << 20U);
}

TEST(ChildProcess, OneThatClosesItsOutputAndStaysIsKilledAtTheTimeLimit) {
  const ChildEnd end = endOf("exec >&- 2>&- <&-; exec sleep 1000", seconds(0.2));
  EXPECT_EQ(end.ending, ChildEnding::TimeOver);
  EXPECT_EQ(end.signal, SIGKILL);
  EXPECT_LT(end.wallSeconds, 100.0);
}

TEST(ChildProcess, OneThatIgnoresSigtermIsKilledAtTheTimeLimit) {
  const ChildEnd end = endOf("trap '' TERM INT HUP; while true; do sleep 0.01; done", seconds(0.2));
  EXPECT_EQ(end.ending, ChildEnding::TimeOver);
  EXPECT_EQ(end.signal, SIGKILL);
}

TEST(ChildProcess, IsKilledAtTheTimeLimitWithAllThatItStarted) {
  const ChildEnd end = endOf("sleep 1000 & echo $!; wait", seconds(0.2));
  EXPECT_EQ(end.ending, ChildEnding::TimeOver);
  ASSERT_GT(firstNumberOf(end.output), 0);
  expectEndOf(firstNumberOf(end.output));
}

TEST(ChildProcess, WhatItLeavesRunningIsKilledAtItsEnd) {
  const ChildEnd end = endOf("sleep 1000 & echo $!; exit 0");
  EXPECT_EQ(end.ending, ChildEnding::Exited);
  ASSERT_GT(firstNumberOf(end.output), 0);
  expectEndOf(firstNumberOf(end.output));
}

TEST(ChildProcess, AGrandchildInItsOwnSessionDoesNotHoldTheParent) {
  const ChildEnd end = endOf("setsid sleep 3 & exit 4", seconds(100.0));
  EXPECT_EQ(end.exitCode, 4);
  EXPECT_LT(end.wallSeconds, 2.9);
}

TEST(ChildProcess, ReportsTheSignalOfACrash) {
  const ChildEnd end = endOf("kill -SEGV $$");
  EXPECT_EQ(end.ending, ChildEnding::Signalled);
  EXPECT_EQ(end.signal, SIGSEGV);
}

TEST(ChildProcess, StopsWhenAsked) {
  const auto soon = StopToken::Clock::now() + std::chrono::milliseconds(50);
  EXPECT_EQ(endOf(shell("exec sleep 1000"), StopToken().withDeadline(soon)).ending, ChildEnding::Stopped);
}

TEST(ChildProcess, HasItsLimits) {
  ChildLimits limits;
  limits.cpuSeconds = 7;
  limits.memoryBytes = 100U << 20U;
  const std::string memory = kMemoryCanBeLimited ? "102400\n" : "unlimited\n";
  EXPECT_EQ(endOf("ulimit -v; ulimit -t; ulimit -c", limits).output, memory + "7\n0\n");
}

/// The input is a file in memory, because a limit would also apply to files of its own children.
TEST(ChildProcess, MayWriteFiles) { EXPECT_EQ(endOf("ulimit -f").output, "unlimited\n"); }

TEST(ChildProcess, ProcessorTimeEndsWithSigxcpu) {
  ChildLimits limits;
  limits.cpuSeconds = 1;
  EXPECT_EQ(endOf("while true; do :; done", limits).signal, SIGXCPU);
}

TEST(ChildProcess, HasNoEnvironmentButItsOwn) {
  ChildCommand command;
  command.program = "/usr/bin/env";
  EXPECT_EQ(endOf(command).output, "");
  command.environment = {"A=1", "B=two words"};
  EXPECT_EQ(endOf(command).output, "A=1\nB=two words\n");
}

TEST(ChildProcess, InheritsNoDescriptor) {
  const int open = ::open("/dev/null", O_RDONLY);  // without O_CLOEXEC
  ASSERT_GE(open, 0);
  ChildCommand command;
  command.program = "/bin/ls";
  command.arguments = {"/proc/self/fd"};
  EXPECT_EQ(endOf(command).output, "0\n1\n2\n3\n");  // 3 is the folder that ls reads
  ::close(open);
}

TEST(ChildProcess, IgnoresNoSignalThatThisProcessIgnores) {
  const auto before = std::signal(SIGTERM, SIG_IGN);
  const ChildEnd end = endOf("kill -TERM $$; exit 0");
  std::signal(SIGTERM, before);
  EXPECT_EQ(end.signal, SIGTERM);
}

TEST(ChildProcess, IsInASessionOfItsOwn) {
  const std::string sessionAndGroup = endOf(
                                          "read -r pid name state parent group session rest < /proc/self/stat; "
                                          "test $group = $$ && test $session = $$ && echo own")
                                          .output;
  EXPECT_EQ(sessionAndGroup, "own\n");
}

TEST(ChildProcess, EndsWithItsObject) {
  pid_t pid = 0;
  {
    auto child = ChildProcess::start(shell("sleep 1000 & echo $!; wait"));
    ASSERT_TRUE(child.ok());
    const auto end = child->wait(StopToken().withDeadline(StopToken::Clock::now() + std::chrono::milliseconds(100)));
    pid = firstNumberOf(end.output);
    auto other = ChildProcess::start(shell("exec sleep 1000"));
    ASSERT_TRUE(other.ok());
  }
  ASSERT_GT(pid, 0);
  expectEndOf(pid);
}

TEST(ChildProcess, DiesWithItsParent) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    auto child = ChildProcess::start(shell("echo $$; exec sleep 1000"));
    const pid_t pid = child ? child->pid() : 0;
    [[maybe_unused]] const ssize_t written = ::write(pipe[1], &pid, sizeof pid);
    ::kill(::getpid(), SIGKILL);
  }
  pid_t child = 0;
  ASSERT_EQ(::read(pipe[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
  ASSERT_GT(child, 0);
  ::waitpid(parent, nullptr, 0);
  expectEndOf(child);
  ::close(pipe[0]);
  ::close(pipe[1]);
}

TEST(ChildProcess, AProgramThatCannotBeRunIsAnError) {
  for (const char* program : {"/nowhere/program", "/", "/etc/passwd"}) {
    ChildCommand command;
    command.program = program;
    const auto end = runChild(command);
    ASSERT_FALSE(end.ok()) << program;
    EXPECT_EQ(end.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(end.error().file, program);
    EXPECT_THAT(toString(end.error().reason), HasSubstr("cannot be started: its file cannot be run: "));
    EXPECT_FALSE(end.error().advice.empty());
  }
}

TEST(ChildProcess, WorksWhereTheStandardStreamsAreClosed) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(fd);
    ChildCommand command = shell("cat; echo err >&2");
    command.input = "in";
    const auto end = runChild(command);
    ::_exit(end && end->output == "in" && end->errors == "err\n" ? 0 : 1);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace glissade
