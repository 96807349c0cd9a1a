#include "engine/base/save_target.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

namespace glissade {
namespace {

namespace fs = std::filesystem;

CatalogueText adviceFor(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT: return GLISSADE_TEXT("Free some space, or save on another disk.");
    case EFBIG: return GLISSADE_TEXT("Raise the limit of the file size, or save on another disk.");
    case EACCES:
    case EPERM: return GLISSADE_TEXT("Save into a folder that you may write to.");
    case EROFS: return GLISSADE_TEXT("The file system is read-only. Save into another folder.");
    case ENAMETOOLONG: return GLISSADE_TEXT("Choose a shorter name.");
    case ENOENT:
    case ENOTDIR: return GLISSADE_TEXT("Create the folder, or choose another one.");
    case EIO: return GLISSADE_TEXT("The disk may be failing. Save on another disk.");
    default: return GLISSADE_TEXT("Save into another folder.");
  }
}

Diagnostic refused(const std::string& file, const Message& reason, const Message& advice) {
  return {ErrorKind::Unwritable,
          file,
          "",
          {GLISSADE_TEXT("cannot be saved: %1"), {reason}},
          {GLISSADE_TEXT("What was there is untouched. %1"), {advice}}};
}

Result<std::string> followLinks(const std::string& file) {
  constexpr int kMostLinks = 40;
  fs::path at = file;
  for (int i = 0; i < kMostLinks; ++i) {
    std::array<char, PATH_MAX> text{};
    const ssize_t length = ::readlink(at.c_str(), text.data(), text.size());
    if (length < 0) {
      if (errno == EINVAL || errno == ENOENT) return at.string();  // no link, or the file does not exist yet
      return saveError(file, GLISSADE_TEXT("it cannot be looked at"), errno);
    }
    at = at.parent_path() / fs::path(std::string(text.data(), static_cast<std::size_t>(length)));
  }
  return saveError(file, GLISSADE_TEXT("its links cannot be followed"), ELOOP);
}

Outcome checkKind(const std::string& file, const struct stat& status) {
  constexpr CatalogueText kOther = GLISSADE_TEXT("Choose another name.");
  if (S_ISDIR(status.st_mode)) return refused(file, GLISSADE_TEXT("it is a folder"), kOther);
  if (S_ISFIFO(status.st_mode)) return refused(file, GLISSADE_TEXT("it is a pipe"), kOther);
  if (S_ISSOCK(status.st_mode)) return refused(file, GLISSADE_TEXT("it is a socket"), kOther);
  if (!S_ISREG(status.st_mode)) return refused(file, GLISSADE_TEXT("it is a device"), kOther);
  return Done{};
}

/// Refuses read-only files. Replacing a file needs only a writable folder, but a person who made a file read-only
/// expects it to stay unchanged.
Outcome checkWritable(const SaveTarget& target) {
  constexpr mode_t kAnyWrite = S_IWUSR | S_IWGRP | S_IWOTH;
  const bool readOnly = (target.status.st_mode & kAnyWrite) == 0 || ::access(target.path.c_str(), W_OK) != 0;
  if (!readOnly) return Done{};
  return refused(target.file, GLISSADE_TEXT("it is read-only"),
                 GLISSADE_TEXT("Save under another name, or make the file writable."));
}

}  // namespace

bool SaveTarget::isSameAs(const struct stat& now) const {
  return exists && now.st_dev == status.st_dev && now.st_ino == status.st_ino && now.st_size == status.st_size &&
         now.st_mtim.tv_sec == status.st_mtim.tv_sec && now.st_mtim.tv_nsec == status.st_mtim.tv_nsec;
}

Result<SaveTarget> findSaveTarget(const std::string& file) {
  if (file.empty()) return refused(file, GLISSADE_TEXT("it has no name"), GLISSADE_TEXT("Give a name."));
  const auto path = followLinks(file);
  if (!path) return path.error();
  SaveTarget target{file, *path, false, {}};
  if (::stat(target.path.c_str(), &target.status) != 0) {
    if (errno == ENOENT) return target;
    return saveError(file, GLISSADE_TEXT("it cannot be looked at"), errno);
  }
  target.exists = true;
  const Outcome kind = checkKind(file, target.status);
  if (!kind) return kind.error();
  const Outcome writable = checkWritable(target);
  if (!writable) return writable.error();
  return target;
}

Diagnostic saveError(const std::string& file, const Message& what, int error) {
  return refused(file, {GLISSADE_TEXT("%1: %2"), {what, std::strerror(error)}}, adviceFor(error));
}

}  // namespace glissade
