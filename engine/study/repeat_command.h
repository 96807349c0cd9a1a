#pragma once

#include <string>

#include "engine/study/study.h"

namespace glissade {

/// The shell command that repeats a run, from the folder of the study file.
std::string repeatCommand(const StudyCell& cell, std::uint64_t seed);

/// A word of a shell command, quoted where needed.
std::string shellWord(const std::string& word);

}  // namespace glissade
