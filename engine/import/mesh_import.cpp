#include "engine/import/mesh_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>

#include "engine/base/file.h"
#include "engine/import/child_process.h"
#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

constexpr std::array<const char*, 5> kEndings{"stl", "obj", "dae", "gltf", "glb"};

Diagnostic malformed(const std::string& file, const std::string& reason) {
  return {ErrorKind::MalformedInput, file, "", reason, "Export the part again, for example as binary STL or GLB."};
}

std::string importerProgram() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return (self.parent_path() / "glissade-import").string();
}

/// Takes plain arrays out of what the child wrote, without trusting any of it.
class Message {
 public:
  explicit Message(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  bool take(T* values, std::size_t count) {
    const std::size_t size = count * sizeof(T);
    if (bytes_.size() - position_ < size) return false;
    std::memcpy(values, bytes_.data() + position_, size);
    position_ += size;
    return true;
  }

  std::string rest() const { return bytes_.substr(position_); }

 private:
  const std::string& bytes_;
  std::size_t position_ = 0;
};

/// A truncated text STL would silently lose its tail. Binary ones, which may begin with the same
/// word, hold zero bytes.
bool isTruncatedTextStl(const std::string& ending, const std::string& content) {
  const bool text = ending == "stl" && content.rfind("solid", 0) == 0 && content.find('\0') == std::string::npos;
  return text && content.find("endsolid") == std::string::npos;
}

/// STL claims its size in a header: believe the file's length instead, before anything is allocated.
std::optional<std::string> headerLie(const std::string& ending, const std::string& content) {
  constexpr std::size_t kHeader = 84;
  constexpr std::size_t kTriangle = 50;
  if (ending != "stl" || content.rfind("solid", 0) == 0) return std::nullopt;
  if (content.size() < kHeader) return "is too short for an STL file";
  std::uint32_t claimed = 0;
  std::memcpy(&claimed, content.data() + 80, sizeof claimed);
  if ((content.size() - kHeader) / kTriangle >= claimed) return std::nullopt;
  return "claims " + std::to_string(claimed) + " triangles but is only " + std::to_string(content.size()) +
         " bytes long";
}

Result<ImportedMesh> decode(const std::string& file, const std::string& output) {
  Message message(output);
  protocol::Header header;
  if (!message.take(&header, 1) || header.magic != protocol::kMagic)
    return malformed(file, "the importer failed on it");
  if (header.kind == protocol::kError) {
    Diagnostic why = malformed(file, "cannot be read: " + message.rest());
    const bool external = why.reason.find("referenced file") != std::string::npos;
    if (external) why.advice = "Buffers in files of their own are not read: export it as one .glb file.";
    return why;
  }
  if (header.vertices > protocol::kMostElements || header.triangles > protocol::kMostElements) {
    return malformed(file, "is too large");
  }
  std::vector<float> coordinates(std::size_t{3} * header.vertices);
  std::array<float, 3> mean{};
  std::vector<TriangleIndices> triangles(header.triangles);
  if (!message.take(coordinates.data(), coordinates.size()) || !message.take(mean.data(), mean.size()) ||
      !message.take(triangles.data(), triangles.size())) {
    return malformed(file, "the importer failed on it");
  }
  if (triangles.empty()) return malformed(file, "holds no triangle");
  constexpr float kLargestCoordinate = 1e9F;
  const auto sane = [](float x) { return std::isfinite(x) && std::abs(x) <= kLargestCoordinate; };
  if (!std::all_of(coordinates.begin(), coordinates.end(), sane)) {
    return malformed(file, "has a vertex that is not a finite number, or beyond all measure");
  }
  for (const auto& triangle : triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) >= header.vertices) {
      return malformed(file, "has a triangle with a corner that does not exist");
    }
  }
  ImportedMesh result;
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    result.mesh.vertices.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  result.mesh.triangles = std::move(triangles);
  result.vertexMean = Vector3(mean[0], mean[1], mean[2]);
  return result;
}

}  // namespace

bool isMeshFile(const std::string& file) {
  const std::string ending = endingOf(file);
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

Result<ImportedMesh> importMesh(const std::string& file) {
  const std::string ending = endingOf(file);
  if (!isMeshFile(file)) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", "is of a kind that is not read ('" + ending + "')",
                      "Use STL, OBJ, DAE, glTF or GLB."};
  }
  const auto content = readFile(file, protocol::kMostBytes);
  if (!content) return content.error();
  if (content->empty()) return malformed(file, "is empty");
  if (const auto lie = headerLie(ending, *content)) return malformed(file, *lie);
  if (isTruncatedTextStl(ending, *content)) return malformed(file, "ends before 'endsolid'");
  const std::size_t mostOutput = sizeof(protocol::Header) + std::size_t{24} * protocol::kMostElements + 64;
  const auto child = runChild(importerProgram(), {ending}, file, std::chrono::milliseconds(4500), mostOutput);
  if (!child) return child.error();
  if (child->timedOut) return malformed(file, "takes too long to read: it is too complex or malformed");
  if (child->signal != 0) return malformed(file, "is malformed (the importer stopped on it)");
  return decode(file, child->output);
}

}  // namespace glissade
