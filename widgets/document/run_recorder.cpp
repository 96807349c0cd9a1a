#include "widgets/document/run_recorder.h"

#include <utility>

#include "engine/files/same_problem.h"

namespace glissade {

void RunRecorder::open(const ScenarioPtr& scenario) {
  closeJournal();
  parts_.clear();
  head_.reset();
  scenario_ = scenario;
  next_.reset();
}

void RunRecorder::rearrange(const ScenarioPtr& scenario) {
  if (next_ || !renew(scenario)) next_ = scenario;
}

bool RunRecorder::renew(const ScenarioPtr& scenario) {
  if (!scenario_ || !isSameProblem(*scenario_, *scenario)) return false;
  scenario_ = scenario;
  head_.reset();
  return true;
}

bool RunRecorder::follow(const SessionSnapshot& snapshot) {
  if (snapshot.log.empty() || !scenario_) return false;
  const bool another = parts_.empty() || parts_.front() != snapshot.log.front();
  if (another && next_) open(std::exchange(next_, nullptr));
  parts_ = snapshot.log;
  if (another && !folder_.empty()) beginJournal();
  journal();
  return another;
}

void RunRecorder::journal() {
  if (!journal_) return;
  for (; journalled_ < parts_.size(); ++journalled_) journal_->append(parts_[journalled_]);
}

std::optional<Diagnostic> RunRecorder::trouble() const { return journal_ ? journal_->trouble() : headTrouble_; }

std::optional<Diagnostic> RunRecorder::takeTrouble() {
  auto why = troubleTaken_ ? std::nullopt : trouble();
  troubleTaken_ = troubleTaken_ || why;
  return why;
}

void RunRecorder::waitUntilJournalled() {
  if (journal_) journal_->waitUntilWritten();
}

Result<RunRecord> RunRecorder::record() {
  if (!head_) {
    auto head = makeRunRecord(*scenario_, RunLog());
    if (!head) return head.error();
    head_ = std::move(*head);
  }
  RunRecord record = *head_;
  setLog(joined(parts_), record);
  return record;
}

void RunRecorder::beginJournal() {
  closeJournal();
  headTrouble_.reset();
  troubleTaken_ = false;
  auto head = record();
  if (head) {
    journal_ = std::make_unique<JournalWriter>(std::move(*head), folder_);
  } else {
    headTrouble_ = head.error();
  }
}

void RunRecorder::closeJournal() {
  journal_.reset();
  journalled_ = 0;
}

}  // namespace glissade
