#include "engine/import/mesh_import.h"

#include <algorithm>
#include <array>

#include "engine/base/file.h"
#include "engine/import/import_limits.h"
#include "engine/import/importer_process.h"
#include "engine/import/mesh_answer.h"
#include "engine/import/unread_kind.h"

namespace glissade {
namespace {

constexpr std::array<const char*, 6> kEndings{"stl", "obj", "ply", "dae", "gltf", "glb"};

Diagnostic unknownKind(const std::string& file) {
  if (const auto known = unreadKind(file)) return *known;
  return {ErrorKind::MalformedInput,
          file,
          "",
          {GLISSADE_TEXT("is of a kind that is not read ('%1')"), {endingOf(file)}},
          GLISSADE_TEXT(
              "Use STL, OBJ, PLY, DAE, glTF or GLB; \"step\" and \"urdf\" are shapes of their own in a scenario.")};
}

}  // namespace

bool isMeshFile(const std::string& file) {
  const std::string ending = endingOf(file);
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

Result<ImportedMesh> importMesh(const FileContent& content, const StopToken& stop) {
  const std::string ending = endingOf(content.file);
  if (!isMeshFile(content.file)) return unknownKind(content.file);
  const ImporterCall call = meshImporterCall(ending, content.file, content.bytes.size());
  if (content.bytes.empty()) return refusalOf(call, GLISSADE_TEXT("is empty"));
  auto answer = callImporter(call, content.bytes, stop);
  if (answer) return decodeMeshAnswer(call, answer->header, answer->message);
  Diagnostic why = answer.error();
  const bool external = toString(why.reason).find("file of its own") != std::string::npos;
  if (external) {
    why.advice = GLISSADE_TEXT("Buffers in files of their own are not read: export it as one .glb file.");
  }
  return why;
}

Result<ImportedMesh> importMesh(const std::string& file, const StopToken& stop) {
  if (!isMeshFile(file)) return unknownKind(file);
  const auto content = readContent(file, mostFileBytes());
  if (!content) return content.error();
  return importMesh(*content, stop);
}

}  // namespace glissade
