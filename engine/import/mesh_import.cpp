#include "engine/import/mesh_import.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "engine/base/file.h"
#include "engine/import/importer_process.h"

namespace glissade {
namespace {

constexpr std::array<const char*, 5> kEndings{"stl", "obj", "dae", "gltf", "glb"};

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

Result<ImportedMesh> decode(const ImporterCall& call, ImporterAnswer& answer) {
  std::vector<float> coordinates(std::size_t{3} * answer.header.vertices);
  std::array<float, 3> mean{};
  ImportedMesh result;
  result.mesh.triangles.resize(answer.header.triangles);
  if (!answer.message.take(coordinates.data(), coordinates.size()) || !answer.message.take(mean.data(), mean.size()) ||
      !answer.message.take(result.mesh.triangles.data(), result.mesh.triangles.size())) {
    return refusalOf(call, "the importer failed on it");
  }
  if (result.mesh.empty()) return refusalOf(call, "holds no triangle");
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    result.mesh.vertices.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  if (const auto fault = faultOf(result.mesh)) return refusalOf(call, *fault);
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
                      "Use STL, OBJ, DAE, glTF or GLB; \"step\" and \"urdf\" are shapes of their own in a scenario."};
  }
  ImporterCall call{"glissade-import", ending, file, import_protocol::kMeshLimits,
                    "Export the part again, for example as binary STL or GLB."};
  const auto content = readFile(file, call.limits.bytes);
  if (!content) return content.error();
  if (content->empty()) return refusalOf(call, "is empty");
  if (const auto lie = headerLie(ending, *content)) return refusalOf(call, *lie);
  if (isTruncatedTextStl(ending, *content)) return refusalOf(call, "ends before 'endsolid'");
  auto answer = callImporter(call);
  if (answer) return decode(call, *answer);
  Diagnostic why = answer.error();
  const bool external = why.reason.find("referenced file") != std::string::npos;
  if (external) why.advice = "Buffers in files of their own are not read: export it as one .glb file.";
  return why;
}

}  // namespace glissade
