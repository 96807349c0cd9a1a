#include "engine/import/mesh_answer.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "engine/base/number_text.h"
#include "engine/base/printable_text.h"
#include "engine/base/reserve_filled.h"
#include "engine/import/import_limits.h"

namespace glissade {
namespace {

/// Largest spacing of the coordinates of a part, as a share of its diagonal.
constexpr double kCoarsestSpacing = 1e-4;

std::optional<Diagnostic> refuseCoarseCoordinates(const ImporterCall& call, const ImportedMesh& imported) {
  const double diagonal = boundingBox(imported.mesh).diagonal().norm();
  if (imported.coordinateSpacing <= kCoarsestSpacing * diagonal) return std::nullopt;
  return Diagnostic{ErrorKind::MalformedInput,
                    call.file,
                    "",
                    {GLISSADE_TEXT("holds 32-bit coordinates whose spacing of %1 is too coarse for a part with a "
                                   "diagonal of %2 (units of the file)"),
                     {imported.coordinateSpacing, diagonal}},
                    GLISSADE_TEXT("Export the part nearer to its origin, or as STL text, OBJ or PLY text with enough "
                                  "digits.")};
}

/// One warning for each line; nothing if a line is no message.
std::optional<Warnings> warningsOf(const ImporterCall& call, const std::string& text) {
  Warnings warnings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto message = messageOfProgram(nlohmann::json::parse(line, nullptr, false));
    if (!message) return std::nullopt;
    warnings.push_back(refusalOf(call, *message));
  }
  return warnings;
}

/// Nothing if the groups do not contain all triangles.
std::optional<std::vector<GroupRun>> groupsOf(const std::string& text, std::size_t triangles) {
  std::vector<GroupRun> groups;
  std::size_t sum = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const auto count = toNumber(line.substr(0, end));
    if (!count || !(*count >= 0.0) || !(*count <= static_cast<double>(triangles))) return std::nullopt;
    groups.push_back({printableLine(line.substr(std::min(end + 1, line.size()))), static_cast<std::uint32_t>(*count)});
    sum += groups.back().triangles;
  }
  if (!groups.empty() && sum != triangles) return std::nullopt;
  return groups;
}

bool takeVertices(ImportMessage& message, std::vector<Vector3>& vertices) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  return vertices.empty() || message.take(vertices.front().data(), 3 * vertices.size());
}

}  // namespace

ImporterCall meshImporterCall(const std::string& argument, const std::string& file, std::uint64_t bytes) {
  return {"glissade-import",
          {argument},
          file,
          meshLimits(bytes),
          GLISSADE_TEXT("Export the part again, for example as binary STL or GLB.")};
}

Result<ImportedMesh> decodeMeshAnswer(const ImporterCall& call, const import_protocol::Header& header,
                                      ImportMessage& message) {
  import_protocol::MeshFacts facts;
  std::string warnings;
  std::string groups;
  ImportedMesh result;
  reserveFilled(result.mesh.vertices, header.vertices);
  reserveFilled(result.mesh.triangles, header.triangles);
  result.mesh.vertices.resize(header.vertices);
  result.mesh.triangles.resize(header.triangles);
  if (!message.take(&facts, 1) || !takeVertices(message, result.mesh.vertices) ||
      !message.take(result.mesh.triangles.data(), result.mesh.triangles.size()) ||
      !message.takeText(facts.warningBytes, warnings) || !message.takeText(facts.groupBytes, groups) ||
      !(facts.coordinateSpacing >= 0.0)) {
    return refusalOf(call, GLISSADE_TEXT("the importer failed on it"));
  }
  if (result.mesh.empty()) return refusalOf(call, GLISSADE_TEXT("holds no triangle"));
  if (const auto fault = faultOf(result.mesh)) return refusalOf(call, *fault);
  result.coordinateSpacing = facts.coordinateSpacing;
  if (const auto coarse = refuseCoarseCoordinates(call, result)) return *coarse;
  result.vertexMean = Vector3(facts.vertexMean[0], facts.vertexMean[1], facts.vertexMean[2]);
  if (!result.vertexMean.allFinite()) return refusalOf(call, GLISSADE_TEXT("the importer failed on it"));
  auto said = warningsOf(call, warnings);
  auto read = groupsOf(groups, result.mesh.triangles.size());
  if (!said || !read) return refusalOf(call, GLISSADE_TEXT("the importer failed on it"));
  result.warnings = std::move(*said);
  result.groups = std::move(*read);
  return result;
}

}  // namespace glissade
