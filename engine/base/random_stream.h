#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace glissade {

/// A seeded stream of random numbers that is the same on every machine and library: xoshiro256** (Blackman and Vigna
/// 2018) with our own conversions, because the standard distributions differ between implementations. Each use of
/// randomness has its own named stream, so that more draws for one use do not change the numbers of another.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);

  std::uint64_t bits();
  /// A number uniformly distributed in [0, 1).
  double uniform();
  /// A number uniformly distributed in [low, high).
  double uniform(double low, double high);
  /// A standard normal number (Box-Muller, one of each pair).
  double normal();
  /// An exponentially distributed number with the given rate (> 0), in the inverse unit of the rate.
  double exponential(double rate);

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace glissade
