#include "widgets/bridge/run_recorder.h"

#include <utility>

namespace glissade {

RunRecorder::~RunRecorder() { discardJournal(); }

void RunRecorder::open(const ScenarioPtr& scenario) {
  discardJournal();
  parts_.clear();
  head_.reset();
  scenario_ = scenario;
  next_.reset();
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
  for (; journalled_ < parts_.size(); ++journalled_) {
    const Outcome written = journal_->append(*parts_[journalled_]);
    if (written) continue;
    trouble_ = written.error();
    discardJournal();
    return;
  }
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
  discardJournal();
  trouble_.reset();
  const auto head = record();
  if (!head) {
    trouble_ = head.error();
    return;
  }
  auto journal = RunJournal::begin(*head, folder_);
  if (journal) {
    journal_ = std::move(*journal);
  } else {
    trouble_ = journal.error();
  }
}

void RunRecorder::discardJournal() {
  if (journal_) journal_->discard();
  journal_.reset();
  journalled_ = 0;
}

}  // namespace glissade
