#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/base/result.h"

namespace glissade {

/// What a save has come to.
enum class SaveStatus {
  Saved,            ///< the new content is there
  ChangedByOthers,  ///< nothing was done: the file does not hold the content that may be replaced
  RemovedByOthers,  ///< nothing was done: there is no file any more
  Failed            ///< the old content is there
};

struct SaveOptions {
  /// SHA-256 of the only content that may be replaced: what the user has seen last. Nothing: any content.
  std::optional<std::string> replaces;
  /// How many earlier versions of the file are kept (file_versions.h).
  int versions = 0;
  /// Do not save where the earlier version cannot be kept; else that is a warning.
  bool versionRequired = false;
};

struct SaveResult {
  SaveStatus status = SaveStatus::Failed;
  Diagnostic why;      ///< of everything but Saved
  Warnings warnings;   ///< of Saved: what is not as the user may expect it
  std::string sha256;  ///< of Saved: of the content

  bool ok() const { return status == SaveStatus::Saved; }
  explicit operator bool() const { return ok(); }
};

/// Nothing was saved: what was to be written could not be made.
inline SaveResult notSaved(Diagnostic why) { return {SaveStatus::Failed, std::move(why), {}, {}}; }

/// Replaces the content of a file. After any failure, kill or power cut either the old or the new content is
/// there as a whole: a new file is written beside it, flushed, read back and compared, and renamed; then the
/// folder is flushed. Symbolic links stay and lead to the new content. Permissions, owner and access list are
/// kept; what cannot be kept is a warning. Refused: folders, pipes, devices and read-only files.
/// Of any thread.
SaveResult saveFile(const std::string& file, const std::string& content, const SaveOptions& options = {});
/// The same, whatever the file holds. The warnings are added to `warnings`. writeFileAtomically() drops them: it is
/// for files that only this program writes.
Outcome saveFile(const std::string& file, const std::string& content, Warnings& warnings);

}  // namespace glissade
