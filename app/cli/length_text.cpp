#include "app/cli/length_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "engine/base/limits.h"
#include "engine/base/number_text.h"

namespace glissade::cli {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 7> kUnits{
    {{"", 1.0}, {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"inch", 0.0254}, {"ft", 0.3048}}};

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

double metres(const std::string& text) {
  const auto letters = std::find_if_not(text.rbegin(), text.rend(), isLetter).base();
  const std::string_view name(text.data() + (letters - text.begin()), static_cast<std::size_t>(text.end() - letters));
  std::string digits(text.begin(), letters);
  while (!digits.empty() && digits.back() == ' ') digits.pop_back();
  const auto number = toNumber(digits);
  const auto* unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& known) { return known.first == name; });
  if (!number || unit == kUnits.end()) {
    throw CLI::ValidationError("'" + text +
                               "' is not a length: give metres, or a unit as in 0.5mm (m, cm, mm, in, ft)");
  }
  if (!limits::isCoordinate(*number * unit->second)) {
    throw CLI::ValidationError("'" + text + "' is beyond 1e9 m: check the unit");
  }
  return *number * unit->second;
}

}  // namespace glissade::cli
