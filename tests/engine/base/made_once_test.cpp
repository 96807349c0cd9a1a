#include "engine/base/made_once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace glissade {
namespace {

TEST(MadeOnce, ManyThreadsAskAndOneMakes) {
  constexpr int kThreads = 8;
  constexpr int kKeys = 50;
  MadeOnce<int, int> values;
  std::atomic<int> made = 0;
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&] {
      for (int key = 0; key < kKeys; ++key) {
        const int value = values.get(key, {}, [&] {
          ++made;
          std::this_thread::yield();
          return 2 * key;
        });
        if (value != 2 * key) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, kKeys);
  EXPECT_EQ(wrong, 0);
}

TEST(MadeOnce, AValueOfAStoppedWorkIsNotKept) {
  MadeOnce<int, int> values;
  StopSource source;
  source.requestStop();
  EXPECT_EQ(values.get(1, source.token(), [] { return 10; }), 10);
  EXPECT_EQ(values.get(1, {}, [] { return 20; }), 20);
  EXPECT_EQ(values.get(1, {}, [] { return 30; }), 20);
}

TEST(MadeOnce, AfterAnExceptionTheNextThreadMakesTheValue) {
  MadeOnce<int, int> values;
  EXPECT_THROW(values.get(1, {}, []() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(values.get(1, {}, [] { return 20; }), 20);
}

}  // namespace
}  // namespace glissade
