#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "engine/files/run_journal.h"

namespace glissade {

/// Writes the journal of one run on a separate thread, because a line takes milliseconds to reach the disk. After the
/// first line that cannot be written nothing more is written; the lines before it stay.
class JournalWriter {
 public:
  using Part = std::shared_ptr<const RunLog>;

  /// The journal begins with `head`.
  JournalWriter(RunRecord head, std::string folder);
  /// Removes the journal, which only a killed program needs.
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  void append(Part part);
  /// Waits until all that was appended is on the disk, or cannot be written.
  void waitUntilWritten();
  /// The reason why the journal is not complete on the disk.
  std::optional<Diagnostic> trouble() const;

 private:
  void run();
  Outcome write(const Part& part);

  RunRecord head_;
  std::string folder_;
  std::unique_ptr<RunJournal> journal_;  ///< used by the thread, and after it has ended

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Part> waiting_;  ///< the first one is being written; null stands for the head
  std::optional<Diagnostic> trouble_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace glissade
