#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace glissade {

/// Shares of a whole (>= 0, of any sum) as whole percentages with the sum 100: the largest remainders are rounded up.
/// All are 0 if the sum of the shares is 0.
template <std::size_t N>
std::array<int, N> wholePercents(const std::array<double, N>& shares) {
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::array<int, N> percents{};
  if (!(sum > 0.0)) return percents;
  std::array<std::size_t, N> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto exact = [&](std::size_t i) { return 100.0 * shares[i] / sum; };
  for (std::size_t i = 0; i < N; ++i) percents[i] = static_cast<int>(std::floor(exact(i)));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return exact(a) - percents[a] > exact(b) - percents[b]; });
  const int rest = 100 - std::accumulate(percents.begin(), percents.end(), 0);
  for (int i = 0; i < rest; ++i) ++percents[order[static_cast<std::size_t>(i)]];
  return percents;
}

}  // namespace glissade
