#include "engine/import/mesh_import.h"

#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <clocale>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

/// A box 1 x 2 x 3 with its least corner at (1, 1, 1): no symmetry hides a wrong axis.
TriangleMesh testBox() { return transformed(makeBox({1, 2, 3}), Pose::translation({1.5, 2.0, 2.5})); }

/// The box in the structures of assimp; owned by the returned scene.
std::unique_ptr<aiScene> toAssimp(const TriangleMesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("root");
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mNumMaterials = 1;
  auto* part = new aiMesh;
  scene->mMeshes = new aiMesh* [1] { part };
  scene->mNumMeshes = 1;
  part->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  part->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  part->mVertices = new aiVector3D[mesh.vertices.size()];
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3f v = mesh.vertices[i].cast<float>();
    part->mVertices[i] = aiVector3D(v.x(), v.y(), v.z());
  }
  part->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
  part->mFaces = new aiFace[mesh.triangles.size()];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    part->mFaces[i].mNumIndices = 3;
    part->mFaces[i].mIndices = new unsigned[3]{mesh.triangles[i][0], mesh.triangles[i][1], mesh.triangles[i][2]};
  }
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  scene->mRootNode->mNumMeshes = 1;
  return scene;
}

void expectIsTestBox(const ImportedMesh& imported) {
  const MeshAudit found = audit(imported.mesh);
  EXPECT_EQ(found.triangles, 12U);
  EXPECT_TRUE(found.closed());
  EXPECT_NEAR(found.volume, 6.0, 1e-5);
  EXPECT_TRUE(found.box.min().isApprox(Vector3(1, 1, 1), 1e-5)) << found.box.min().transpose();
  EXPECT_TRUE(found.box.max().isApprox(Vector3(2, 3, 4), 1e-5)) << found.box.max().transpose();
}

struct Format {
  const char* exporter;  ///< assimp's id
  const char* ending;
};

class ImportedFormat : public testing::TestWithParam<Format> {};

TEST_P(ImportedFormat, RoundTrips) {
  const TemporaryFolder folder;
  const std::string file = folder / ("box." + std::string(GetParam().ending));
  Assimp::Exporter exporter;
  ASSERT_EQ(exporter.Export(toAssimp(testBox()).get(), GetParam().exporter, file), aiReturn_SUCCESS)
      << exporter.GetErrorString();
  const Result<ImportedMesh> imported = importMesh(file);
  ASSERT_TRUE(imported.ok()) << toString(imported.error());
  expectIsTestBox(*imported);
}

INSTANTIATE_TEST_SUITE_P(All, ImportedFormat,
                         testing::Values(Format{"stl", "stl"}, Format{"stlb", "stl"}, Format{"obj", "obj"},
                                         Format{"collada", "dae"}, Format{"glb2", "glb"}),
                         [](const auto& format) { return std::string(format.param.exporter); });

/// A tetrahedron as OBJ; its material file has to be ignored.
constexpr const char* kTetrahedronObj =
    "mtllib ../../etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nusemtl steel\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

TEST(MeshImport, MaterialFilesDoNotMatter) {
  const TemporaryFolder folder;
  const Result<ImportedMesh> imported = importMesh(folder.write("tetrahedron.obj", kTetrahedronObj));
  ASSERT_TRUE(imported.ok()) << toString(imported.error());
  EXPECT_EQ(boundingBox(imported->mesh).max(), Vector3(1, 2, 3));
  EXPECT_EQ(welded(imported->mesh).vertices.size(), 4U);
}

TEST(MeshImport, AByteOrderMarkLosesNothing) {
  const TemporaryFolder folder;
  const std::string text = std::string(kTetrahedronObj).substr(std::string(kTetrahedronObj).find('\n') + 1);
  const Result<ImportedMesh> imported = importMesh(folder.write("bom.obj", "\xEF\xBB\xBF" + text));
  ASSERT_TRUE(imported.ok()) << toString(imported.error());
  EXPECT_EQ(boundingBox(imported->mesh).max(), Vector3(1, 2, 3));
  EXPECT_TRUE(audit(imported->mesh).closed());
}

TEST(MeshImport, TheMeanCountsEveryImportedVertex) {
  const TemporaryFolder folder;
  const Result<ImportedMesh> imported = importMesh(folder.write("tetrahedron.obj", kTetrahedronObj));
  ASSERT_TRUE(imported.ok());
  // Flat normals split each corner in three; the mean is that of the four corners.
  EXPECT_TRUE(imported->vertexMean.isApprox(Vector3(0.25, 0.5, 0.75), 1e-6));
}

/// A Collada file in millimetres with Z up, as a CAD program writes it.
std::string collada(const std::string& nodeMatrix) {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="pa" count="12">0 0 0 1000 0 0 0 2000 0 0 0 3000</float_array>
      <technique_common><accessor source="#pa" count="4" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node><matrix>)" +
         nodeMatrix + R"(</matrix><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)";
}

TEST(MeshImport, ColladaArrivesInMetresAndYUp) {
  const TemporaryFolder folder;
  const Result<ImportedMesh> imported =
      importMesh(folder.write("part.dae", collada("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")));
  ASSERT_TRUE(imported.ok()) << toString(imported.error());
  EXPECT_TRUE(boundingBox(imported->mesh).max().isApprox(Vector3(1, 3, 0), 1e-6));
  EXPECT_NEAR(audit(imported->mesh).volume, 1.0, 1e-6);
}

TEST(MeshImport, MirroredNodesStayOutward) {
  const TemporaryFolder folder;
  const Result<ImportedMesh> imported =
      importMesh(folder.write("part.dae", collada("-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")));
  ASSERT_TRUE(imported.ok()) << toString(imported.error());
  EXPECT_NEAR(boundingBox(imported->mesh).min().x(), -1.0, 1e-6);
  EXPECT_NEAR(audit(imported->mesh).volume, 1.0, 1e-6);
}

TEST(MeshImport, DoesNotDependOnTheLocale) {
  if (std::setlocale(LC_ALL, "fr_FR.UTF-8") == nullptr) GTEST_SKIP() << "the locale fr_FR.UTF-8 is not installed";
  const TemporaryFolder folder;
  std::string half = kTetrahedronObj;
  half.replace(half.find("v 1 0 0"), 7, "v 1.5 0 0");
  const Result<ImportedMesh> imported = importMesh(folder.write("half.obj", half));
  std::setlocale(LC_ALL, "C");
  ASSERT_TRUE(imported.ok());
  EXPECT_EQ(boundingBox(imported->mesh).max().x(), 1.5);
}

}  // namespace
}  // namespace glissade
