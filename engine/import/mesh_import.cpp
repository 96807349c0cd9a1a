#include "engine/import/mesh_import.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/import/import_process.h"
#include "engine/import/input_file.h"
#include "engine/import/mesh_exchange.h"
#include "engine/import/sha256.h"

namespace glissade {
namespace {

constexpr std::array<std::string_view, 8> kEndings{"stl", "obj", "dae", "gltf", "glb", "3ds", "fbx", "x3d"};
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool startsWith(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

Diagnostic unsupported(const std::string& file) {
  return {ErrorKind::MalformedInput, file, "", "this kind of mesh file is not read",
          "Export it as STL, OBJ, Collada (.dae) or glTF (.glb)."};
}

/// A truncated text STL would silently lose its tail. Binary ones, which may begin with the same
/// word, hold zero bytes.
bool isTruncatedTextStl(std::string_view content, std::string_view ending) {
  const bool text = ending == "stl" && startsWith(content, "solid") && content.find('\0') == std::string_view::npos;
  return text && content.find("endsolid") == std::string_view::npos;
}

Vector3 meanInFloat(const std::vector<float>& coordinates) {
  std::array<float, 3> sum{};
  for (std::size_t i = 0; i < coordinates.size(); ++i) sum[i % 3] += coordinates[i];
  const auto count = static_cast<float>(coordinates.size() / 3);
  return {sum[0] / count, sum[1] / count, sum[2] / count};
}

/// `p` as the interpretation understands it: Z-up, metres.
Vector3 interpreted(const Vector3& p, const MeshInterpretation& interpretation) {
  const Vector3 upright = interpretation.up == UpAxis::Y ? Vector3(p.x(), -p.z(), p.y()) : p;
  return interpretation.unit * upright;
}

ImportedMesh toMesh(const MeshReply& reply, const MeshInterpretation& interpretation) {
  TriangleMesh mesh;
  mesh.vertices.reserve(reply.coordinates.size() / 3);
  for (std::size_t i = 0; i < reply.coordinates.size(); i += 3) {
    const Vector3 p(reply.coordinates[i], reply.coordinates[i + 1], reply.coordinates[i + 2]);
    mesh.vertices.push_back(interpreted(p, interpretation));
  }
  mesh.triangles.reserve(reply.corners.size() / 3);
  for (std::size_t i = 0; i < reply.corners.size(); i += 3) {
    mesh.triangles.push_back({reply.corners[i], reply.corners[i + 1], reply.corners[i + 2]});
  }
  return {welded(mesh), interpreted(meanInFloat(reply.coordinates), interpretation), ""};
}

}  // namespace

Result<ImportedMesh> importMesh(const std::string& file, const MeshInterpretation& interpretation) {
  const std::string ending = endingOf(file);
  if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) return unsupported(file);
  const Result<std::string> content = readInputFile(file, kLargestMeshFile);
  if (!content) return content.error();

  const auto inFile = [&](Diagnostic diagnostic) {
    if (diagnostic.file.empty()) diagnostic.file = file;
    const bool gltf = ending == "gltf" || ending == "glb";
    if (gltf && diagnostic.reason.find("referenced file") != std::string::npos) {
      diagnostic.advice = "Buffers in files of their own are not read: export it as one .glb file.";
    }
    return diagnostic;
  };
  std::string_view bytes = *content;
  if (isTruncatedTextStl(bytes, ending)) {
    return inFile({ErrorKind::MalformedInput, "", "", "the file ends before 'endsolid'", "Export it again."});
  }
  // Assimp drops the first line of an OBJ after a byte-order mark, and all indices shift.
  if (startsWith(bytes, kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());

  const Result<std::string> answer = runImportProcess(bytes, ending);
  if (!answer) return inFile(answer.error());
  const Result<MeshReply> reply = decodeMeshReply(*answer);
  if (!reply) return inFile(reply.error());
  ImportedMesh imported = toMesh(*reply, interpretation);
  if (imported.mesh.empty()) {
    return inFile({ErrorKind::MalformedInput, "", "", "every triangle is degenerate", "Export it again."});
  }
  imported.sha256 = sha256(*content);
  return imported;
}

}  // namespace glissade
