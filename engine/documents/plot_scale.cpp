#include "engine/documents/plot_scale.h"

#include <algorithm>
#include <cmath>

#include "engine/documents/short_number.h"

namespace glissade {
namespace {

constexpr double kSpanForLogarithms = 20.0;
constexpr double kZeroWidth = 0.1;
constexpr int kMostSteps = 6;
/// Most decades of an axis whose ticks at 2 and 5 times a power of ten have labels.
constexpr double kDecadesWithMinorLabels = 3.1;

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `least`.
double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least * (1.0 - 1e-9)) return digit * power;
  }
  return 10.0 * power;
}

double roundBound(double value, bool up) {
  const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  double below = power;
  for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
    const double bound = digit * power;
    if (up && bound >= value * (1.0 - 1e-9)) return bound;
    if (!up && bound <= value * (1.0 + 1e-9)) below = bound;
  }
  return below;
}

std::vector<double> positive(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !(v > 0.0); }), values.end());
  return values;
}

}  // namespace

PlotScale PlotScale::linear(std::string title, const std::vector<double>& values) {
  PlotScale scale;
  scale.title_ = std::move(title);
  if (!values.empty()) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    scale.low_ = std::min(0.0, *least);
    scale.high_ = std::max(*most, scale.low_ + 1e-9);
  }
  scale.markLinear();
  return scale;
}

PlotScale PlotScale::percentages(std::string title) { return linear(std::move(title), {0.0, 100.0}); }

PlotScale PlotScale::logarithmic(std::string title, const std::vector<double>& values) {
  PlotScale scale;
  scale.isLogarithmic_ = true;
  scale.title_ = std::move(title);
  const std::vector<double> known = positive(values);
  const bool hasZero = known.size() < values.size();
  const double least = known.empty() ? 1.0 : *std::min_element(known.begin(), known.end());
  const double most = known.empty() ? 10.0 : *std::max_element(known.begin(), known.end());
  scale.low_ = std::log10(roundBound(least, false));
  scale.high_ = std::max(std::log10(roundBound(most, true)), scale.low_ + 0.3);
  if (hasZero) scale.zeroWidth_ = kZeroWidth;
  scale.markLogarithmic();
  return scale;
}

PlotScale PlotScale::fitting(std::string title, const std::vector<double>& values) {
  const std::vector<double> known = positive(values);
  if (known.empty()) return linear(std::move(title), values);
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  return *most > kSpanForLogarithms * *least ? logarithmic(std::move(title), values) : linear(std::move(title), values);
}

double PlotScale::position(double value) const {
  if (!isLogarithmic_) return (value - low_) / (high_ - low_);
  if (!(value > 0.0)) return 0.0;
  return zeroWidth_ + (1.0 - zeroWidth_) * std::max(0.0, (std::log10(value) - low_) / (high_ - low_));
}

void PlotScale::markLinear() {
  const double step = roundStep((high_ - low_) / kMostSteps);
  const double first = std::floor(low_ / step + 1e-9);
  const double last = std::ceil(high_ / step - 1e-9);
  low_ = first * step;
  high_ = last * step;
  for (double i = first; i <= last; i += 1.0) ticks_.push_back({position(i * step), shortNumber(i * step)});
}

void PlotScale::markLogarithmic() {
  if (zeroWidth_ > 0.0) ticks_.push_back({0.0, "0"});
  const bool minorLabels = high_ - low_ < kDecadesWithMinorLabels;
  for (double power = std::floor(low_ + 1e-9); power <= high_ + 1e-9; power += 1.0) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double exponent = power + std::log10(digit);
      if (exponent < low_ - 1e-9 || exponent > high_ + 1e-9) continue;
      const bool labelled = digit == 1 || (minorLabels && (digit == 2 || digit == 5));
      const double value = digit * std::pow(10.0, power);
      ticks_.push_back({position(value), labelled ? shortNumber(value) : std::string()});
    }
  }
}

}  // namespace glissade
