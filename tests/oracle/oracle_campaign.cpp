#include "tests/oracle/oracle_campaign.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "tests/oracle/child_run.h"
#include "tests/oracle/scene_generator.h"

namespace glissade::oracle {
namespace {

namespace fs = std::filesystem;

/// Distance between two samples as a share of the object's size, and maximum number of samples of an edge.
constexpr double kStep = 0.02;
constexpr int kMostSamples = 300;
constexpr std::uint64_t kScenesOfABatch = 24;
constexpr const char* kMotionsOfAScene = "6";
constexpr double kMostSecondsOfABatch = 900.0;

/// Processor seconds of this process and of the children that it waited for.
double cpuSeconds() {
  double seconds = 0.0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
  }
  return seconds;
}

long ownMegabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

class Campaign {
 public:
  explicit Campaign(const CampaignOptions& options) : options_(options) {}

  int run() {
    for (std::uint64_t first = 0; all_.paths < options_.paths; first += kScenesOfABatch) {
      if (!runBatch(first)) return 3;
    }
    std::cerr << all_.verdict.poses << " poses, " << all_.verdict.penetrating << " penetrate; " << unloadable_
              << " scenes refused\n";
    print("certified paths, " + std::to_string(all_.verdict.poses) + " exact poses", all_.findings.size());
    print("certified paths, independent check", refused_);
    return all_.findings.empty() && refused_ == 0 ? 0 : 1;
  }

 private:
  bool runBatch(std::uint64_t first) {
    const std::string folder = options_.folder + "/" + std::to_string(first);
    for (std::uint64_t i = first; i < first + kScenesOfABatch; ++i) {
      const std::string scene = folder + "/" + std::to_string(i);
      fs::create_directories(scene);
      writeScene(scene, options_.seed, i);
    }
    const ChildEnd made = runChild({options_.pathMaker, folder, kMotionsOfAScene}, {kMostSecondsOfABatch, 4096});
    if (made.exitCode != 0 && made.exitCode != 1) {
      std::cerr << "path_maker ended with " << made.exitCode << ", signal " << made.signal << ": " << made.errors
                << "\n";
      return false;
    }
    megabytes_ = std::max(megabytes_, made.megabytes);
    const Judged judged = judgeScenes(folder);
    all_.paths += judged.paths;
    all_.verdict.poses += judged.verdict.poses;
    all_.verdict.penetrating += judged.verdict.penetrating;
    all_.findings.insert(all_.findings.end(), judged.findings.begin(), judged.findings.end());
    const std::uint64_t refusedBefore = refused_;
    readReport(made.output);
    for (const std::string& line : judged.findings) std::cerr << line << "\n";
    if (judged.findings.empty() && refused_ == refusedBefore) fs::remove_all(folder);
    return true;
  }

  void readReport(const std::string& output) {
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("REFUSED", 0) == 0) {
        ++refused_;
        std::cerr << line << "\n";
      } else if (line.rfind("NOT LOADED", 0) == 0) {
        ++unloadable_;
        std::cerr << line << "\n";
      }
    }
  }

  void print(const std::string& name, std::uint64_t defects) const {
    std::cout << name << " | " << all_.paths << " | " << all_.paths - defects << " | " << defects << " | "
              << std::lround(cpuSeconds()) << " | " << std::max(megabytes_, ownMegabytes()) << " | " << options_.seed
              << "\n";
  }

  const CampaignOptions& options_;
  Judged all_;
  std::uint64_t refused_ = 0;
  std::uint64_t unloadable_ = 0;
  long megabytes_ = 0;
};

}  // namespace

Judged judgeScenes(const std::string& folder) {
  Judged judged;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string scenario = (entry.path() / "scenario.json").string();
    if (!fs::exists(scenario)) continue;
    const ExactJudge judge(readScene(scenario));
    for (const auto& file : fs::directory_iterator(entry.path())) {
      if (file.path().extension() != ".csv") continue;
      Verdict verdict;
      judge.judge(readPath(file.path().string()), kStep, kMostSamples, verdict);
      ++judged.paths;
      judged.verdict.poses += verdict.poses;
      judged.verdict.penetrating += verdict.penetrating;
      judged.verdict.depth = std::max(judged.verdict.depth, verdict.depth);
      if (verdict.penetrating == 0) continue;
      std::ostringstream line;
      line << "PENETRATES " << file.path().string() << ": " << verdict.penetrating << " of " << verdict.poses
           << " poses, at least " << verdict.depth << " m deep";
      judged.findings.push_back(line.str());
    }
  }
  return judged;
}

int runCampaign(const CampaignOptions& options) { return Campaign(options).run(); }

}  // namespace glissade::oracle
