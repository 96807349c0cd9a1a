#include "engine/import/confined_import.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <seccomp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <exception>
#include <string_view>
#include <vector>

#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;  // its shadow memory needs terabytes of address space
#else
constexpr bool kSanitized = false;
#endif

void limitResources() {
  const rlimit seconds{protocol::kMostSeconds, protocol::kMostSeconds};
  setrlimit(RLIMIT_CPU, &seconds);
  const rlimit memory{protocol::kMostMemory, protocol::kMostMemory};
  if (!kSanitized) setrlimit(RLIMIT_AS, &memory);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

/// No file, no process, no network from here on. Where the kernel refuses the filter the limits
/// above still hold.
void forbidFiles() {
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (filter == nullptr) return;
  const std::array<int, 10> forbidden{SCMP_SYS(open),   SCMP_SYS(openat),   SCMP_SYS(openat2), SCMP_SYS(creat),
                                      SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(fork),    SCMP_SYS(socket),
                                      SCMP_SYS(unlink), SCMP_SYS(rename)};
  for (const int call : forbidden) seccomp_rule_add(filter, SCMP_ACT_ERRNO(EACCES), call, 0);
  seccomp_load(filter);
  seccomp_release(filter);
}

std::vector<char> readStandardInput() {
  std::vector<char> content;
  std::array<char, 65536> buffer{};
  ssize_t count = 0;
  while ((count = ::read(STDIN_FILENO, buffer.data(), buffer.size())) > 0) {
    content.insert(content.end(), buffer.begin(), buffer.begin() + count);
    if (content.size() > protocol::kMostBytes) return {};
  }
  return content;
}

void writeBytes(const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = ::write(STDOUT_FILENO, bytes, size);
    if (count <= 0) return;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

int fail(const std::string& reason) {
  protocol::Header header;
  header.kind = protocol::kError;
  header.vertices = static_cast<std::uint32_t>(reason.size());
  writeBytes(&header, sizeof header);
  writeBytes(reason.data(), reason.size());
  return 1;
}

struct Arrays {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
};

void gather(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, Arrays& arrays) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  const bool mirrored = transform.Determinant() < 0.0F;
  for (unsigned int m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0) continue;
    const auto base = static_cast<std::uint32_t>(arrays.vertices.size() / 3);
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = transform * mesh.mVertices[v];
      arrays.vertices.insert(arrays.vertices.end(), {p.x, p.y, p.z});
    }
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
      if (mesh.mFaces[f].mNumIndices != 3) continue;
      const unsigned int* corner = mesh.mFaces[f].mIndices;
      arrays.indices.insert(arrays.indices.end(),
                            {base + corner[0], base + corner[mirrored ? 2 : 1], base + corner[mirrored ? 1 : 2]});
    }
  }
  for (unsigned int c = 0; c < node.mNumChildren; ++c) gather(scene, *node.mChildren[c], transform, arrays);
}

/// In single precision on purpose: as OMPL.app computes it.
std::array<float, 3> meanOf(const std::vector<float>& vertices) {
  std::array<float, 3> mean{};
  for (std::size_t i = 0; i < vertices.size(); ++i) mean[i % 3] += vertices[i];
  for (float& coordinate : mean) coordinate /= static_cast<float>(vertices.size() / 3);
  return mean;
}

/// Assimp also chooses importers by what the content looks like; a PLY called .stl must not reach the
/// PLY importer, which is known to crash and hang.
void keepOnlyImportersOf(Assimp::Importer& importer, const std::string& ending) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    const std::string endings = std::string(" ") + importer.GetImporterInfo(i)->mFileExtensions + " ";
    const bool wanted = endings.find(" " + ending + " ") != std::string::npos;
    if (!wanted) importer.UnregisterLoader(importer.GetImporter(i));
  }
}

/// Assimp drops the first line of an OBJ after a byte-order mark, and all indices shift.
void dropByteOrderMark(std::vector<char>& content) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const std::string_view text(content.data(), content.size());
  if (text.substr(0, kMark.size()) == kMark) content.erase(content.begin(), content.begin() + kMark.size());
}

int import(const std::string& ending) {
  std::vector<char> content = readStandardInput();
  if (content.empty()) return fail("it is empty or too large");
  dropByteOrderMark(content);
  Assimp::Importer importer;
  keepOnlyImportersOf(importer, ending);
  // The flags of OMPL.app, on whose results its problems' reference points depend.
  constexpr unsigned int kFlags = aiProcess_GenNormals | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                  aiProcess_SortByPType | aiProcess_OptimizeGraph;
  const aiScene* scene = importer.ReadFileFromMemory(content.data(), content.size(), kFlags, ending.c_str());
  if (scene == nullptr) return fail(importer.GetErrorString());
  if (scene->mRootNode == nullptr) return fail("it holds no geometry");
  Arrays arrays;
  gather(*scene, *scene->mRootNode, aiMatrix4x4(), arrays);
  if (arrays.indices.empty()) return fail("it holds no triangle");

  protocol::Header header;
  header.kind = protocol::kMesh;
  header.vertices = static_cast<std::uint32_t>(arrays.vertices.size() / 3);
  header.triangles = static_cast<std::uint32_t>(arrays.indices.size() / 3);
  writeBytes(&header, sizeof header);
  writeBytes(arrays.vertices.data(), arrays.vertices.size() * sizeof(float));
  const std::array<float, 3> mean = meanOf(arrays.vertices);
  writeBytes(mean.data(), sizeof mean);
  writeBytes(arrays.indices.data(), arrays.indices.size() * sizeof(std::uint32_t));
  return 0;
}

}  // namespace

int confinedImport(const std::string& ending) {
  limitResources();
  forbidFiles();
  try {
    return import(ending);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace glissade
