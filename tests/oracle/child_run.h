#pragma once

#include <string>
#include <vector>

namespace glissade::oracle {

struct ChildLimits {
  double seconds = 30.0;
  long megabytes = 2048;  ///< largest resident memory of the child or of its children
};

struct ChildEnd {
  int exitCode = -1;  ///< -1: a signal ended it
  int signal = 0;
  bool hung = false;  ///< it was killed at the time limit, twice
  double seconds = 0.0;
  long megabytes = 0;  ///< largest resident memory
  std::string output;
  std::string errors;  ///< both streams are cut off at 1 MB
};

/// Runs a program with its output in memory. Kills it and its children when the time is up, and then repeats the run
/// once with ten times the time, because other processes of a loaded machine may have stopped the first run.
ChildEnd runChild(const std::vector<std::string>& command, const ChildLimits& limits);

}  // namespace glissade::oracle
