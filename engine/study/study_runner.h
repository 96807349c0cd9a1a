#pragma once

#include <functional>
#include <string>

#include "engine/base/stop_token.h"
#include "engine/study/study_folder.h"

namespace glissade {

struct RunnerOptions {
  std::string program;    ///< path of the glissade-cli that runs are started with
  std::string studyFile;  ///< scenarios are relative to it
  std::size_t jobs = 1;   ///< number of simultaneous runs
  Shard shard;
};

/// Progress of a study.
struct StudyProgress {
  std::size_t planned = 0;  ///< number of runs of the shard
  std::size_t done = 0;     ///< number of finished runs, including those found in the folder
  std::size_t solved = 0;
  std::size_t broken = 0;    ///< number of runs that ended by time, memory, a crash or an error
  double secondsLeft = 0.0;  ///< estimate from the runs of the same cells; negative: not known yet
};

/// Starts the runs of the shard that the folder does not have yet, each in its own process with its limits, and saves
/// each as it ends. `progress` is called on this thread whenever a run has ended. After a stop it kills the running
/// processes and returns an Interrupted error; the study can be continued later in the same folder. Call it on the main
/// thread: child processes end with the thread that started them.
Outcome runStudy(const StudyFolder& folder, const RunnerOptions& options, const StopToken& stop,
                 const std::function<void(const StudyProgress&)>& progress, Warnings& warnings);

}  // namespace glissade
