#include "engine/base/thread_team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

#include "engine/base/cpu_time.h"

namespace glissade {
namespace {

TEST(ThreadTeam, DoesEveryJobOnceHoweverManyHelpThere) {
  for (const std::size_t helpers : {0U, 1U, 3U}) {
    ThreadTeam team(helpers);
    for (std::size_t count = 0; count < 200; ++count) {
      std::vector<int> done(count, 0);
      team.run(count, [&](std::size_t i) { ++done[i]; });
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), static_cast<int>(count));
    }
  }
}

TEST(ThreadTeam, HelpersWorkAtTheSameTimeAndTheirProcessorTimeIsKnown) {
  ThreadTeam team(1);
  if (team.threads() < 2) GTEST_SKIP() << "the system gives no more threads";
  std::atomic<int> present{0};
  team.run(2, [&](std::size_t) {
    ++present;
    while (present < 2) std::this_thread::yield();  // would not end on one thread
    const double before = threadCpuSeconds();
    while (threadCpuSeconds() - before < 0.002) {
    }
  });
  EXPECT_GE(team.helpersCpuSeconds(), 0.002);
}

TEST(ThreadTeam, TheFirstExceptionByNumberComesOutOnceAllHaveEnded) {
  ThreadTeam team(2);
  std::atomic<int> ended{0};
  const auto job = [&](std::size_t i) {
    ++ended;
    if (i % 2 == 1) throw std::runtime_error("job " + std::to_string(i));
  };
  for (int time = 0; time < 50; ++time) {
    ended = 0;
    try {
      team.run(6, job);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "job 1");
    }
    EXPECT_EQ(ended, 6);
  }
  team.run(1, [&](std::size_t) { ended = 100; });
  EXPECT_EQ(ended, 100);
}

}  // namespace
}  // namespace glissade
