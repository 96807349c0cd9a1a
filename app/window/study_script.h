#pragma once

#include "app/window/workbench.h"

namespace glissade {

class StudyController;

/// The script commands about studies.
void addStudyCommands(const Workbench& bench, StudyController& studies);

}  // namespace glissade
