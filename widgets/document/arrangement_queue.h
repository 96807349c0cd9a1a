#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

#include "engine/scenario/scenario_ptr.h"
#include "widgets/bridge/background_task.h"

namespace glissade {

/// Changes of the arrangement, one after the other, in the order in which they were asked for. Each loads its scenario
/// in the background, so that the window does not wait; or at once where time is not real. GUI thread.
class ArrangementQueue final : public QObject {
  Q_OBJECT

 public:
  /// A change of the arrangement.
  struct Job {
    bool isEdit = true;  ///< the scenario is another one afterwards
    QString mergeKey;    ///< a job that waits is replaced by a later one with the same key; empty: by none
    /// The scenario to load, made when the job's turn comes. Nothing: there is nothing to load, and all is done.
    std::function<Result<std::optional<Scenario>>()> begin;
    /// Takes the loaded scenario.
    std::function<void(const ScenarioPtr&)> end;
  };
  /// What a job is made for: where that has changed while it loaded, it begins again.
  using Basis = std::function<std::uint64_t()>;
  /// Loads a scenario on another thread; made on the GUI thread, it holds values of its own.
  using Load = std::function<Result<ScenarioPtr>(Scenario, const StopToken&)>;
  using MakeLoad = std::function<Load()>;

  ArrangementQueue(Basis basis, MakeLoad makeLoad, QObject* parent);

  /// Jobs are done before add() returns. At first they are.
  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  bool isAtOnce() const { return atOnce_; }
  /// The error of a job that was done at once; later errors are announced by failed().
  Outcome add(Job job);
  /// Forgets all jobs.
  void cancel();
  bool isEmpty() const { return jobs_.empty(); }
  bool hasEdits() const {
    return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) { return job.isEdit; });
  }
  const BackgroundTask& task() const { return task_; }

 signals:
  /// A job could not be done; the next one begins.
  void failed(const glissade::Diagnostic& why);

 private:
  void beginNext();
  void take(const Result<ScenarioPtr>& loaded);
  void refuse(const Diagnostic& why);

  Basis basis_;
  MakeLoad makeLoad_;
  std::deque<Job> jobs_;       ///< the first one is under way
  std::uint64_t basedOn_ = 0;  ///< of the one under way
  std::optional<Diagnostic> refusal_;
  bool underWay_ = false;  ///< the first job has begun
  bool adding_ = false;    ///< errors are returned
  bool atOnce_ = true;
  BackgroundTask task_;  ///< the last member: it waits for its threads before the others end
};

}  // namespace glissade
