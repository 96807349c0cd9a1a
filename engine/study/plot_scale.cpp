#include "engine/study/plot_scale.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "engine/study/cell_value.h"

namespace glissade {
namespace {

constexpr double kSpanForLogarithms = 20.0;
constexpr double kZeroWidth = 0.1;
constexpr int kMostSteps = 6;
/// Least ratio of a logarithmic axis' bounds for ticks at powers of ten. Smaller parts have evenly spaced ticks.
constexpr double kSpanForPowers = 5.0;

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
  scale.kind_ = Kind::Logarithmic;
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

PlotScale PlotScale::categories(std::string title, const std::vector<std::string>& names) {
  PlotScale scale;
  scale.kind_ = Kind::Categories;
  scale.title_ = std::move(title);
  scale.low_ = -0.5;
  scale.high_ = static_cast<double>(names.size()) - 0.5;
  for (std::size_t i = 0; i < names.size(); ++i) {
    scale.ticks_.push_back({scale.position(static_cast<double>(i)), names[i]});
  }
  return scale;
}

double PlotScale::position(double value) const {
  if (kind_ != Kind::Logarithmic) return (value - low_) / (high_ - low_);
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
  const std::vector<PlotTick> powers = powerTicks(low_, high_);
  ticks_.insert(ticks_.end(), powers.begin(), powers.end());
}

/// Ticks between two logarithms.
std::vector<PlotTick> PlotScale::powerTicks(double low, double high) const {
  std::vector<PlotTick> ticks;
  const double decades = high - low;
  for (double power = std::floor(low + 1e-9); power <= high + 1e-9; power += 1.0) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double exponent = power + std::log10(digit);
      if (exponent < low - 1e-9 || exponent > high + 1e-9) continue;
      const bool labelled = digit == 1 || (decades < 3.1 && (digit == 2 || digit == 5));
      const double value = digit * std::pow(10.0, power);
      ticks.push_back({position(value), labelled ? shortNumber(value) : std::string()});
    }
  }
  return ticks;
}

/// Ticks between two values, with as many decimals as distinguish them.
std::vector<PlotTick> PlotScale::roundTicks(double low, double high) const {
  std::vector<PlotTick> ticks;
  const double step = roundStep((high - low) / kMostSteps);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i += 1.0) {
    const double value = i * step;
    std::ostringstream label;
    label.imbue(std::locale::classic());
    label << std::fixed << std::setprecision(decimals) << value;
    ticks.push_back({position(value), decimals == 0 ? shortNumber(value) : label.str()});
  }
  return ticks;
}

double PlotScale::valueAt(double position) const {
  const double along = std::clamp((position - zeroWidth_) / (1.0 - zeroWidth_), 0.0, 1.0);
  const double value = low_ + along * (high_ - low_);
  return kind_ == Kind::Logarithmic ? std::pow(10.0, value) : value;
}

std::vector<PlotTick> PlotScale::ticksWithin(double from, double to) const {
  const bool whole = from <= 0.0 && to >= 1.0;
  if (whole || kind_ == Kind::Categories) return ticks_;
  const double low = valueAt(from);
  const double high = valueAt(to);
  if (kind_ == Kind::Linear) return roundTicks(low, high);
  std::vector<PlotTick> ticks =
      high < kSpanForPowers * low ? roundTicks(low, high) : powerTicks(std::log10(low), std::log10(high));
  if (zeroWidth_ > 0.0 && from <= 0.0) ticks.insert(ticks.begin(), {0.0, "0"});
  return ticks;
}

}  // namespace glissade
