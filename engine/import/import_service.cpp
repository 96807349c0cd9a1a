#include "engine/import/import_service.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <string_view>

#include "engine/import/assimp_reader.h"
#include "engine/import/import_process.h"
#include "engine/import/sandbox.h"

namespace glissade {
namespace {

std::optional<std::string> readAll(int descriptor) {
  std::string content;
  std::array<char, 65536> block;
  while (true) {
    const ssize_t got = ::read(descriptor, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) return content;
    content.append(block.data(), static_cast<std::size_t>(got));
  }
}

bool writeAll(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

int serveImport(const std::string& ending) {
  if (!enterSandbox(kImportSeconds)) {
    writeAll(STDOUT_FILENO, encode({"this system refuses the limits that imports are run under", {}, {}}));
    return 1;
  }
  const std::optional<std::string> content = readAll(STDIN_FILENO);
  if (!content) return 1;
  const MeshReply reply = readMeshWithAssimp(*content, ending);
  return writeAll(STDOUT_FILENO, encode(reply)) ? 0 : 1;
}

}  // namespace glissade
