#pragma once

#include <functional>
#include <string>

#include "engine/base/stop_token.h"
#include "engine/study/study_folder.h"

namespace glissade {

struct RunnerOptions {
  std::string program;    ///< the glissade-cli that carries runs out
  std::string studyFile;  ///< scenarios are relative to it
  std::size_t jobs = 1;   ///< runs at once
  Shard shard;
};

/// Where a study stands.
struct StudyProgress {
  std::size_t planned = 0;  ///< runs of the shard
  std::size_t done = 0;     ///< with those found done
  std::size_t solved = 0;
  std::size_t broken = 0;    ///< that ended at time, memory, a crash or an error
  double secondsLeft = 0.0;  ///< estimated from the runs of the same cells; negative: nothing known yet
};

/// Carries out the runs of the shard that the folder does not hold yet, each in a process of its own
/// with its limits, and saves each as it ends. `progress` is called on this thread whenever a run has
/// ended. Asked to stop, it kills what runs and returns an Interrupted error: the folder can be
/// taken up again. Call it on the main thread: children die with the thread that started them.
Outcome runStudy(const StudyFolder& folder, const RunnerOptions& options, const StopToken& stop,
                 const std::function<void(const StudyProgress&)>& progress, Warnings& warnings);

}  // namespace glissade
