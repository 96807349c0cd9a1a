#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"

namespace glissade {

/// What a child process left behind.
struct ChildResult {
  std::string output;
  bool timedOut = false;  ///< or said too much, or was stopped
  int signal = 0;         ///< that ended it; 0: it ended by itself
  int exitCode = 0;       ///< meaningful when signal is 0
};

/// Runs a program with a file as standard input and collects its standard output; kills it when it
/// takes too long, says too much or is asked to stop. Standard error is dropped.
Result<ChildResult> runChild(const std::string& program, const std::vector<std::string>& arguments,
                             const std::string& inputFile, std::chrono::milliseconds patience, std::size_t mostOutput,
                             const StopToken& stop = {});

}  // namespace glissade
