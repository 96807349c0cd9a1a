#pragma once

#include <string>

#include "engine/study/study.h"

namespace glissade {

/// The command of a shell that repeats a run, from the folder of the study file.
std::string repeatCommand(const StudyCell& cell, std::uint64_t seed);

/// A word of a command as a shell takes it: quoted where needed.
std::string shellWord(const std::string& word);

}  // namespace glissade
