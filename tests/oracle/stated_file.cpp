#include "tests/oracle/stated_file.h"

#include <algorithm>

namespace glissade::oracle {
namespace {

constexpr double kFarthest = 1e9;
constexpr double kUnit = 1e-3;

template <std::size_t N>
std::optional<std::array<double, N>> numbers(const nlohmann::json& list) {
  if (!list.is_array() || list.size() != N) return std::nullopt;
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!list[i].is_number()) return std::nullopt;
    values[i] = list[i].get<double>();
    if (!(std::abs(values[i]) <= kFarthest)) return std::nullopt;
  }
  return values;
}

}  // namespace

std::optional<std::vector<Placement>> statedPoses(const nlohmann::json& poses) {
  std::vector<Placement> path;
  for (const nlohmann::json& pose : poses) {
    const auto position = numbers<3>(pose.at("position"));
    const auto turn = numbers<4>(pose.at("orientation"));
    if (!position || !turn) return std::nullopt;
    double squared = 0.0;
    for (const double component : *turn) squared += component * component;
    if (std::abs(std::sqrt(squared) - 1.0) > kUnit) return std::nullopt;
    path.push_back({*position, *turn});
  }
  return path.empty() ? std::nullopt : std::optional(path);
}

std::optional<double> statedAllowance(const nlohmann::json& allowance) {
  const nlohmann::json& value = allowance.at("allowance_m");
  if (!value.is_number()) return std::nullopt;
  const double metres = value.get<double>();
  return metres >= 0.0 && metres <= kFarthest ? std::optional(metres) : std::nullopt;
}

StatedSum statedAgainst(const nlohmann::json& allowances, const std::string& body) {
  StatedSum sum;
  for (const nlohmann::json& each : allowances) {
    if (each.at("body") != body) continue;
    double& side = each.value("yields", false) ? sum.yielding : sum.moving;
    side = std::max(side, statedAllowance(each).value_or(0.0));
  }
  return sum;
}

}  // namespace glissade::oracle
