#pragma once

#include <sys/types.h>

#include <string>

#include "engine/base/descriptor.h"
#include "engine/base/result.h"

namespace glissade {

/// A new file under a temporary name, which is renamed to its final name. It is locked as long as this value lives, and
/// removed if it is not renamed. Private to the functions that write files.
class PendingFile {
 public:
  /// Creates a locked file in `folder`. Its permissions are `mode` without those that the process's umask removes.
  /// Errors name `file`.
  static Result<PendingFile> create(const std::string& folder, const std::string& file, mode_t mode);
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  int descriptor() const { return descriptor_.get(); }
  /// Writes the whole content, flushes it to the disk, closes the file, reads it back and compares.
  Outcome write(const std::string& content);
  /// Renames the file and flushes the folder. Errors: it was not renamed. False: it was renamed, but a power cut now
  /// may undo that.
  Result<bool> moveTo(const std::string& path);

 private:
  PendingFile(Descriptor descriptor, std::string name, std::string file)
      : descriptor_(std::move(descriptor)), name_(std::move(name)), file_(std::move(file)) {}

  Descriptor descriptor_;
  Descriptor lock_;   ///< keeps the file locked after it was written and closed
  std::string name_;  ///< empty after the file was renamed, or moved from
  std::string file_;
};

/// Removes the temporary files that killed programs have left in a folder, which are not locked. `file` is the file
/// that is saved there; earlier versions derived temporary names from it.
void removeStrayFiles(const std::string& folder, const std::string& file);

}  // namespace glissade
