#include "engine/import/confined_import.h"

#include <sys/resource.h>

#include <cstring>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "engine/base/message_json.h"
#include "engine/import/confinement.h"
#include "engine/import/formats/assimp_reader.h"
#include "engine/import/formats/gltf_reader.h"
#include "engine/import/formats/obj_reader.h"
#include "engine/import/formats/ply_reader.h"
#include "engine/import/formats/stl_reader.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

MeshContent readMesh(std::string_view bytes, const std::string& ending) {
  if (ending == "stl") return readStl(bytes);
  if (ending == "obj") return readObj(bytes);
  if (ending == "ply") return readPly(bytes);
  if (ending == "gltf" || ending == "glb") return readGltf(bytes);
  return readWithAssimp(bytes, ending);
}

void write(const MeshContent& content, const ImportOutput& output) {
  std::string warnings;
  for (const Message& warning : content.warnings) warnings += lineOf(toJson(warning));
  protocol::Header header;
  header.kind = protocol::kMesh;
  header.vertices = static_cast<std::uint32_t>(content.mesh.vertices.size());
  header.triangles = static_cast<std::uint32_t>(content.mesh.triangles.size());
  protocol::MeshFacts facts;
  for (int i = 0; i < 3; ++i) facts.vertexMean[i] = content.vertexMean[i];
  facts.coordinateSpacing = content.coordinateSpacing;
  facts.warningBytes = static_cast<std::uint32_t>(warnings.size());
  std::string groups;
  for (const GroupRun& group : content.groups) groups += std::to_string(group.triangles) + " " + group.name + "\n";
  facts.groupBytes = static_cast<std::uint32_t>(groups.size());
  output.write(&header, sizeof header);
  output.write(&facts, sizeof facts);
  output.write(content.mesh.vertices);
  output.write(content.mesh.triangles);
  output.write(warnings.data(), warnings.size());
  output.write(groups.data(), groups.size());
}

/// Writes a message for one of several files, whatever is wrong with it.
void importOne(std::string_view bytes, const std::string& ending, const ImportOutput& output) {
  try {
    const MeshContent content = readMesh(bytes, ending);
    if (content.mesh.empty()) {
      output.fail(GLISSADE_TEXT("holds no triangle"));
    } else {
      write(content, output);
    }
  } catch (const FormatError& error) {
    output.fail(error.reason, error.location);
  } catch (const std::exception& error) {
    output.fail(Message(error.what()));
  }
}

int importSeveral(std::size_t size, const ImportOutput& output) {
  const std::vector<char> input = readStandardInput(protocol::kMeshLimits.bytes, size);
  std::string_view rest(input.data(), input.size());
  while (rest.size() >= sizeof(protocol::SmallFile)) {
    protocol::SmallFile file;
    std::memcpy(&file, rest.data(), sizeof file);
    rest.remove_prefix(sizeof file);
    const std::string_view bytes = rest.substr(0, file.bytes);
    rest.remove_prefix(bytes.size());
    importOne(bytes, std::string(file.ending, ::strnlen(file.ending, sizeof file.ending)), output);
  }
  return 0;
}

int import(const std::string& ending, std::size_t size, const ImportOutput& output) {
  const std::vector<char> bytes = readStandardInput(protocol::kMeshLimits.bytes, size);
  const MeshContent content = readMesh(std::string_view(bytes.data(), bytes.size()), ending);
  if (content.mesh.empty()) return output.fail(GLISSADE_TEXT("holds no triangle"));
  write(content, output);
  return 0;
}

}  // namespace

int confinedImport(const std::string& ending) {
  rlimit memory{};
  ::getrlimit(RLIMIT_AS, &memory);  // set by the parent process
  const std::size_t size = sizeOfStandardInput();
  const ImportOutput output;
  if (const Outcome confined = confine(protocol::kMeshLimits); !confined) return output.refuse(confined.error());
  try {
    return ending == protocol::kSeveral ? importSeveral(size, output) : import(ending, size, output);
  } catch (const FormatError& error) {
    return output.fail(error.reason, error.location);
  } catch (const std::bad_alloc&) {
    return output.fail(
        {GLISSADE_TEXT("needs more than the %1 MiB of memory that a file of its size may take on this machine"),
         {memory.rlim_cur >> 20}});
  } catch (const std::exception& error) {
    return output.fail(Message(error.what()));
  }
}

}  // namespace glissade
