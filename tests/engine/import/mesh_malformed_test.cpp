#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "engine/base/child_process.h"
#include "engine/base/random_stream.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/confinement.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/import/expect_refused.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

struct MalformedMeshFile {
  const char* name;  ///< name of the file
  std::string content;
  const char* reason;  ///< text that the message has to contain
};

/// 100 bytes that claim two gigabytes of triangles.
std::string lyingStl() {
  std::string content(100, '\0');
  const std::uint32_t claimed = 40'000'000;
  content.replace(80, 4, reinterpret_cast<const char*>(&claimed), 4);
  return content;
}

const std::vector<MalformedMeshFile>& malformedMeshFiles() {
  static const std::vector<MalformedMeshFile> kTable{
      {"lying.stl", lyingStl(), "claims 40000000 triangles"},
      {"nine_bytes.stl", "solid\nfac", "before 'endsolid'"},
      {"truncated.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n",
       "before 'endsolid'"},
      {"noise.stl", std::string(500, '\x7f'), "claims 2139062143 triangles"},
      {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not a finite number"},
      {"huge.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not finite, or too large"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "vertex 9"},
      {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "holds no triangle"},
      {"truncated.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><asset><unit", "malformed XML"},
      {"empty_scene.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"></COLLADA>", "empty"},
      {"broken.gltf", "{\"asset\": {\"version\": \"2.0\"}, ", "malformed or cut off"},
      {"truncated.glb", std::string("glTF\x02\0\0\0\xff\xff\0\0", 12), "claims a length"},
      {"ply_in_disguise.stl", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n0 0 0\n1 0 0\n0 1 0\n",
       "too short"},
      {"part.ply", "ply\n", "before 'end_header'"},
      {"part.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\n"
       "element face 1\nproperty list uchar double vertex_indices\nend_header\n0 0 0\n3 0 0 1e300\n",
       "has a face with vertex 1e+300, but the file has 1"},
      {"part.3mf", "PK", "not read"},
      {"part", "solid", "not read"},
      {"empty.stl", "", "empty"},
  };
  return kTable;
}

TEST(MalformedMesh, GivesOneClearMessage) {
  for (const MalformedMeshFile& row : malformedMeshFiles()) {
    SCOPED_TRACE(row.name);
    (void)test::placeOfRefusal(row.name, row.content, row.reason);
  }
}

TEST(MalformedMesh, ExternalBuffersAreExplained) {
  const TemporaryFolder folder;
  folder.write("box.bin", std::string(36, '\0'));
  const std::string file = folder.write("box.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "buffers": [{"uri": "box.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]})");
  const Result<ImportedMesh> imported = importMesh(file);
  ASSERT_FALSE(imported.ok());
  EXPECT_THAT(toString(imported.error().advice), testing::HasSubstr(".glb")) << toString(imported.error());
}

TEST(MalformedMesh, DamagedFilesNeverReachThisProcess) {
  const TemporaryFolder folder;
  const std::string good =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid a\n";
  RandomStream random(3, "damage");
  for (int i = 0; i < 60; ++i) {
    std::string content = good;
    for (int k = 0; k < 4; ++k) content[random.bits() % content.size()] = static_cast<char>(random.bits());
    const Result<ImportedMesh> imported = importMesh(folder.write(i % 2 ? "a.stl" : "a.obj", content));
    EXPECT_TRUE(!imported || boundingBox(imported->mesh).max().allFinite());
  }
}

/// A Collada array that claims 1.6 GB of numbers, for which the importer reserves memory at once.
std::string lyingCollada() {
  return R"(<?xml version="1.0"?><COLLADA version="1.4.1"><library_geometries><geometry id="g"><mesh>
    <source id="s"><float_array id="a" count="400000000">0 0 0 1 0 0 0 1 0</float_array><technique_common>
    <accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
    <param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
    <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
    </mesh></geometry></library_geometries></COLLADA>)";
}

/// A strip of this number of triangles.
std::string stripObj(int triangles) {
  std::string content;
  for (int i = 0; i < triangles + 2; ++i) {
    content += "v " + std::to_string(i / 2) + " " + std::to_string(i % 2) + " 0\n";
  }
  for (int i = 1; i <= triangles; ++i) {
    content += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  }
  return content;
}

/// Peak of all importing processes of this program so far, in megabytes.
double importersPeakMegabytes() {
  rusage children{};
  EXPECT_EQ(getrusage(RUSAGE_CHILDREN, &children), 0);
  return static_cast<double>(children.ru_maxrss) / 1024.0;
}

TEST(MalformedMesh, MemoryIsBounded) {
  const TemporaryFolder folder;
  // A good file of some megabytes: the importer runs, and its memory is measured here.
  const Result<ImportedMesh> good = importMesh(folder.write("strip.obj", stripObj(50'000)));
  ASSERT_TRUE(good.ok()) << toString(good.error());
  EXPECT_EQ(good->mesh.triangles.size(), 50'000U);
  EXPECT_GT(importersPeakMegabytes(), 5.0);
  const Result<ImportedMesh> lying = importMesh(folder.write("lying.dae", lyingCollada()));
  ASSERT_FALSE(lying.ok());
  if (!kMemoryCanBeLimited) return;  // sanitizers reserve terabytes of address space
  EXPECT_THAT(toString(lying.error().reason), testing::HasSubstr("MiB of memory"));
  EXPECT_LT(importersPeakMegabytes(), 500.0);
}

}  // namespace
}  // namespace glissade
