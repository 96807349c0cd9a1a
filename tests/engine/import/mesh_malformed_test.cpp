#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "engine/base/random_stream.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

struct Malformed {
  const char* name;  ///< of the file
  std::string content;
  const char* reason;  ///< what the message must say
};

/// 100 bytes that claim two gigabytes of triangles.
std::string lyingStl() {
  std::string content(100, '\0');
  const std::uint32_t claimed = 40'000'000;
  content.replace(80, 4, reinterpret_cast<const char*>(&claimed), 4);
  return content;
}

const std::vector<Malformed>& table() {
  static const std::vector<Malformed> kTable{
      {"lying.stl", lyingStl(), "claims 40000000 triangles"},
      {"nine_bytes.stl", "solid\nfac", "before 'endsolid'"},
      {"truncated.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n",
       "before 'endsolid'"},
      {"noise.stl", std::string(500, '\x7f'), ""},
      {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not a finite number"},
      {"huge.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "beyond all measure"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", ""},
      {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", ""},
      {"truncated.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><asset><unit", ""},
      {"empty_scene.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"></COLLADA>", ""},
      {"broken.gltf", "{\"asset\": {\"version\": \"2.0\"}, ", ""},
      {"truncated.glb", std::string("glTF\x02\0\0\0\xff\xff\0\0", 12), ""},
      {"ply_in_disguise.stl", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n0 0 0\n1 0 0\n0 1 0\n", ""},
      {"part.ply", "ply\n", "not read"},
      {"part.3mf", "PK", "not read"},
      {"part", "solid", "not read"},
      {"empty.stl", "", "empty"},
  };
  return kTable;
}

TEST(MalformedMesh, GivesOneClearMessage) {
  const TemporaryFolder folder;
  for (const Malformed& row : table()) {
    SCOPED_TRACE(row.name);
    const std::string file = folder.write(row.name, row.content);
    const Result<ImportedMesh> imported = importMesh(file);
    ASSERT_FALSE(imported.ok());
    EXPECT_EQ(imported.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(imported.error().file, file);
    EXPECT_THAT(imported.error().reason, testing::HasSubstr(row.reason));
    EXPECT_FALSE(imported.error().advice.empty());
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
  EXPECT_THAT(imported.error().advice, testing::HasSubstr(".glb")) << toString(imported.error());
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

TEST(MalformedMesh, MemoryIsBounded) {
  const TemporaryFolder folder;
  ASSERT_FALSE(importMesh(folder.write("lying.stl", lyingStl())).ok());
  rusage children{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &children), 0);
  EXPECT_LT(children.ru_maxrss, 500 * 1024);  // kilobytes
}

}  // namespace
}  // namespace glissade
