#include "engine/base/file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "engine/base/descriptor.h"
#include "engine/base/reserve_filled.h"

namespace glissade {
namespace {

Diagnostic unreadable(const std::string& file, const Message& reason, const Message& advice) {
  return {ErrorKind::MalformedInput, file, "", reason, advice};
}

/// `expected`: expected number of bytes; the file may hold more.
Result<std::string> readAll(int fd, const std::string& file, std::size_t mostBytes, std::size_t expected) {
  std::string content;
  reserveFilled(content, std::min(expected, mostBytes));
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(fd, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(file, {GLISSADE_TEXT("cannot be read: %1"), {std::strerror(errno)}}, {});
    if (count == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(count));
    if (content.size() > mostBytes)
      return unreadable(file, GLISSADE_TEXT("is too large"), GLISSADE_TEXT("Give a file of its kind."));
  }
}

}  // namespace

Result<std::string> readFile(const std::string& file, std::size_t mostBytes) {
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!descriptor.valid()) {
    return unreadable(file, {GLISSADE_TEXT("cannot be opened: %1"), {std::strerror(errno)}},
                      GLISSADE_TEXT("Check the name and the folder."));
  }
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    return unreadable(file, GLISSADE_TEXT("is not a regular file"),
                      GLISSADE_TEXT("Give a file, not a folder, a pipe or a device."));
  }
  return readAll(descriptor.get(), file, mostBytes, static_cast<std::size_t>(status.st_size));
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
