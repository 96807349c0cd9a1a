#pragma once

#include "engine/base/child_process.h"

namespace glissade {

/// A program that has just been started.
struct LaunchedChild {
  pid_t pid = 0;
  Descriptor process;  ///< pidfd: readable at its end
  Descriptor output;   ///< read end of its standard output, non-blocking
  Descriptor errors;   ///< read end of its standard error, non-blocking
};

/// Starts a program in a session of its own with the limits of the command. Returns after the program
/// was loaded (execve). Errors are Internal and name the step that failed.
Result<LaunchedChild> launchChild(const ChildCommand& command);

}  // namespace glissade
