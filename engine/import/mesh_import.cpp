#include "engine/import/mesh_import.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/base/reserve_filled.h"
#include "engine/import/import_limits.h"
#include "engine/import/importer_process.h"

namespace glissade {
namespace {

constexpr std::array<const char*, 6> kEndings{"stl", "obj", "ply", "dae", "gltf", "glb"};

/// Largest share of a part's diagonal that the spacing of its coordinates may be.
constexpr double kCoarsestSpacing = 1e-4;

std::optional<Diagnostic> refuseCoarseCoordinates(const ImporterCall& call, const ImportedMesh& imported) {
  const double diagonal = boundingBox(imported.mesh).diagonal().norm();
  if (imported.coordinateSpacing <= kCoarsestSpacing * diagonal) return std::nullopt;
  return Diagnostic{ErrorKind::MalformedInput, call.file, "",
                    "holds 32-bit coordinates whose spacing of " + toText(imported.coordinateSpacing) +
                        " is too coarse for a part with a diagonal of " + toText(diagonal) + " (units of the file)",
                    "Export the part nearer to its origin, or as STL text, OBJ or PLY text with enough digits."};
}

/// A line each.
Warnings warningsOf(const ImporterCall& call, const std::string& text) {
  Warnings warnings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) warnings.push_back(refusalOf(call, line));
  return warnings;
}

bool takeVertices(ImportMessage& message, std::vector<Vector3>& vertices) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  return vertices.empty() || message.take(vertices.front().data(), 3 * vertices.size());
}

Result<ImportedMesh> decode(const ImporterCall& call, ImporterAnswer& answer) {
  import_protocol::MeshFacts facts;
  ImportedMesh result;
  reserveFilled(result.mesh.vertices, answer.header.vertices);
  reserveFilled(result.mesh.triangles, answer.header.triangles);
  result.mesh.vertices.resize(answer.header.vertices);
  result.mesh.triangles.resize(answer.header.triangles);
  if (!answer.message.take(&facts, 1) || !takeVertices(answer.message, result.mesh.vertices) ||
      !answer.message.take(result.mesh.triangles.data(), result.mesh.triangles.size()) ||
      !(facts.coordinateSpacing >= 0.0)) {
    return refusalOf(call, "the importer failed on it");
  }
  if (result.mesh.empty()) return refusalOf(call, "holds no triangle");
  if (const auto fault = faultOf(result.mesh)) return refusalOf(call, *fault);
  result.coordinateSpacing = facts.coordinateSpacing;
  if (const auto coarse = refuseCoarseCoordinates(call, result)) return *coarse;
  result.vertexMean = Vector3(facts.vertexMean[0], facts.vertexMean[1], facts.vertexMean[2]);
  if (!result.vertexMean.allFinite()) return refusalOf(call, "the importer failed on it");
  result.warnings = warningsOf(call, answer.message.rest());
  return result;
}

Diagnostic unknownKind(const std::string& file) {
  return {ErrorKind::MalformedInput, file, "", "is of a kind that is not read ('" + endingOf(file) + "')",
          "Use STL, OBJ, PLY, DAE, glTF or GLB; \"step\" and \"urdf\" are shapes of their own in a scenario."};
}

}  // namespace

bool isMeshFile(const std::string& file) {
  const std::string ending = endingOf(file);
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

Result<ImportedMesh> importMesh(const FileContent& content, const StopToken& stop) {
  const std::string ending = endingOf(content.file);
  if (!isMeshFile(content.file)) return unknownKind(content.file);
  const ImporterCall call{"glissade-import",
                          {ending},
                          content.file,
                          meshLimits(content.bytes.size()),
                          "Export the part again, for example as binary STL or GLB."};
  if (content.bytes.empty()) return refusalOf(call, "is empty");
  auto answer = callImporter(call, content.bytes, stop);
  if (answer) return decode(call, *answer);
  Diagnostic why = answer.error();
  const bool external = why.reason.find("file of its own") != std::string::npos;
  if (external) why.advice = "Buffers in files of their own are not read: export it as one .glb file.";
  return why;
}

Result<ImportedMesh> importMesh(const std::string& file, const StopToken& stop) {
  if (!isMeshFile(file)) return unknownKind(file);
  const auto content = readContent(file, mostFileBytes());
  if (!content) return content.error();
  return importMesh(*content, stop);
}

}  // namespace glissade
