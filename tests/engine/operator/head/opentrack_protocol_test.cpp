#include "engine/operator/head/opentrack_protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace glissade {
namespace {

std::vector<std::byte> datagramOf(const std::array<double, 6>& numbers) {
  std::vector<std::byte> datagram(kOpentrackBytes);
  std::memcpy(datagram.data(), numbers.data(), kOpentrackBytes);
  return datagram;
}

TEST(OpentrackProtocol, ReadsCentimetresAndDegrees) {
  const auto reading = parseOpentrack(datagramOf({10.0, -20.0, 65.0, 90.0, -45.0, 180.0}));
  ASSERT_TRUE(reading);
  EXPECT_DOUBLE_EQ((*reading)[0], 0.1);
  EXPECT_DOUBLE_EQ((*reading)[1], -0.2);
  EXPECT_DOUBLE_EQ((*reading)[2], 0.65);
  EXPECT_DOUBLE_EQ((*reading)[3], std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ((*reading)[4], -std::numbers::pi / 4.0);
  EXPECT_DOUBLE_EQ((*reading)[5], std::numbers::pi);
}

TEST(OpentrackProtocol, DropsOtherSizes) {
  const std::vector<std::byte> zeros(2 * kOpentrackBytes);
  for (std::size_t size = 0; size <= zeros.size(); ++size) {
    EXPECT_EQ(parseOpentrack(std::span(zeros).first(size)).has_value(), size == kOpentrackBytes) << size;
  }
}

TEST(OpentrackProtocol, DropsWhatIsNoPlaceOfAHead) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double number : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300, 1001.0}) {
    for (std::size_t i = 0; i < 6; ++i) {
      std::array<double, 6> numbers{};
      numbers[i] = number;
      EXPECT_FALSE(parseOpentrack(datagramOf(numbers))) << number << " as number " << i;
    }
  }
}

/// GLISSADE_HEAD_DATAGRAMS sets another number of datagrams.
TEST(OpentrackProtocol, OfRandomBytesOnlyPlacesOfAHeadAreTaken) {
  const char* asked = std::getenv("GLISSADE_HEAD_DATAGRAMS");
  const long count = asked != nullptr ? std::atol(asked) : 100'000;
  std::mt19937_64 random(34);
  long taken = 0;
  for (long i = 0; i < count; ++i) {
    // Half of the datagrams have the right size; half of these have exponents of plausible numbers.
    const bool rightSize = i % 2 == 0;
    std::vector<std::byte> datagram(rightSize ? kOpentrackBytes : random() % 1500);
    for (std::byte& byte : datagram) byte = static_cast<std::byte>(random());
    if (rightSize && i % 4 == 0) {
      for (std::size_t number = 0; number < 6; ++number) {
        datagram[8 * number + 7] = static_cast<std::byte>(0x40 | (random() & 0x80));
        datagram[8 * number + 6] &= static_cast<std::byte>(0x7f);
      }
    }
    const auto reading = parseOpentrack(datagram);
    if (!reading) continue;
    ++taken;
    ASSERT_EQ(datagram.size(), kOpentrackBytes);
    for (const double number : *reading) ASSERT_LE(std::abs(number), 10.0);
  }
  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, count / 2);
}

}  // namespace
}  // namespace glissade
