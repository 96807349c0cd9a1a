#include "engine/import/assimp_reader.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <exception>
#include <utility>

namespace glissade {
namespace {

constexpr unsigned kOmplAppFlags = aiProcess_GenNormals | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                   aiProcess_SortByPType | aiProcess_OptimizeGraph;
constexpr int kDeepestNode = 256;

/// Assimp tries importers by what the content looks like, too; a PLY called .stl must not reach the
/// PLY importer.
void keepOnlyImportersOf(Assimp::Importer& importer, const std::string& ending) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    const std::string endings = std::string(" ") + importer.GetImporterInfo(i)->mFileExtensions + " ";
    const bool wanted = endings.find(" " + ending + " ") != std::string::npos;
    if (!wanted) importer.UnregisterLoader(importer.GetImporter(i));
  }
}

void appendMesh(const aiMesh& mesh, const aiMatrix4x4& X_WorldNode, MeshReply& reply) {
  const auto offset = static_cast<std::uint32_t>(reply.coordinates.size() / 3);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D p = X_WorldNode * mesh.mVertices[i];
    reply.coordinates.insert(reply.coordinates.end(), {p.x, p.y, p.z});
  }
  const bool mirrored = X_WorldNode.Determinant() < 0.0F;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines
    const unsigned second = face.mIndices[mirrored ? 2 : 1];
    const unsigned third = face.mIndices[mirrored ? 1 : 2];
    reply.corners.insert(reply.corners.end(), {offset + face.mIndices[0], offset + second, offset + third});
  }
}

void appendNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& X_WorldParent, int depth,
                MeshReply& reply) {
  if (depth > kDeepestNode) return;
  const aiMatrix4x4 X_WorldNode = X_WorldParent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) appendMesh(*scene.mMeshes[node.mMeshes[i]], X_WorldNode, reply);
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    appendNode(scene, *node.mChildren[i], X_WorldNode, depth + 1, reply);
  }
}

MeshReply failed(const std::string& reason) { return {"the file could not be imported: " + reason, {}, {}}; }

}  // namespace

MeshReply readMeshWithAssimp(std::string_view content, const std::string& ending) try {
  Assimp::Importer importer;
  keepOnlyImportersOf(importer, ending);
  const aiScene* scene = importer.ReadFileFromMemory(content.data(), content.size(), kOmplAppFlags, ending.c_str());
  if (!scene) return failed(importer.GetErrorString());
  if (!scene->mRootNode) return failed("it holds no scene");
  MeshReply reply;
  appendNode(*scene, *scene->mRootNode, aiMatrix4x4(), 0, reply);
  return reply;
} catch (const std::exception& error) {
  return failed(error.what());
}

}  // namespace glissade
