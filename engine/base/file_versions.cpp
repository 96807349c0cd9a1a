#include "engine/base/file_versions.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/base/pending_file.h"
#include "engine/base/save_target.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = ".earlier-versions";

fs::path versionsFolder(const std::string& file) {
  return fs::path(folderOf(file)) / kFolder / fs::path(file).filename();
}

/// The number at the beginning of a version's name; 0 for other files.
int numberOf(const std::string& name) {
  int number = 0;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool ours = parsed.ec == std::errc() && parsed.ptr != name.data() + name.size() && *parsed.ptr == '_';
  return ours && number > 0 ? number : 0;
}

std::string nameOf(int number, std::time_t time, const std::string& file) {
  std::tm utc{};
  ::gmtime_r(&time, &utc);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%06d_", number);
  std::string name = text.data();
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H-%M-%SZ", &utc);
  return name + text.data() + fs::path(file).extension().string();
}

Outcome makeFolder(const fs::path& folder, const std::string& file) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (!trouble) return Done{};
  return saveError(file, GLISSADE_TEXT("its folder of earlier versions cannot be made"), trouble.value());
}

}  // namespace

std::vector<FileVersion> earlierVersions(const std::string& file) {
  std::vector<FileVersion> versions;
  std::error_code trouble;
  for (fs::directory_iterator at(versionsFolder(file), trouble), end; !trouble && at != end; at.increment(trouble)) {
    const int number = numberOf(at->path().filename().string());
    struct stat status {};
    if (number == 0 || ::stat(at->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    versions.push_back({at->path().string(), number, status.st_mtim.tv_sec});
  }
  std::sort(versions.begin(), versions.end(),
            [](const FileVersion& a, const FileVersion& b) { return a.number > b.number; });
  return versions;
}

Outcome keepVersion(const std::string& file, const std::string& content, const struct stat& status) {
  const fs::path folder = versionsFolder(file);
  const Outcome made = makeFolder(folder, file);
  if (!made) return made;
  const std::vector<FileVersion> versions = earlierVersions(file);
  if (!versions.empty()) {
    const auto latest = readFile(versions.front().path, content.size());
    if (latest && *latest == content) return Done{};
  }
  removeStrayFiles(folder.string(), file);
  auto pending = PendingFile::create(folder.string(), file, 0600);
  if (!pending) return pending.error();
  if (::fchmod(pending->descriptor(), status.st_mode & 0777) != 0) {
    return saveError(file, GLISSADE_TEXT("the permissions of its earlier version cannot be set"), errno);
  }
  const Outcome written = pending->write(content);
  if (!written) return written;
  const int number = versions.empty() ? 1 : versions.front().number + 1;
  const std::string path = (folder / nameOf(number, status.st_mtim.tv_sec, file)).string();
  const auto moved = pending->moveTo(path);
  if (!moved) return moved.error();
  if (!*moved) return saveError(file, GLISSADE_TEXT("its earlier version cannot be flushed to the disk"), EIO);
  const std::array<timespec, 2> times{timespec{0, UTIME_OMIT}, status.st_mtim};
  (void)::utimensat(AT_FDCWD, path.c_str(), times.data(), 0);  // ignored: the name has the time, too
  return Done{};
}

void removeOldVersions(const std::string& file, int kept) {
  const std::vector<FileVersion> versions = earlierVersions(file);
  for (std::size_t i = static_cast<std::size_t>(kept); i < versions.size(); ++i) {
    std::error_code ignored;
    fs::remove(versions[i].path, ignored);
  }
}

}  // namespace glissade
