#include "engine/base/in_threads.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/base/reserve_filled.h"

namespace glissade {
namespace {

TEST(InThreads, EachNumberIsTakenOnce) {
  for (const std::size_t count : {0U, 1U, 99U, 100U, 101U, 1234U}) {
    std::vector<int> taken(count + 1, 0);
    forEachInThreads(count, 100, [&taken](std::size_t i) { ++taken[i]; });
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(taken[i], 1) << i << " of " << count;
    EXPECT_EQ(taken[count], 0);
  }
}

TEST(ReserveFilled, KeepsWhatIsThereAndHasRoom) {
  constexpr std::size_t kLarge = 3'000'000;
  std::vector<int> numbers{1, 2, 3};
  reserveFilled(numbers, kLarge);
  EXPECT_GE(numbers.capacity(), kLarge);
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3}));
  const int* before = numbers.data();
  reserveFilled(numbers, 10);
  numbers.resize(kLarge, 7);
  EXPECT_EQ(numbers.data(), before);
  EXPECT_EQ(numbers.back(), 7);
}

}  // namespace
}  // namespace glissade
