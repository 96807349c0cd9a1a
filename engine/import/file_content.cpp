#include "engine/import/file_content.h"

#include <filesystem>
#include <string_view>

#include "engine/base/file.h"
#include "engine/import/import_limits.h"

namespace glissade {
namespace {

/// Text in the first line of a Git LFS pointer, which replaces a large file that was not fetched.
constexpr std::string_view kLfsPointer = "git-lfs.github.com/spec/";
constexpr std::size_t kFirstLine = 64;

}  // namespace

Result<FileContent> readContent(const std::string& file, std::uint64_t mostBytes) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (!unknown && size > mostBytes) {
    return Diagnostic{
        ErrorKind::MalformedInput,
        file,
        "",
        {GLISSADE_TEXT("is too large: it has %1, and at most %2 are read with the memory of this machine"),
         {sizeInWords(size), sizeInWords(mostBytes)}},
        GLISSADE_TEXT("Export fewer triangles, split the file, or use a machine with more free memory.")};
  }
  auto bytes = readFile(file, mostBytes);
  if (!bytes) return bytes.error();
  if (bytes->substr(0, kFirstLine).find(kLfsPointer) != std::string::npos) {
    return Diagnostic{ErrorKind::MalformedInput, file, "",
                      GLISSADE_TEXT("is a Git LFS pointer: the file itself was not fetched"),
                      GLISSADE_TEXT("Fetch it (git lfs pull), and load again.")};
  }
  return FileContent{file, std::move(bytes).value()};
}

}  // namespace glissade
