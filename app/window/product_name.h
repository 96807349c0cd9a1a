#pragma once

#include <string>

#include "engine/product/assembled_product.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What documents call the product of a scenario: its root where it is one assembly, else the name of the scenario
/// where that is no name of a part, else the name of the scenario's file or, where it has none, of the file of its
/// parts.
std::string nameOfProduct(const LoadedScenario& scenario, const AssembledProduct& product);

}  // namespace glissade
