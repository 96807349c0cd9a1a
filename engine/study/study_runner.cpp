#include "engine/study/study_runner.h"

#include <algorithm>
#include <deque>
#include <list>
#include <thread>

#include "engine/base/child_process.h"

namespace glissade {
namespace {

constexpr auto kNap = std::chrono::milliseconds(5);

double timeLimitOf(const StudyCell& cell) { return cell.parameters.at(ParameterId::TimeLimit); }

/// Time after which a run is killed. A run ends by itself at its time limit, unless it takes long to load or hangs.
double longestLifeOf(const StudyCell& cell) {
  const double limit = timeLimitOf(cell);
  return limit > 0.0 ? 1.25 * limit + 30.0 : 0.0;
}

/// Estimates the remaining time from finished runs of the same cells.
class Estimate {
 public:
  explicit Estimate(std::size_t cells) : ofCell_(cells) {}

  void add(std::size_t cell, double seconds) {
    ofCell_[cell].add(seconds);
    total_.add(seconds);
  }
  bool empty() const { return total_.count == 0; }
  double of(std::size_t cell) const { return ofCell_[cell].count > 0 ? ofCell_[cell].mean() : total_.mean(); }

 private:
  struct Mean {
    double sum = 0.0;
    std::size_t count = 0;
    void add(double value) {
      sum += value;
      ++count;
    }
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Mean> ofCell_;
  Mean total_;
};

class Runner {
 public:
  Runner(const StudyFolder& folder, const RunnerOptions& options,
         const std::function<void(const StudyProgress&)>& progress, Warnings& warnings)
      : folder_(folder), options_(options), tell_(progress), estimate_(folder.plan().study.cells.size()) {
    const StudyResults known = folder.results(warnings);
    for (const StudyRun& run : runsOf(folder.plan().study, options.shard)) {
      ++progress_.planned;
      const auto found = known.find(run);
      if (found == known.end()) {
        waiting_.push_back(run);
      } else {
        count(run, found->second);
      }
    }
  }

  Outcome run(const StopToken& stop) {
    tell();
    while (!waiting_.empty() || !jobs_.empty()) {
      if (stop.stopRequested()) return interrupted();
      const Outcome filled = fill();
      if (!filled) return filled;
      const auto ended = collect();
      if (!ended) return ended.error();
      if (*ended == 0) std::this_thread::sleep_for(kNap);
    }
    return Done{};
  }

 private:
  struct Job {
    StudyRun run;
    ChildProcess process;
  };

  const StudyCell& cellOf(const StudyRun& run) const { return folder_.plan().study.cells[run.cell]; }

  Outcome fill() {
    while (jobs_.size() < options_.jobs && !waiting_.empty()) {
      const StudyRun run = waiting_.front();
      const StudyCell& cell = cellOf(run);
      ChildCommand command;
      command.program = options_.program;
      command.arguments = planArguments(cell, run.seed, scenarioFileOf(options_.studyFile, cell));
      command.environment = requiredEnvironment();
      command.limits.seconds = longestLifeOf(cell);
      command.limits.memoryBytes = cell.memoryLimitMb << 20U;
      auto process = ChildProcess::start(command);
      if (!process) return process.error();
      waiting_.pop_front();
      jobs_.push_back({run, std::move(*process)});
    }
    return Done{};
  }

  /// Saves the runs that have ended and returns their number.
  Result<std::size_t> collect() {
    std::size_t ended = 0;
    for (auto job = jobs_.begin(); job != jobs_.end();) {
      const auto end = job->process.poll();
      if (!end) {
        ++job;
        continue;
      }
      const RunOutcome outcome = outcomeOf(*end, timeLimitOf(cellOf(job->run)));
      const Outcome saved = folder_.save(job->run, outcome);
      if (!saved) return saved.error();
      count(job->run, outcome);
      job = jobs_.erase(job);
      ++ended;
      tell();
    }
    return ended;
  }

  void count(const StudyRun& run, const RunOutcome& outcome) {
    ++progress_.done;
    if (outcome.result.status == RunStatus::Solved) ++progress_.solved;
    if (dependsOnMachine(outcome.result.status)) ++progress_.broken;
    estimate_.add(run.cell, outcome.timing.wallSeconds);
  }

  void tell() {
    double seconds = estimate_.empty() ? -1.0 : 0.0;
    if (!estimate_.empty()) {
      for (const StudyRun& run : waiting_) seconds += estimate_.of(run.cell);
      for (const Job& job : jobs_) seconds += estimate_.of(job.run.cell) / 2.0;
      seconds /= static_cast<double>(options_.jobs);
    }
    progress_.secondsLeft = seconds;
    tell_(progress_);
  }

  Diagnostic interrupted() const {
    return {ErrorKind::Interrupted,
            folder_.path(),
            "",
            {GLISSADE_TEXT("interrupted with %1 of %2 {2|run|runs} done"), {progress_.done, progress_.planned}},
            GLISSADE_TEXT("The same command resumes from here.")};
  }

  const StudyFolder& folder_;
  const RunnerOptions& options_;
  const std::function<void(const StudyProgress&)>& tell_;
  Estimate estimate_;
  std::deque<StudyRun> waiting_;
  std::list<Job> jobs_;
  StudyProgress progress_;
};

}  // namespace

Outcome runStudy(const StudyFolder& folder, const RunnerOptions& options, const StopToken& stop,
                 const std::function<void(const StudyProgress&)>& progress, Warnings& warnings) {
  return Runner(folder, options, progress, warnings).run(stop);
}

}  // namespace glissade
