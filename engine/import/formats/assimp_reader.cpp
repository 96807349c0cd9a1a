#include "engine/import/formats/assimp_reader.h"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <new>

#include "engine/geometry/vertex_welder.h"

namespace glissade {
namespace {

/// Assimp also selects importers by the content; a file must not reach the importer of another format.
void keepOnlyImportersOf(Assimp::Importer& importer, const std::string& ending) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    const std::string endings = std::string(" ") + importer.GetImporterInfo(i)->mFileExtensions + " ";
    const bool readsEnding = endings.find(" " + ending + " ") != std::string::npos;
    if (!readsEnding) importer.UnregisterLoader(importer.GetImporter(i));
  }
}

/// Error of a sum of three products and its terms, in spacings of floats.
constexpr double kErrorOfTransform = 4.0;

/// Largest deviation of the coordinates from those of the file: assimp parses and transforms them in single precision.
double spacingOf(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& parent, double error) {
  using FloatMatrix = Eigen::Matrix<float, 4, 4, Eigen::RowMajor>;
  const Eigen::Matrix4d transform = parent * Eigen::Map<const FloatMatrix>(&node.mTransformation.a1).cast<double>();
  if (!node.mTransformation.IsIdentity()) error += kErrorOfTransform;
  double spacing = 0.0;
  for (unsigned int m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector4d local(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z, 1.0);
      const double magnitude = (transform.cwiseAbs() * local.cwiseAbs()).head<3>().maxCoeff();
      spacing = std::max(spacing, error * floatSpacing(magnitude));
    }
  }
  for (unsigned int c = 0; c < node.mNumChildren; ++c) {
    spacing = std::max(spacing, spacingOf(scene, *node.mChildren[c], transform, error));
  }
  return spacing;
}

/// Calls `use` with each triangle mesh and its transform.
void forEachMesh(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, const auto& use) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  for (unsigned int m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0) use(mesh, transform);
  }
  for (unsigned int c = 0; c < node.mNumChildren; ++c) forEachMesh(scene, *node.mChildren[c], transform, use);
}

TriangleMesh trianglesOf(const aiScene& scene) {
  TriangleMesh result;
  VertexWelder welder;
  forEachMesh(scene, *scene.mRootNode, aiMatrix4x4(), [&](const aiMesh& mesh, const aiMatrix4x4& transform) {
    const bool mirrored = transform.Determinant() < 0.0F;
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
      if (mesh.mFaces[f].mNumIndices != 3) continue;  // points and lines
      TriangleIndices triangle;
      for (unsigned int i = 0; i < 3; ++i) {
        const unsigned int vertex = mesh.mFaces[f].mIndices[i];
        if (vertex >= mesh.mNumVertices)
          throw FormatError{"", GLISSADE_TEXT("has a triangle with a corner that does not exist")};
        const aiVector3D p = transform * mesh.mVertices[vertex];
        triangle[i] = welder.indexOf(Vector3(p.x, p.y, p.z));
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      result.triangles.push_back(triangle);
    }
  });
  result.vertices = std::move(welder).takeVertices();
  return result;
}

/// Throws the error of assimp. Assimp catches failed allocations and only names them in its text.
[[noreturn]] void refuse(const Assimp::Importer& importer) {
  const std::string reason = importer.GetErrorString();
  if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  throw FormatError{"", {GLISSADE_TEXT("cannot be read: %1"), {reason}}};
}

/// The mean that OMPL.app computes: all vertices that assimp has, in single precision.
Vector3 meanOfVertices(const aiScene& scene) {
  std::array<float, 3> sum{};
  std::size_t count = 0;
  forEachMesh(scene, *scene.mRootNode, aiMatrix4x4(), [&](const aiMesh& mesh, const aiMatrix4x4& transform) {
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = transform * mesh.mVertices[v];
      sum[0] += p.x;
      sum[1] += p.y;
      sum[2] += p.z;
    }
    count += mesh.mNumVertices;
  });
  const auto divisor = static_cast<float>(std::max<std::size_t>(count, 1));
  return {sum[0] / divisor, sum[1] / divisor, sum[2] / divisor};
}

}  // namespace

MeshContent readWithAssimp(std::string_view bytes, const std::string& ending) {
  Assimp::Importer importer;
  keepOnlyImportersOf(importer, ending);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, ending.c_str());
  if (scene == nullptr) refuse(importer);
  if (scene->mRootNode == nullptr) throw FormatError{"", GLISSADE_TEXT("holds no geometry")};
  MeshContent content;
  // Assimp's parser of numbers may miss the nearest float by one.
  content.coordinateSpacing = spacingOf(*scene, *scene->mRootNode, Eigen::Matrix4d::Identity(), 2.0);
  // Flags of OMPL.app, on whose results its problems depend. The last flag also joins vertices that differ, so only the
  // mean is computed after it.
  scene = importer.ApplyPostProcessing(aiProcess_GenNormals | aiProcess_Triangulate | aiProcess_SortByPType |
                                       aiProcess_OptimizeGraph);
  if (scene == nullptr) refuse(importer);
  content.mesh = trianglesOf(*scene);
  scene = importer.ApplyPostProcessing(aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) refuse(importer);
  content.vertexMean = meanOfVertices(*scene);
  return content;
}

}  // namespace glissade
