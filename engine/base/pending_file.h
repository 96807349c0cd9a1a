#pragma once

#include <sys/types.h>

#include <string>

#include "engine/base/descriptor.h"
#include "engine/base/result.h"

namespace glissade {

/// A new file under a temporary name, which a rename makes the file that is needed. It is locked for as long as this
/// value lives, and removed where it is not renamed. Private to the functions that write files.
class PendingFile {
 public:
  /// A locked file in `folder`. Its permissions are `mode` without those that the process's umask takes away.
  /// Errors name `file`.
  static Result<PendingFile> create(const std::string& folder, const std::string& file, mode_t mode);
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  int descriptor() const { return descriptor_.get(); }
  /// Writes the whole content, flushes it to the disk, closes the file, reads it back and compares.
  Outcome write(const std::string& content);
  /// Gives it the name and flushes the folder. Errors: the name was not given. False: it was given, but a
  /// power cut now may undo that.
  Result<bool> moveTo(const std::string& path);

 private:
  PendingFile(Descriptor descriptor, std::string name, std::string file)
      : descriptor_(std::move(descriptor)), name_(std::move(name)), file_(std::move(file)) {}

  Descriptor descriptor_;
  Descriptor lock_;   ///< keeps the file locked once it was written and closed
  std::string name_;  ///< empty once it was renamed, or was moved from
  std::string file_;
};

/// Removes the temporary files in a folder that killed programs have left: those that nobody holds locked. `file` is
/// the file that is saved there; former versions derived names from it.
void removeStrayFiles(const std::string& folder, const std::string& file);

}  // namespace glissade
