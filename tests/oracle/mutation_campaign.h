#pragma once

#include <cstdint>
#include <string>

namespace glissade::oracle {

struct MutationOptions {
  std::string cli;     ///< glissade-cli
  std::string folder;  ///< mutants with a finding stay in it
  std::uint64_t seed = 1;
  std::uint64_t mutants = 60;
};

/// Changes sound paths and plans of generated products, and gives them to `check`. Prints rows "name | tried | clean |
/// defects | seconds | peak MB | seed". Returns 0 if no false path or plan is called valid, each refusal names a body,
/// a step or the place in the file, and at least half of the mutants are false.
int runMutations(const MutationOptions& options);

}  // namespace glissade::oracle
