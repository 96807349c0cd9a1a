#include "engine/base/pending_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <random>
#include <utility>

#include "engine/base/file.h"
#include "engine/base/save_target.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Prefix of temporary names. It is short, because a name that is derived from the file's may become too long.
constexpr const char* kPrefix = ".glissade-saving-";
constexpr const char* kFormerInfix = ".saving-";
constexpr std::size_t kRandomLetters = 6;

std::string randomLetters() {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyz234567";
  std::random_device random;
  std::string letters;
  while (letters.size() < kRandomLetters) letters += kLetters[random() & 31U];
  return letters;
}

bool isTemporaryName(const std::string& name, const std::string& file) {
  const auto is = [&](const std::string& prefix) {
    return name.rfind(prefix, 0) == 0 && name.size() == prefix.size() + kRandomLetters;
  };
  return is(kPrefix) || is(fs::path(file).filename().string() + kFormerInfix);
}

/// Removes a temporary file whose writer has ended, so that it is not locked. Where the file system has no locks, it
/// stays.
void removeAbandoned(const std::string& path) {
  const Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (!descriptor.valid() || ::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  if (status.st_uid != ::geteuid() || ::flock(descriptor.get(), LOCK_EX | LOCK_NB) != 0) return;
  ::unlink(path.c_str());
}

/// Locks a new file. False if another save took it for abandoned before it was locked.
bool lock(const Descriptor& file) {
  if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  struct stat status {};
  return ::fstat(file.get(), &status) == 0 && status.st_nlink > 0;
}

}  // namespace

PendingFile::PendingFile(PendingFile&& other) noexcept
    : descriptor_(std::move(other.descriptor_)),
      lock_(std::move(other.lock_)),
      name_(std::exchange(other.name_, {})),
      file_(std::move(other.file_)) {}

Result<PendingFile> PendingFile::create(const std::string& folder, const std::string& file, mode_t mode) {
  constexpr int kMostTries = 100;
  for (int tries = 0; tries < kMostTries; ++tries) {
    std::string name = (fs::path(folder) / kPrefix).string() + randomLetters();
    Descriptor descriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    if (!descriptor.valid() && errno != EEXIST)
      return saveError(file, GLISSADE_TEXT("the folder takes no new file"), errno);
    if (descriptor.valid() && lock(descriptor)) return PendingFile(std::move(descriptor), std::move(name), file);
  }
  return saveError(file, GLISSADE_TEXT("the folder takes no new file"), EEXIST);
}

PendingFile::~PendingFile() {
  if (!name_.empty()) ::unlink(name_.c_str());
}

Outcome PendingFile::write(const std::string& content) {
  if (!writeAll(descriptor_.get(), content)) return saveError(file_, GLISSADE_TEXT("writing failed"), errno);
  if (::fsync(descriptor_.get()) != 0) return saveError(file_, GLISSADE_TEXT("flushing to the disk failed"), errno);
  lock_ =
      // The lock belongs to the open file, not to a descriptor.
      Descriptor(::fcntl(descriptor_.get(), F_DUPFD_CLOEXEC, 0));
  if (!lock_.valid() || !descriptor_.close()) return saveError(file_, GLISSADE_TEXT("closing failed"), errno);
  const auto written = readFile(name_, content.size());
  if (!written || *written != content)
    return saveError(file_, GLISSADE_TEXT("what was written reads back differently"), EIO);
  return Done{};
}

Result<bool> PendingFile::moveTo(const std::string& path) {
  if (::rename(name_.c_str(), path.c_str()) != 0)
    return saveError(file_, GLISSADE_TEXT("giving it its name failed"), errno);
  name_.clear();
  const Descriptor folder(::open(folderOf(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.valid()) return false;
  // Some file systems cannot flush a folder and return these errors.
  return ::fsync(folder.get()) == 0 || errno == EINVAL || errno == ENOTSUP;
}

void removeStrayFiles(const std::string& folder, const std::string& file) {
  std::error_code trouble;
  for (fs::directory_iterator at(folder, trouble), end; !trouble && at != end; at.increment(trouble)) {
    const std::string path = at->path().string();
    if (isTemporaryName(at->path().filename().string(), file)) removeAbandoned(path);
  }
}

}  // namespace glissade
