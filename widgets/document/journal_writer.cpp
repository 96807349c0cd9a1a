#include "widgets/document/journal_writer.h"

#include <exception>
#include <utility>

namespace glissade {

JournalWriter::JournalWriter(RunRecord head, std::string folder)
    : head_(std::move(head)), folder_(std::move(folder)), waiting_{nullptr}, thread_([this] { run(); }) {}

JournalWriter::~JournalWriter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
  if (journal_) journal_->discard();
}

void JournalWriter::append(Part part) {
  {
    const std::lock_guard lock(mutex_);
    if (trouble_) return;
    waiting_.push_back(std::move(part));
  }
  changed_.notify_all();
}

void JournalWriter::waitUntilWritten() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.empty(); });
}

std::optional<Diagnostic> JournalWriter::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void JournalWriter::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
    if (stop_) return;
    const Part part = waiting_.front();
    lock.unlock();
    const Outcome written = write(part);
    lock.lock();
    if (written) {
      waiting_.pop_front();
    } else {
      trouble_ = written.error();
      waiting_.clear();
    }
    changed_.notify_all();
  }
}

Outcome JournalWriter::write(const Part& part) {
  try {
    if (part) return journal_->append(*part);
    auto journal = RunJournal::begin(head_, folder_);
    if (!journal) return journal.error();
    journal_ = std::move(*journal);
    return Done{};
  } catch (const std::exception& error) {
    return Diagnostic{ErrorKind::Internal,
                      folder_,
                      "",
                      {GLISSADE_TEXT("the journal cannot be written: %1"), {error.what()}},
                      GLISSADE_TEXT("The run is not recorded on disk.")};
  }
}

}  // namespace glissade
