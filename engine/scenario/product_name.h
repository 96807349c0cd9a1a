#pragma once

#include <string>

#include "engine/scenario/scenario.h"

namespace glissade {

/// What the window, reports and files call the product of a scenario, which is saved as `file` or nowhere (empty): its
/// root where it is one assembly, else the name of the scenario where that is no name of a part, else the name of the
/// file or, where there is none, of the file of its parts (of their folder where they are in several files). Empty
/// where nothing says a name.
std::string nameOfProduct(const Scenario& scenario, const std::string& file);
std::string nameOfProduct(const LoadedScenario& scenario);

}  // namespace glissade
