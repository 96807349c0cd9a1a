#include "engine/base/quantity_text.h"

#include <array>
#include <numbers>

#include "engine/base/number_text.h"

namespace glissade {
namespace {

struct Unit {
  std::string_view name;
  double size;
};

/// µ is a letter of its own or the Greek one.
constexpr std::array<Unit, 12> kLengths{{{"m", 1.0},
                                         {"cm", 1e-2},
                                         {"mm", 1e-3},
                                         {"um", 1e-6},
                                         {"\u00b5m", 1e-6},
                                         {"\u03bcm", 1e-6},
                                         {"in", 0.0254},
                                         {"inch", 0.0254},
                                         {"\"", 0.0254},
                                         {"\u2033", 0.0254},
                                         {"ft", 0.3048},
                                         {"'", 0.3048}}};
constexpr std::array<Unit, 3> kAngles{
    {{"deg", std::numbers::pi / 180.0}, {"\u00b0", std::numbers::pi / 180.0}, {"rad", 1.0}}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// `plain`: the size of a number without a unit.
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

}  // namespace glissade
