#include "engine/scenario/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "engine/import/input_file.h"

namespace glissade {
namespace {

/// A file beside the target that disappears unless it is renamed over it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : name_(target + ".XXXXXX") {
    descriptor_ = ::mkostemp(name_.data(), O_CLOEXEC);
  }
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool exists() const { return descriptor_ >= 0; }

  bool write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0;
  }

  bool holds(std::string_view content) const {
    if (content.empty()) return std::filesystem::file_size(name_) == 0;
    const Result<std::string> readBack = readInputFile(name_, content.size());
    return readBack && *readBack == content;
  }

  /// mkostemp makes private files; a saved file has the permissions of the one before, or the usual.
  bool setModeLike(const std::string& target) const {
    struct stat status {};
    const mode_t mode = ::stat(target.c_str(), &status) == 0 ? status.st_mode & 0777 : 0644;
    return ::fchmod(descriptor_, mode) == 0;
  }

  bool renameTo(const std::string& target) {
    renamed_ = ::rename(name_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

bool syncFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool synced = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return synced;
}

}  // namespace

Outcome writeFileAtomically(const std::string& file, std::string_view content) {
  const auto failed = [&](const std::string& what) {
    return Diagnostic{ErrorKind::Internal, file, "", what + " (" + std::strerror(errno) + ")",
                      "Nothing was changed; check the folder and the space on the disk, and save again."};
  };
  std::error_code error;
  const auto linked = std::filesystem::canonical(file, error);  // a link stays a link
  const std::string target = error ? file : linked.string();
  if (std::filesystem::exists(target, error) && !std::filesystem::is_regular_file(target, error)) {
    errno = EINVAL;
    return failed("the file cannot be replaced: it is not a regular file");
  }
  TemporaryFile temporary(target);
  if (!temporary.exists()) return failed("the file cannot be written");
  if (!temporary.write(content)) return failed("the file cannot be written");
  if (!temporary.holds(content)) return failed("the file reads back differently");
  if (!temporary.setModeLike(target)) return failed("the permissions cannot be set");
  if (!temporary.renameTo(target)) return failed("the file cannot be replaced");
  if (!syncFolder(folderOf(target))) return failed("the folder cannot be synced");
  return Done{};
}

}  // namespace glissade
