#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/files/run_record.h"

namespace glissade {

/// The record of a run while it goes on. Each part is appended to the file as a line as soon as it exists, so that a
/// killed program loses at most the last second. Each line has a checksum and is flushed to the disk, which takes
/// milliseconds; do not call it on the GUI thread. readRunRecord reads the file, and a damaged line loses that line
/// only. The file is locked as long as its writer runs.
class RunJournal {
 public:
  /// Creates a file in the folder, which is created where it is missing, and writes the record's head.
  static Result<std::unique_ptr<RunJournal>> begin(const RunRecord& record, const std::string& folder);
  ~RunJournal();
  RunJournal(const RunJournal&) = delete;
  RunJournal& operator=(const RunJournal&) = delete;

  /// Appends a line. Errors: the line cannot be written; the lines before it stay complete.
  Outcome append(const RunLog& part);
  /// Removes the journal.
  void discard();
  const std::string& file() const { return file_; }

 private:
  RunJournal(int descriptor, std::string file) : descriptor_(descriptor), file_(std::move(file)) {}
  Outcome writeLine(const std::string& line);

  int descriptor_;
  long size_ = 0;  ///< bytes of the complete lines
  std::string file_;
};

/// Journals without a running writer, the oldest first.
std::vector<std::string> abandonedJournals(const std::string& folder);
/// Saves an abandoned journal as the recording `target`, then removes it.
SaveResult saveJournal(const std::string& journal, const std::string& target, const WorkWatch& watch = {});

}  // namespace glissade
