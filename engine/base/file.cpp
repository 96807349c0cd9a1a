#include "engine/base/file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace glissade {
namespace {

/// Closes a file descriptor at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }

 private:
  int fd_;
};

Diagnostic unreadable(const std::string& file, const std::string& reason, const std::string& advice) {
  return {ErrorKind::MalformedInput, file, "", reason, advice};
}

Diagnostic unwritable(const std::string& file, const std::string& what) {
  return {ErrorKind::Internal, file, "", "cannot be saved: " + what + ": " + std::strerror(errno),
          "The old content is untouched. Free some space or choose another folder."};
}

Result<std::string> readAll(int fd, const std::string& file, std::size_t mostBytes) {
  std::string content;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(fd, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(file, std::string("cannot be read: ") + std::strerror(errno), "");
    if (count == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(count));
    if (content.size() > mostBytes) return unreadable(file, "is too large", "Give a file of its kind.");
  }
}

/// Permissions of the file that is replaced, or the usual ones.
mode_t modeFor(const std::string& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? status.st_mode & 0777 : 0644;
}

bool writeAll(int fd, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::write(fd, content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

Result<std::string> readFile(const std::string& file, std::size_t mostBytes) {
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!descriptor.valid()) {
    return unreadable(file, std::string("cannot be opened: ") + std::strerror(errno), "Check the name and the folder.");
  }
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    return unreadable(file, "is not a regular file", "Give a file, not a folder, a pipe or a device.");
  }
  return readAll(descriptor.get(), file, mostBytes);
}

Outcome writeFileAtomically(const std::string& file, const std::string& content) {
  std::error_code notThereYet;
  const auto followed = std::filesystem::canonical(file, notThereYet);  // a link stays a link
  const std::string target = notThereYet ? file : followed.string();
  std::string beside = target + ".saving-XXXXXX";
  const auto failed = [&](const std::string& what) {
    const Diagnostic why = unwritable(file, what);
    ::unlink(beside.c_str());
    return why;
  };
  {
    const Descriptor descriptor(::mkostemp(beside.data(), O_CLOEXEC));
    if (!descriptor.valid()) return unwritable(file, "the folder refuses a new file");
    if (::fchmod(descriptor.get(), modeFor(target)) != 0) return failed("setting its permissions");
    if (!writeAll(descriptor.get(), content)) return failed("writing");
    if (::fsync(descriptor.get()) != 0) return failed("flushing");
  }
  const auto written = readFile(beside, content.size());
  if (!written || *written != content) return failed("what was written reads back differently");
  if (::rename(beside.c_str(), target.c_str()) != 0) return failed("renaming");
  const Descriptor folder(::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.valid()) ::fsync(folder.get());
  return Done{};
}

std::string sha256(const std::string& content) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr);
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

std::string folderOf(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string endingOf(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

}  // namespace glissade
