#pragma once

#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/descriptor.h"
#include "engine/base/result.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// Edits of a scenario that the user has not saved.
struct UnsavedEdits {
  std::string file;    ///< of the scenario, absolute; empty: it was never saved
  std::string sha256;  ///< of what that file held when it was opened or saved last; empty: there was none
  Scenario scenario;   ///< its assets are named as seen from the folder of `file`, or from the current folder
};

/// The place of one program's unsaved edits, in a folder of the program's data: never beside the user's files. It is
/// locked as long as the program lives; a killed program leaves it. Of one thread at a time.
class AutosaveSlot {
 public:
  /// A new place in the folder, which is made where it is missing.
  static Result<std::unique_ptr<AutosaveSlot>> make(const std::string& folder);
  /// Removes the edits: who ends cleanly has saved or discarded them.
  ~AutosaveSlot();
  AutosaveSlot(const AutosaveSlot&) = delete;
  AutosaveSlot& operator=(const AutosaveSlot&) = delete;

  /// Replaces what is there, as a whole.
  Outcome write(const UnsavedEdits& edits);
  /// There are no unsaved edits any more.
  void clear();

 private:
  AutosaveSlot(Descriptor lock, std::string base) : lock_(std::move(lock)), base_(std::move(base)) {}

  Descriptor lock_;
  std::string base_;  ///< its files without their endings
};

/// What a killed program has left. Nobody else finds it while this exists.
class AbandonedEdits {
 public:
  AbandonedEdits(Descriptor lock, std::string base) : lock_(std::move(lock)), base_(std::move(base)) {}

  /// Errors: the file is damaged (its checksum does not fit) or cannot be read.
  Result<UnsavedEdits> read() const;
  /// Seconds since 1970.
  std::time_t time() const;
  /// The user does not need it any more.
  void remove();
  std::string file() const;

 private:
  Descriptor lock_;
  std::string base_;
};

/// The latest first.
std::vector<AbandonedEdits> findAbandonedEdits(const std::string& folder);

}  // namespace glissade
