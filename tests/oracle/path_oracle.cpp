// Writes scenes, and judges the paths that path_maker found in them. It uses no code of the engine.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "tests/oracle/exact_judge.h"
#include "tests/oracle/oracle_campaign.h"
#include "tests/oracle/scene_generator.h"

namespace glissade::oracle {
namespace {

namespace fs = std::filesystem;

int writeScenes(const std::string& folder, std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  for (std::uint64_t i = first; i < first + count; ++i) {
    const std::string name = folder + "/" + std::to_string(i);
    fs::create_directories(name);
    std::cout << i << ": " << writeScene(name, seed, i) << "\n";
  }
  return 0;
}

int judgeFolder(const std::string& folder) {
  const Judged judged = judgeScenes(folder);
  for (const std::string& line : judged.findings) std::cout << line << "\n";
  std::cout << judged.paths << " paths, " << judged.findings.size() << " penetrate; " << judged.verdict.poses
            << " poses, " << judged.verdict.penetrating << " penetrate\n";
  return judged.findings.empty() ? 0 : 1;
}

int judgeFiles(int argc, char** argv) {
  const ExactJudge judge(readScene(argv[2]));
  Verdict verdict;
  for (int i = 3; i < argc; ++i) judge.judge(readPath(argv[i]), 0.005, 3000, verdict);
  std::cout << verdict.penetrating << " of " << verdict.poses << " poses penetrate, at least " << verdict.depth
            << " m deep\n";
  return verdict.penetrating == 0 ? 0 : 1;
}

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "scenes" && argc == 6) {
    return writeScenes(argv[2], std::stoull(argv[3]), std::stoull(argv[4]), std::stoull(argv[5]));
  }
  if (command == "campaign" && argc == 6) {
    return runCampaign({argv[2], argv[3], std::stoull(argv[4]), std::stoull(argv[5])});
  }
  if (command == "judge" && argc == 3) return judgeFolder(argv[2]);
  if (command == "path" && argc >= 4) return judgeFiles(argc, argv);
  std::cerr << "usage: path_oracle scenes FOLDER SEED FIRST COUNT\n"
               "       path_oracle campaign PATH_MAKER FOLDER SEED PATHS\n"
               "       path_oracle judge FOLDER\n"
               "       path_oracle path SCENARIO PATH.csv...\n";
  return 2;
}

}  // namespace
}  // namespace glissade::oracle

int main(int argc, char** argv) {
  try {
    return glissade::oracle::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "path_oracle: " << error.what() << "\n";
    return 3;
  }
}
