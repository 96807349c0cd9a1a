#include "engine/base/file_save.h"

#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/base/file.h"
#include "engine/base/file_versions.h"
#include "engine/base/pending_file.h"
#include "engine/base/save_target.h"

namespace glissade {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

Diagnostic warning(const SaveTarget& target, const Message& reason, const Message& advice) {
  return {ErrorKind::Unwritable, target.file, "", {GLISSADE_TEXT("was saved, but %1"), {reason}}, advice};
}

SaveResult changed(const SaveTarget& target) {
  return {SaveStatus::ChangedByOthers,
          {ErrorKind::Usage, target.file, "",
           GLISSADE_TEXT("was not saved: another program has changed the file since it was read"),
           GLISSADE_TEXT("Save under another name, or open the file again.")},
          {},
          {}};
}

SaveResult removed(const SaveTarget& target) {
  return {SaveStatus::RemovedByOthers,
          {ErrorKind::Usage, target.file, "",
           GLISSADE_TEXT("was not saved: the file has been removed or renamed since it was read"),
           GLISSADE_TEXT("Save under another name.")},
          {},
          {}};
}

/// Copies the access list. False where one exists and cannot be copied; most files have none.
bool copyAccessList(const std::string& from, int to) {
  constexpr const char* kName = "system.posix_acl_access";
  std::string list(4096, '\0');
  const ssize_t size = ::getxattr(from.c_str(), kName, list.data(), list.size());
  if (size < 0) return errno == ENODATA || errno == ENOTSUP;
  return ::fsetxattr(to, kName, list.data(), static_cast<std::size_t>(size), 0) == 0;
}

/// Gives the new file the owner, permissions and access list of the replaced one. Error: the permissions cannot be set;
/// they may protect the content.
Outcome copyRights(const SaveTarget& target, int to, Warnings& warnings) {
  const struct stat& old = target.status;
  const auto user = static_cast<uid_t>(-1);
  const bool sameOwner = ::fchown(to, old.st_uid, old.st_gid) == 0;
  if (!sameOwner) {
    const bool sameGroup = ::fchown(to, user, old.st_gid) == 0;
    const bool wasOurs = old.st_uid == ::geteuid();
    const CatalogueText what = wasOurs     ? GLISSADE_TEXT("its group")
                               : sameGroup ? GLISSADE_TEXT("its owner")
                                           : GLISSADE_TEXT("its owner and group");
    if (!wasOurs || !sameGroup) {
      warnings.push_back(warning(target, {GLISSADE_TEXT("%1 could not be kept"), {what}},
                                 GLISSADE_TEXT("Ask the former owner if others read the file.")));
    }
  }
  if (::fchmod(to, old.st_mode & 0777) != 0)
    return saveError(target.file, GLISSADE_TEXT("its permissions cannot be set"), errno);
  if (!copyAccessList(target.path, to)) {
    warnings.push_back(
        warning(target, GLISSADE_TEXT("its access control list could not be kept"), GLISSADE_TEXT("Set it again.")));
  }
  return Done{};
}

void warnOfHardLinks(const SaveTarget& target, Warnings& warnings) {
  if (!target.exists || target.status.st_nlink < 2) return;
  warnings.push_back(warning(
      target,
      {GLISSADE_TEXT(
           "the file has %1 more {1|name (hard link), which keeps|names (hard links), which keep} the old content"),
       {target.status.st_nlink - 1}},
      GLISSADE_TEXT("Copy the file over them, or link them again.")));
}

/// The present content, if it is needed.
Result<std::optional<std::string>> presentContent(const SaveTarget& target, const SaveOptions& options) {
  if (!target.exists || (!options.replaces && options.versions == 0)) return std::optional<std::string>();
  auto content = readFile(target.path, kMostBytes);
  if (content) return std::optional<std::string>(std::move(*content));
  Diagnostic why = content.error();
  why.kind = ErrorKind::Unwritable;
  why.file = target.file;
  why.reason = {GLISSADE_TEXT("cannot be saved over the present file: %1"), {why.reason}};
  return why;
}

/// True if the file was not changed while the new content was written, which takes time.
bool isUntouched(const SaveTarget& target) {
  struct stat now {};
  if (::stat(target.path.c_str(), &now) != 0) return !target.exists;
  return target.isSameAs(now);
}

SaveResult replace(const SaveTarget& target, const std::string& content, const SaveOptions& options,
                   Warnings warnings) {
  constexpr mode_t kUntilItsOwnersAreKnown = 0600;
  constexpr mode_t kNewFile = 0666;
  auto pending =
      PendingFile::create(folderOf(target.path), target.file, target.exists ? kUntilItsOwnersAreKnown : kNewFile);
  if (!pending) return notSaved(pending.error());
  if (target.exists) {
    const Outcome rights = copyRights(target, pending->descriptor(), warnings);
    if (!rights) return notSaved(rights.error());
  }
  const Outcome written = pending->write(content);
  if (!written) return notSaved(written.error());
  if (options.replaces && !isUntouched(target)) return changed(target);
  const auto durable = pending->moveTo(target.path);
  if (!durable) return notSaved(durable.error());
  if (!*durable) {
    warnings.push_back(warning(target, GLISSADE_TEXT("its folder could not be flushed to the disk"),
                               GLISSADE_TEXT("After a power failure the file may have its old content. Save again.")));
  }
  return {SaveStatus::Saved, {}, std::move(warnings), sha256(content)};
}

}  // namespace

SaveResult saveFile(const std::string& file, const std::string& content, const SaveOptions& options) {
  const auto target = findSaveTarget(file);
  if (!target) return notSaved(target.error());
  if (!target->exists && options.replaces) return removed(*target);
  Warnings warnings;
  const auto present = presentContent(*target, options);
  if (!present && (options.replaces || options.versionRequired)) return notSaved(present.error());
  if (!present)
    warnings.push_back(
        warning(*target, GLISSADE_TEXT("no earlier version was kept"), GLISSADE_TEXT("It could not be read.")));
  const bool known = present && present->has_value();
  if (known && options.replaces && sha256(**present) != *options.replaces) return changed(*target);
  removeStrayFiles(folderOf(target->path), target->path);
  if (known && options.versions > 0 && **present != content) {
    const Outcome kept = keepVersion(target->path, **present, target->status);
    if (!kept && options.versionRequired) return notSaved(kept.error());
    if (!kept)
      warnings.push_back(
          warning(*target, {GLISSADE_TEXT("no earlier version was kept: %1"), {kept.error().reason}}, {}));
  }
  warnOfHardLinks(*target, warnings);
  SaveResult result = replace(*target, content, options, std::move(warnings));
  if (result && options.versions > 0) removeOldVersions(target->path, options.versions);
  return result;
}

Outcome saveFile(const std::string& file, const std::string& content, Warnings& warnings) {
  const SaveResult result = saveFile(file, content);
  if (!result) return result.why;
  warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
  return Done{};
}

Outcome writeFileAtomically(const std::string& file, const std::string& content) {
  const SaveResult result = saveFile(file, content);
  return result ? Outcome(Done{}) : Outcome(result.why);
}

}  // namespace glissade
