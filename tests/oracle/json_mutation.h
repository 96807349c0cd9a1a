#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/oracle/mutation_dice.h"

namespace glissade::oracle {

using Json = nlohmann::json;

/// Changes a path file (its text as JSON, without a checksum). Returns a description of the change.
std::string mutatePath(Json& path, const std::string& body, MutationDice& dice);

/// Changes an assembly plan. `bodies`: ids of the product. Returns a description of the change.
std::string mutatePlan(Json& plan, const std::vector<std::string>& bodies, MutationDice& dice);

}  // namespace glissade::oracle
