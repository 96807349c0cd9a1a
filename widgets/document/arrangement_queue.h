#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

#include "engine/files/scenario_ptr.h"
#include "widgets/controls/background_task.h"

namespace glissade {

/// Changes of the arrangement, one after the other, in the order of their requests. Each loads its scenario in the
/// background, so that the window does not wait, or at once. Used on the GUI thread only.
class ArrangementQueue final : public QObject {
  Q_OBJECT

 public:
  /// A change of the arrangement.
  struct Job {
    bool isEdit = true;  ///< the job changes the scenario
    QString mergeKey;    ///< a waiting job is replaced by a later one with the same key; empty: it is not replaced
    /// Makes the scenario to load, when the job's turn comes. Nothing: there is nothing to load, and the job is done.
    std::function<Result<std::optional<Scenario>>()> begin;
    /// Takes the loaded scenario.
    std::function<void(const ScenarioPtr&)> end;
  };
  /// Version of the state that a job is made for. A job begins again if this has changed while its scenario loaded.
  using Basis = std::function<std::uint64_t()>;
  /// Loads a scenario on another thread. It is made on the GUI thread and holds copies of its input.
  using Load = std::function<Result<ScenarioPtr>(Scenario, const StopToken&)>;
  using MakeLoad = std::function<Load()>;

  ArrangementQueue(Basis basis, MakeLoad makeLoad, QObject* parent);

  /// Jobs are done before add() returns, if `atOnce`, which is the default.
  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  bool isAtOnce() const { return atOnce_; }
  /// Returns the error of a job that was done at once; later errors are announced by failed().
  Outcome add(Job job);
  /// Forgets all jobs.
  void cancel();
  bool isEmpty() const { return jobs_.empty(); }
  bool hasEdits() const {
    return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) { return job.isEdit; });
  }
  const BackgroundTask& task() const { return task_; }

 signals:
  /// A job failed; the next one begins.
  void failed(const glissade::Diagnostic& why);

 private:
  void beginNext();
  void take(const Result<ScenarioPtr>& loaded);
  void refuse(const Diagnostic& why);

  Basis basis_;
  MakeLoad makeLoad_;
  std::deque<Job> jobs_;       ///< the first job is under way
  std::uint64_t basedOn_ = 0;  ///< basis of the job that is under way
  std::optional<Diagnostic> refusal_;
  bool underWay_ = false;  ///< the first job has begun
  bool adding_ = false;    ///< add() is running and returns errors
  bool atOnce_ = true;
  BackgroundTask task_;  ///< the last member: it waits for its threads before the others end
};

}  // namespace glissade
