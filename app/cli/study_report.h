#pragma once

#include "engine/study/study_runner.h"

namespace glissade::cli {

/// The line on standard error that says how far a study is: rewritten in place on a terminal, now and
/// then a new one elsewhere.
class ProgressLine {
 public:
  ProgressLine();
  void show(const StudyProgress& progress);
  void end();

 private:
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// A short table of a study's results on standard output.
void printSummary(const StudyFolder& folder, Warnings& warnings);

}  // namespace glissade::cli
