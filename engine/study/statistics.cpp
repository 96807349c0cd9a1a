#include "engine/study/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glissade {
namespace {

/// Quantile p of an ascending, non-empty sample.
double quantile(const std::vector<double>& ascending, double p) {
  const double rank = p * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double part = rank - static_cast<double>(below);
  return ascending[below] + part * (ascending[above] - ascending[below]);
}

}  // namespace

Proportion wilson95(std::size_t successes, std::size_t trials) {
  if (trials == 0) return {};
  constexpr double z = 1.959963984540054;  // 97.5 % quantile of the normal distribution
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const double scale = 1.0 + z * z / n;
  const double centre = (share + z * z / (2.0 * n)) / scale;
  const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n)) / scale;
  return {share, successes == 0 ? 0.0 : centre - half, successes == trials ? 1.0 : centre + half};
}

Distribution distributionOf(std::vector<double> sample) {
  if (sample.empty()) return {};
  std::sort(sample.begin(), sample.end());
  const double sum = std::accumulate(sample.begin(), sample.end(), 0.0);
  return {sample.size(),
          sample.front(),
          quantile(sample, 0.25),
          quantile(sample, 0.5),
          quantile(sample, 0.75),
          sample.back(),
          sum / static_cast<double>(sample.size())};
}

}  // namespace glissade
