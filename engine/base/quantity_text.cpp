#include "engine/base/quantity_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/base/length_units.h"
#include "engine/base/number_text.h"

namespace glissade {
namespace {

struct Unit {
  std::string_view name;
  double size;
};

/// Units of length. µ exists as a letter of its own and as the Greek letter.
constexpr std::array<Unit, 12> kLengths{{{"m", 1.0},
                                         {"cm", 1e-2},
                                         {"mm", 1e-3},
                                         {"um", 1e-6},
                                         {"\u00b5m", 1e-6},
                                         {"\u03bcm", 1e-6},
                                         {"in", kInch},
                                         {"inch", kInch},
                                         {"\"", kInch},
                                         {"\u2033", kInch},
                                         {"ft", kFoot},
                                         {"'", kFoot}}};
constexpr std::array<Unit, 3> kAngles{
    {{"deg", std::numbers::pi / 180.0}, {"\u00b0", std::numbers::pi / 180.0}, {"rad", 1.0}}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// `plain`: unit of a number without one.
template <std::size_t N>
std::optional<double> quantityOf(std::string_view text, const std::array<Unit, N>& units, double plain) {
  text = trimmed(text);
  if (const auto number = toNumber(text)) return *number * plain;
  for (const Unit& unit : units) {
    if (text.size() <= unit.name.size() || text.substr(text.size() - unit.name.size()) != unit.name) continue;
    const auto number = toNumber(trimmed(text.substr(0, text.size() - unit.name.size())));
    if (number) return *number * unit.size;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> toMetres(std::string_view text, double unit) { return quantityOf(text, kLengths, unit); }

std::optional<double> toRadians(std::string_view text, double unit) { return quantityOf(text, kAngles, unit); }

std::string inMillimetres(double metres) {
  constexpr int kSignificantDigits = 3;
  constexpr int kMostDecimals = 9;
  const double value = 1e3 * metres;
  const double size = std::abs(value);
  const bool hasDigits = size > 0.0 && std::isfinite(size);
  const int before = hasDigits ? static_cast<int>(std::floor(std::log10(size))) + 1 : kSignificantDigits;
  std::array<char, 400> text{};
  (void)std::snprintf(text.data(), text.size(), "%.*f", std::clamp(kSignificantDigits - before, 0, kMostDecimals),
                      value);
  std::string words = text.data();
  if (words.find('.') != std::string::npos) words.erase(words.find_last_not_of('0') + 1);
  if (words.back() == '.') words.pop_back();
  return words + " mm";
}

}  // namespace glissade
