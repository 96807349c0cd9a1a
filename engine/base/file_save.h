#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/base/result.h"

namespace glissade {

/// Result of a save.
enum class SaveStatus {
  Saved,            ///< the file has the new content
  ChangedByOthers,  ///< nothing was written: the file does not have the content that may be replaced
  RemovedByOthers,  ///< nothing was written: the file does not exist any more
  Failed            ///< the file has the old content
};

struct SaveOptions {
  /// SHA-256 of the only content that may be replaced, which the user has seen last. Nothing: any content.
  std::optional<std::string> replaces;
  /// Number of earlier versions of the file that are kept (file_versions.h).
  int versions = 0;
  /// True: nothing is saved if the earlier version cannot be kept. False: that is a warning.
  bool versionRequired = false;
};

struct SaveResult {
  SaveStatus status = SaveStatus::Failed;
  Diagnostic why;      ///< reason, unless the status is Saved
  Warnings warnings;   ///< for Saved: properties of the file that could not be kept
  std::string sha256;  ///< for Saved: hash of the content

  bool ok() const { return status == SaveStatus::Saved; }
  explicit operator bool() const { return ok(); }
};

/// The result where the content could not be made.
inline SaveResult notSaved(Diagnostic why) { return {SaveStatus::Failed, std::move(why), {}, {}}; }

/// Replaces the content of a file. After any failure, kill or power cut the file has either the complete old or the
/// complete new content: a new file is written beside it, flushed, read back and compared, and renamed; then the folder
/// is flushed. Symbolic links stay and lead to the new content. Permissions, owner and access list are kept; a loss of
/// these is a warning. Refused: folders, pipes, devices and read-only files. On any thread.
SaveResult saveFile(const std::string& file, const std::string& content, const SaveOptions& options = {});
/// saveFile() for any present content. The warnings are added to `warnings`. writeFileAtomically() drops them: it is
/// for files that only this program writes.
Outcome saveFile(const std::string& file, const std::string& content, Warnings& warnings);

}  // namespace glissade
