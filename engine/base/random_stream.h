#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace glissade {

/// A seeded stream of random numbers that is the same on every machine and library: xoshiro256**
/// (Blackman and Vigna 2018) with our own conversions, because the standard distributions differ
/// between implementations. Each use of randomness has a stream of its own, by name, so that
/// drawing more for one use does not shift the numbers of another.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);

  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high);
  /// Standard normal (Box-Muller, one draw of a pair).
  double normal();
  /// Exponential with the given rate (> 0), in the inverse unit of the rate.
  double exponential(double rate);

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace glissade
