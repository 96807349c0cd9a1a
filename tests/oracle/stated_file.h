#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// Poses of a path in JSON. Nothing if a number is missing, not finite or beyond 1e9 m, or if an orientation is not a
/// unit quaternion.
std::optional<std::vector<Placement>> statedPoses(const nlohmann::json& poses);

/// An allowance; nothing if it is not a number from 0 to 1e9.
std::optional<double> statedAllowance(const nlohmann::json& allowance);

/// Allowances in the list against the body, in metres, for the moving body and for the other one.
struct StatedSum {
  double moving = 0.0;
  double yielding = 0.0;
};
StatedSum statedAgainst(const nlohmann::json& allowances, const std::string& body);

}  // namespace glissade::oracle
