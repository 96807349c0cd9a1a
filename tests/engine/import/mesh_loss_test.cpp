#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/import/expect_refused.h"
#include "tests/engine/support/mesh_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::MeshFormat;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string kSolid = "solid a\n" + kFacet + "endsolid a\n";
const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

struct Loss {
  const char* name;  ///< name of the file
  std::string content;
  const char* place;
  const char* reason;
};

std::vector<Loss> losses() {
  std::string overlong = meshFile(MeshFormat::BinaryStl, {makeBox({1, 1, 1})});
  overlong[80] = 11;
  return {
      {"second_solid_cut_off.stl", kSolid + "solid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0", "line 13",
       "coordinate"},
      {"second_solid_without_end.stl", kSolid + "solid b\n" + kFacet, "line 18", "before 'endsolid'"},
      {"something_after_a_solid.stl", kSolid + "fcaet\n" + kSolid, "line 10", "'solid' is expected"},
      {"fourth_corner.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid\n",
       "line 7", "more than three corners"},
      {"two_corners.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", "line 6",
       "'vertex' is expected"},
      {"nan.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", "line 4", "not a finite number"},
      {"comma.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0,5 0 0\n", "line 4", "is not a number"},
      {"count_too_low.stl", overlong, "byte 634", "goes on after the 11 triangles"},
      {"two_corners.obj", kVertices + "f 1 2\n", "line 5", "2 corners"},
      {"cut_off_in_a_face.obj", kVertices + "f 1 2 3\nf 1 2", "line 6", "2 corners"},
      {"cut_off_in_a_vertex.obj", kVertices + "f 1 2 3\nv 1 2", "line 6", "ends before the coordinate"},
      {"index.obj", kVertices + "f 1 2 5\n", "line 5", "vertex 5, but the file has 4"},
      {"index_zero.obj", kVertices + "f 1 2 0\n", "line 5", "vertex 0"},
      {"index_back.obj", kVertices + "f -1 -2 -5\n", "line 5", "vertex -5"},
      {"index_cut.obj", kVertices + "f 1/ 2/ 3/x\n", "line 5", "'x'"},
      {"overflow.obj", "v 1e999 0 0\n", "line 1", "not a finite number"},
      {"free_form.obj", kVertices + "cstype bezier\n", "line 5", "free-form"},
      {"unknown.obj", kVertices + "fcae 1 2 3\n", "line 5", "not a statement"},
      {"weight.obj", "v 0 0 0 0.5\n", "line 1", "weight"},
      {"crossing.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0.5 2 0\nv 0.4 -2 0\nf 1 4 2 3 6 5\n", "line 7",
       "crosses itself"},
      {"cut_off.ply", kPlyHead + "0.25 0.25 0.25\n1.00 0 0\n0 1", "line 12", "ends before the number"},
      {"more.ply", kPlyHead + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "line 13", "goes on"},
      {"index.ply", kPlyHead + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 13", "vertex 3, but the file has 3"},
      {"two_corners.ply", kPlyHead + "0 0 0\n1 0 0\n0 1 0\n2 0 1   \n", "line 13", "2 corners"},
      {"lying.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n0\n", "",
       "claims 4000000000"},
      {"strips.ply",
       "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n3 0 1 2\n", "",
       "strips"},
  };
}

TEST(MeshLoss, IsAnErrorThatNamesThePlace) {
  for (const Loss& row : losses()) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(test::placeOfRefusal(row.name, row.content, row.reason), row.place);
  }
}

TEST(MeshLoss, ALastLineWithoutItsEndIsAWarning) {
  const TemporaryFolder folder;
  const auto imported = importMesh(folder.write("part.obj", kVertices + "f 1 2 3"));
  ASSERT_TRUE(imported.ok());
  ASSERT_EQ(imported->warnings.size(), 1U);
  EXPECT_THAT(toString(imported->warnings[0].reason), HasSubstr("line 5"));
}

TEST(MeshLoss, RequiredExtensionsOfGltfThatAreUnknownAreNamed) {
  const TemporaryFolder folder;
  std::string content = meshFile(MeshFormat::Gltf, {makeBox({1, 1, 1})});
  ASSERT_TRUE(importMesh(folder.write("part.gltf", content)).ok());
  content.replace(content.find("KHR_materials_unlit"), 19, "KHR_draco_mesh_comp");
  const auto imported = importMesh(folder.write("part.gltf", content));
  ASSERT_FALSE(imported.ok());
  EXPECT_EQ(toString(imported.error().location), "/extensionsRequired");
  EXPECT_THAT(toString(imported.error().reason), HasSubstr("'KHR_draco_mesh_comp'"));
}

/// Every prefix of a file is refused, unless only the last line's end is missing.
TEST(MeshLoss, NoTruncationLosesATriangleSilently) {
  const TriangleMesh box = makeBox({1, 1, 1});
  const TemporaryFolder folder;
  RandomStream random(4, "truncation");
  for (const MeshFormat format : test::kMeshFormats) {
    const std::string whole = meshFile(format, {box, transformed(box, Pose::translation({3, 0, 0}))});
    for (int i = 0; i < 12; ++i) {
      const std::string cut = whole.substr(0, random.bits() % whole.size());
      SCOPED_TRACE(testing::Message() << static_cast<int>(format) << ": " << cut.size() << " of " << whole.size());
      const auto imported = importMesh(folder.write("part." + endingOf(format), cut));
      if (!imported || imported->mesh.triangles.size() == 24U) continue;
      // A text STL does not state how many solids it contains.
      const bool wholeSolid = format == MeshFormat::TextStl && imported->mesh.triangles.size() == 12U;
      // An OBJ does not state its length: a cut between two of its lines cannot be detected.
      const bool wholeLines = endingOf(format) == "obj" && (cut.back() == '\n' || cut.back() == '\r');
      EXPECT_TRUE(wholeSolid || wholeLines || !imported->warnings.empty());
    }
  }
}

}  // namespace
}  // namespace glissade
