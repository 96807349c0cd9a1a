#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// A body of a product that is assembled with gaps, so that no bodies touch. Metres, in the world.
struct PlanBody {
  std::string id;
  Triangles triangles;
};

/// Why the plan is false; empty if no reason was found. Counts, names and ends are compared with the steps, and exact
/// predicates decide about poses of each step.
/// predicates decide about poses of each step.
std::string whyFalse(const nlohmann::json& plan, const std::vector<PlanBody>& product);

}  // namespace glissade::oracle
