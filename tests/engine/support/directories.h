#pragma once

#include <string>

namespace glissade::test {

/// The project's folder. Only directories.cpp is compiled with it, so a compiler cache serves every checkout.
std::string sourceDirectory();
/// Where the programs were built.
std::string programDirectory();
/// Where tests/step_files wrote its files.
std::string stepFileDirectory();

}  // namespace glissade::test
