#include "engine/import/importer_process.h"

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "engine/import/child_process.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// More than any message of kMostElements and kMostParts.
constexpr std::size_t kMostOutput =
    std::size_t{40} * protocol::kMostElements + std::size_t{1024} * protocol::kMostParts;

std::string besideThisProgram(const std::string& name) {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return (self.parent_path() / name).string();
}

}  // namespace

Diagnostic refusalOf(const ImporterCall& call, const std::string& reason) {
  return {ErrorKind::MalformedInput, call.file, "", reason, call.advice};
}

Result<ImporterAnswer> callImporter(const ImporterCall& call, const StopToken& stop) {
  auto child =
      runChild(besideThisProgram(call.program), {call.argument}, call.file, call.limits.patience, kMostOutput, stop);
  if (!child) return child.error();
  if (stop.stopRequested()) {
    return Diagnostic{ErrorKind::Interrupted, call.file, "", "was not read to its end", "Read it again."};
  }
  if (child->timedOut || child->signal == SIGXCPU) {
    return refusalOf(call, "takes too long to read: it is too complex or malformed");
  }
  if (child->signal != 0) return refusalOf(call, "is malformed (the importer stopped on it)");
  ImporterAnswer answer{{}, ImportMessage(std::move(child->output))};
  const protocol::Header& header = answer.header;
  if (!answer.message.take(&answer.header, 1) || header.magic != protocol::kMagic) {
    return refusalOf(call, "the importer failed on it");
  }
  if (header.kind == protocol::kError) return refusalOf(call, "cannot be read: " + answer.message.rest());
  if (header.vertices > protocol::kMostElements || header.triangles > protocol::kMostElements) {
    return refusalOf(call, "is too large");
  }
  return answer;
}

std::optional<std::string> faultOf(const TriangleMesh& mesh) {
  constexpr double kLargestCoordinate = 1e9;
  for (const Vector3& vertex : mesh.vertices) {
    if (vertex.allFinite() && vertex.cwiseAbs().maxCoeff() <= kLargestCoordinate) continue;
    return "has a vertex that is not a finite number, or beyond all measure";
  }
  for (const TriangleIndices& triangle : mesh.triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) < mesh.vertices.size()) continue;
    return "has a triangle with a corner that does not exist";
  }
  return std::nullopt;
}

}  // namespace glissade
