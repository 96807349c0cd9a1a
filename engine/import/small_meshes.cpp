#include "engine/import/small_meshes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "engine/base/file.h"
#include "engine/base/in_threads.h"
#include "engine/import/mesh_answer.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

constexpr std::uint64_t kMostBytes = 256U << 10U;
/// Largest number of files in one process.
constexpr std::size_t kMostFiles = 64;
/// Collada is excluded: another project's library reads it, and a captured process could falsify the other files.
constexpr std::array<const char*, 5> kSmallEndings{"stl", "obj", "ply", "gltf", "glb"};

std::string inputOf(const std::vector<FileContent>& files, std::size_t first, std::size_t end) {
  std::string input;
  for (std::size_t i = first; i < end; ++i) {
    protocol::SmallFile file;
    file.bytes = files[i].bytes.size();
    const std::string ending = endingOf(files[i].file);
    std::copy_n(ending.begin(), std::min(ending.size(), sizeof file.ending), file.ending);
    input.append(reinterpret_cast<const char*>(&file), sizeof file);
    input += files[i].bytes;
  }
  return input;
}

/// The next message, if it is a mesh.
std::optional<ImportedMesh> nextMesh(const FileContent& file, ImportMessage& message) {
  protocol::Header header;
  if (!message.take(&header, 1) || header.magic != protocol::kMagic) return std::nullopt;
  if (header.kind == protocol::kError) {
    std::string reason;
    (void)message.takeText(header.vertices, reason);
    return std::nullopt;
  }
  if (header.kind != protocol::kMesh || header.vertices > protocol::kMostElements ||
      header.triangles > protocol::kMostElements) {
    return std::nullopt;
  }
  auto mesh = decodeMeshAnswer(meshImporterCall("", file.file, file.bytes.size()), header, message);
  return mesh ? std::optional(std::move(*mesh)) : std::nullopt;
}

}  // namespace

bool isSmallMesh(const std::string& file, std::uint64_t bytes) {
  const std::string ending = endingOf(file);
  return bytes > 0 && bytes <= kMostBytes &&
         std::find(kSmallEndings.begin(), kSmallEndings.end(), ending) != kSmallEndings.end();
}

std::vector<std::optional<ImportedMesh>> importSmallMeshes(const std::vector<FileContent>& files,
                                                           const StopToken& stop) {
  std::vector<std::optional<ImportedMesh>> meshes(files.size());
  const std::size_t calls = (files.size() + kMostFiles - 1) / kMostFiles;
  forEachInThreads(calls, 1, [&](std::size_t call) {
    if (stop.stopRequested()) return;
    const std::size_t first = call * kMostFiles;
    const std::size_t end = std::min(files.size(), first + kMostFiles);
    const ImporterCall importer = meshImporterCall(protocol::kSeveral, files[first].file, kMostBytes);
    ImportMessage message(callImporterOfSeveral(importer, inputOf(files, first, end), stop));
    for (std::size_t i = first; i < end; ++i) meshes[i] = nextMesh(files[i], message);
  });
  return meshes;
}

}  // namespace glissade
