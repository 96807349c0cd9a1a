#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/scenario/run_record.h"

namespace glissade {

/// The record of a run while it goes on: each part is one more line of the file as soon as it is
/// there, so that a killed program leaves all but the last second. Each line carries a checksum and is flushed
/// to the disk, which takes milliseconds: not for the GUI thread. readRunRecord reads the file; a damaged line costs
/// that line only. The file is locked as long as its writer lives.
class RunJournal {
 public:
  /// A new file in the folder, which is made where it is missing. Begins with the record's head.
  static Result<std::unique_ptr<RunJournal>> begin(const RunRecord& record, const std::string& folder);
  ~RunJournal();
  RunJournal(const RunJournal&) = delete;
  RunJournal& operator=(const RunJournal&) = delete;

  /// Errors: the disk does not take the line; the lines before it stay whole.
  Outcome append(const RunLog& part);
  /// Nobody needs it any more.
  void discard();
  const std::string& file() const { return file_; }

 private:
  RunJournal(int descriptor, std::string file) : descriptor_(descriptor), file_(std::move(file)) {}
  Outcome writeLine(const std::string& line);

  int descriptor_;
  long size_ = 0;  ///< bytes of the whole lines
  std::string file_;
};

/// Journals whose writers are gone, the oldest first.
std::vector<std::string> abandonedJournals(const std::string& folder);
/// Makes the recording `target` of an abandoned journal, which goes only once that is written.
SaveResult saveJournal(const std::string& journal, const std::string& target, const WorkWatch& watch = {});

}  // namespace glissade
