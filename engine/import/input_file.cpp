#include "engine/import/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace glissade {
namespace {

namespace fs = std::filesystem;

Diagnostic unreadable(const std::string& file, const std::string& reason, const std::string& advice) {
  return {ErrorKind::MalformedInput, file, "", reason, advice};
}

Diagnostic cannotOpen(const std::string& file, int error) {
  return unreadable(file, "the file cannot be read (" + std::string(std::strerror(error)) + ")",
                    "Check the name and the permissions.");
}

/// Closes a file descriptor at the end of its scope.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

bool leadsOut(const fs::path& folder, const fs::path& target) {
  const fs::path relative = target.lexically_relative(folder);
  return relative.empty() || *relative.begin() == "..";
}

}  // namespace

Result<std::string> readInputFile(const std::string& file, std::size_t largestBytes) {
  const OpenFile input(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (input.get() < 0) return cannotOpen(file, errno);
  struct stat status {};
  if (::fstat(input.get(), &status) != 0) return cannotOpen(file, errno);
  if (S_ISDIR(status.st_mode)) return unreadable(file, "this is a folder", "Give a file inside it.");
  if (!S_ISREG(status.st_mode)) return unreadable(file, "this is not a regular file", "Give a file on disk.");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > largestBytes) {
    return unreadable(file, "the file has " + std::to_string(size >> 20) + " MB",
                      "Files of this kind are read up to " + std::to_string(largestBytes >> 20) + " MB.");
  }
  std::string content(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::read(input.get(), content.data() + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannotOpen(file, errno);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  content.resize(done);
  if (content.empty()) return unreadable(file, "the file is empty", "Save or export it again.");
  return content;
}

bool isRelativeInside(const std::string& relative) {
  const fs::path path(relative);
  return !relative.empty() && relative.find_first_of(std::string_view("\\\0", 2)) == std::string::npos &&
         !path.is_absolute() && std::find(path.begin(), path.end(), "..") == path.end();
}

Result<std::string> resolveInside(const std::string& folder, const std::string& relative) {
  const auto refused = [&](const std::string& reason) {
    return Diagnostic{ErrorKind::MalformedInput, "", "", "'" + relative + "' " + reason,
                      "Give a path below the scenario's folder, with '/' between its parts."};
  };
  if (!isRelativeInside(relative)) return refused("leaves the folder, or is not a path separated by '/'");

  std::error_code error;
  const fs::path root = fs::weakly_canonical(folder, error);
  if (error) return refused("cannot be looked up (" + error.message() + ")");
  const fs::path target = fs::weakly_canonical(root / relative, error);
  if (error) return refused("cannot be looked up (" + error.message() + ")");
  if (leadsOut(root, target)) return refused("leads out of the folder through a link");
  return (fs::path(folder) / relative).string();
}

std::string folderOf(const std::string& file) {
  const std::string folder = fs::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string endingOf(const std::string& file) {
  std::string ending = fs::path(file).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace glissade
