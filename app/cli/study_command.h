#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/cli/report.h"
#include "engine/study/study_plan.h"

namespace glissade::cli {

struct StudyOptions {
  std::string study;
  std::string out;
  std::size_t jobs = 1;
  std::string shard = "1/1";
  bool quick = false;
  bool dryRun = false;
};

/// glissade-cli study: carries out a study's runs, each in a process of its own, and writes its
/// tables. Exit code 0 all runs have ended (however), 130 interrupted (the same command goes on).
int runStudyCommand(const StudyOptions& options);

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out;
};

/// glissade-cli merge: unites the results of shards. Exit code 3 where they do not belong together.
int runMerge(const MergeOptions& options);

struct ReportOptions {
  std::string folder;
  std::string out;  ///< empty: the folder itself
  std::string language = "en";
};

/// glissade-cli report: writes report.html of a folder of results.
int runReport(const ReportOptions& options);

/// glissade-cli benchmark-page: writes benchmarks.html of a folder that packaging/benchmarks.sh filled.
int runBenchmarkPage(const std::string& folder);

}  // namespace glissade::cli
