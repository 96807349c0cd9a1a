#pragma once

#include "engine/files/scenario.h"

namespace glissade {

/// Whether the scenarios differ in names of bodies at most, so that a run, its path and its recording are about both. A
/// name may tell a joint; scenarios whose fits allow different things differ.
bool isSameProblem(const LoadedScenario& a, const LoadedScenario& b);

}  // namespace glissade
