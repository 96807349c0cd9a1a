#include "engine/import/file_content.h"

#include <filesystem>

#include "engine/base/file.h"
#include "engine/import/import_limits.h"

namespace glissade {

Result<FileContent> readContent(const std::string& file, std::uint64_t mostBytes) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (!unknown && size > mostBytes) {
    return Diagnostic{ErrorKind::MalformedInput, file, "",
                      "is too large: it has " + sizeInWords(size) + ", and at most " + sizeInWords(mostBytes) +
                          " are read with the memory of this machine",
                      "Export fewer triangles, split the file, or use a machine with more free memory."};
  }
  auto bytes = readFile(file, mostBytes);
  if (!bytes) return bytes.error();
  return FileContent{file, std::move(bytes).value()};
}

}  // namespace glissade
