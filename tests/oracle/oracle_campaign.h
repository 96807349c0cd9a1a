#pragma once

#include <string>
#include <vector>

#include "tests/oracle/exact_judge.h"

namespace glissade::oracle {

/// The verdicts on the paths of a folder of scenes.
struct Judged {
  std::uint64_t paths = 0;
  Verdict verdict;
  std::vector<std::string> findings;  ///< one line for each path that penetrates
};

/// Judges every CSV in every folder that holds a `scenario.json`.
Judged judgeScenes(const std::string& folder);

struct CampaignOptions {
  std::string pathMaker;  ///< the program
  std::string folder;     ///< scenes with a finding stay in it
  std::uint64_t seed = 1;
  std::uint64_t paths = 60;  ///< minimum number
};

/// Writes scenes, lets the path maker produce certified paths, and judges them, batch by batch. Prints rows
/// "name | tried | clean | defects | seconds | peak MB | seed". Returns 0 if no path penetrates and the independent
/// check agrees with every certificate.
int runCampaign(const CampaignOptions& options);

}  // namespace glissade::oracle
