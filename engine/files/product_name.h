#pragma once

#include <string>

#include "engine/files/scenario.h"

namespace glissade {

/// The name of a scenario's product for the window, reports and files. `file`: the scenario's file; empty: not saved.
/// The first of these that exists: the name of the root, if it is one assembly; the name of the scenario, unless it is
/// the name of a part; the name of the file; the name of the file of the parts, or of their folder if there are several
/// files. Empty where there is none.
std::string nameOfProduct(const Scenario& scenario, const std::string& file);
std::string nameOfProduct(const LoadedScenario& scenario);

}  // namespace glissade
