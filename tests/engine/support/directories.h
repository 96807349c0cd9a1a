#pragma once

#include <string>

namespace glissade::test {

/// The project's folder. Only directories.cpp is compiled with it, so a compiler cache serves every checkout.
std::string sourceDirectory();
/// The folder of the built programs.
std::string programDirectory();
/// The folder of the files that tests/step_files wrote.
std::string stepFileDirectory();

}  // namespace glissade::test
