#pragma once

#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/descriptor.h"
#include "engine/base/result.h"
#include "engine/files/scenario.h"

namespace glissade {

/// Edits of a scenario that the user has not saved.
struct UnsavedEdits {
  std::string file;    ///< file of the scenario, absolute; empty: it was never saved
  std::string sha256;  ///< hash of the file's content when it was opened or saved last; empty: there was none
  Scenario scenario;   ///< its assets are relative to the folder of `file`, or to the current folder
};

/// The file of one program's unsaved edits, in a folder of the program's data, never beside the user's files. It is
/// locked as long as the program runs; a killed program leaves it. Not thread-safe.
class AutosaveSlot {
 public:
  /// Makes a new slot in the folder, which is created where it is missing.
  static Result<std::unique_ptr<AutosaveSlot>> make(const std::string& folder);
  /// Removes the edits: a program that ends cleanly has saved or discarded them.
  ~AutosaveSlot();
  AutosaveSlot(const AutosaveSlot&) = delete;
  AutosaveSlot& operator=(const AutosaveSlot&) = delete;

  /// Replaces the whole content.
  Outcome write(const UnsavedEdits& edits);
  /// Removes the edits, because none are unsaved any more.
  void clear();

 private:
  AutosaveSlot(Descriptor lock, std::string base) : lock_(std::move(lock)), base_(std::move(base)) {}

  Descriptor lock_;
  std::string base_;  ///< its files without their endings
};

/// Edits that a killed program has left. No other program finds them while this object exists.
class AbandonedEdits {
 public:
  AbandonedEdits(Descriptor lock, std::string base) : lock_(std::move(lock)), base_(std::move(base)) {}

  /// Errors: the file is damaged (its checksum does not fit) or cannot be read.
  Result<UnsavedEdits> read() const;
  /// Time of the last change, seconds since 1970.
  std::time_t time() const;
  /// Removes the edits, because the user does not need them any more.
  void remove();
  std::string file() const;

 private:
  Descriptor lock_;
  std::string base_;
};

/// The edits in the folder, the latest first.
std::vector<AbandonedEdits> findAbandonedEdits(const std::string& folder);

}  // namespace glissade
