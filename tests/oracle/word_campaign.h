#pragma once

#include <cstdint>
#include <string>

namespace glissade::oracle {

struct WordOptions {
  std::string cli;      ///< glissade-cli
  std::string folder;   ///< mutants with a finding stay in it
  std::string product;  ///< a STEP file with screws, and with a clash of up to 3 mm
  std::uint64_t seed = 1;
  std::uint64_t mutants = 60;
};

/// Changes the words and the numbers of a sound plan of the product, and gives it to `check`. Prints a row "name |
/// tried | clean | defects | seconds | peak MB | seed". Returns 0 if no false plan is called valid, and each plan that
/// depends on its own words has a condition, or is refused.
int runWordMutations(const WordOptions& options);

}  // namespace glissade::oracle
