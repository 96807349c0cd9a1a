#include "engine/import/confined_import.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <exception>
#include <string_view>
#include <vector>

#include "engine/import/confinement.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

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

int import(const std::string& ending, const ImportOutput& output) {
  std::vector<char> content = readStandardInput(protocol::kMeshLimits.bytes);
  if (content.empty()) return output.fail("it is empty or too large");
  dropByteOrderMark(content);
  Assimp::Importer importer;
  keepOnlyImportersOf(importer, ending);
  // The flags of OMPL.app, on whose results its problems' reference points depend.
  constexpr unsigned int kFlags = aiProcess_GenNormals | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                  aiProcess_SortByPType | aiProcess_OptimizeGraph;
  const aiScene* scene = importer.ReadFileFromMemory(content.data(), content.size(), kFlags, ending.c_str());
  if (scene == nullptr) return output.fail(importer.GetErrorString());
  if (scene->mRootNode == nullptr) return output.fail("it holds no geometry");
  Arrays arrays;
  gather(*scene, *scene->mRootNode, aiMatrix4x4(), arrays);
  if (arrays.indices.empty()) return output.fail("it holds no triangle");

  protocol::Header header;
  header.kind = protocol::kMesh;
  header.vertices = static_cast<std::uint32_t>(arrays.vertices.size() / 3);
  header.triangles = static_cast<std::uint32_t>(arrays.indices.size() / 3);
  output.write(&header, sizeof header);
  output.write(arrays.vertices);
  const std::array<float, 3> mean = meanOf(arrays.vertices);
  output.write(mean.data(), sizeof mean);
  output.write(arrays.indices);
  return 0;
}

}  // namespace

int confinedImport(const std::string& ending) {
  confine(protocol::kMeshLimits);
  const ImportOutput output;
  try {
    return import(ending, output);
  } catch (const std::exception& error) {
    return output.fail(error.what());
  }
}

}  // namespace glissade
