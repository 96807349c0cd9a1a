#include "engine/import/urdf_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/mesh_audit.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

std::string robot(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"r\">" + content + "</robot>\n";
}
std::string link(const std::string& name, const std::string& content = "") {
  return "<link name=\"" + name + "\">" + content + "</link>";
}
std::string collision(const std::string& geometry, const std::string& origin = "") {
  return "<collision>" + origin + "<geometry>" + geometry + "</geometry></collision>";
}
std::string joint(const std::string& type, const std::string& child, const std::string& origin) {
  return "<joint name=\"to_" + child + "\" type=\"" + type + "\"><parent link=\"root\"/><child link=\"" + child +
         "\"/><axis xyz=\"0 0 1\"/><limit effort=\"1\" velocity=\"1\" lower=\"0\" upper=\"1\"/>" + origin + "</joint>";
}
const std::string kBox = "<box size=\"1 2 3\"/>";
const std::string kPartObj = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

Result<std::vector<Occurrence>> import(const TemporaryFolder& folder, const std::string& text) {
  return importUrdf(folder.write("model.urdf", text), folder.path());
}

TEST(Urdf, ReadsShapesJointsAndColours) {
  const TemporaryFolder folder;
  const Result<std::vector<Occurrence>> model = import(
      folder,
      robot("<material name=\"blue\"><color rgba=\"0 0 1 1\"/></material>" + link("root") +
            link("wall", "<visual><geometry>" + kBox + "</geometry><material name=\"blue\"/></visual>" +
                             collision(kBox, "<origin xyz=\"0 0 1.5\"/>")) +
            joint("fixed", "wall", "<origin xyz=\"1 0 0\" rpy=\"0 0 1.5707963267948966\"/>") +
            link("ball", collision("<sphere radius=\"0.5\"/>") + collision("<cylinder radius=\"1\" length=\"2\"/>")) +
            joint("fixed", "ball", "<origin xyz=\"0 5 0\"/>")));
  ASSERT_TRUE(model.ok()) << toString(model.error());
  ASSERT_EQ(model->size(), 2U);  // the root has no geometry

  const Occurrence& wall = (*model)[1];
  EXPECT_EQ(wall.path, "wall");
  EXPECT_TRUE(boundingBox(*wall.mesh).max().isApprox(Vector3(0.5, 1, 3)));
  EXPECT_TRUE((wall.X_FP * Vector3(0, 1, 0)).isApprox(Vector3::Zero(), 1e-12) ||
              (wall.X_FP * Vector3(0, 1, 0)).norm() < 1e-12);
  ASSERT_TRUE(wall.colour.has_value());
  EXPECT_EQ(*wall.colour, (std::array<double, 3>{0, 0, 1}));

  const Occurrence& ball = (*model)[0];
  EXPECT_EQ(audit(*ball.mesh).surfaces.size(), 2U);  // both collision shapes
  EXPECT_GE(boundingBox(*ball.mesh).max().x(), 1.0);
  EXPECT_EQ(ball.X_FP.position, Vector3(0, 5, 0));
  EXPECT_FALSE(ball.colour.has_value());
}

TEST(Urdf, VisualGeometryStandsInForMissingCollisionGeometry) {
  const TemporaryFolder folder;
  const auto model = import(folder, robot(link("root", "<visual><geometry>" + kBox + "</geometry></visual>")));
  ASSERT_TRUE(model.ok()) << toString(model.error());
  EXPECT_EQ((*model)[0].mesh->triangles.size(), 12U);
}

TEST(Urdf, MeshFilesAreFoundInsideTheFolder) {
  const TemporaryFolder folder;
  folder.write("meshes/part.obj", kPartObj);
  for (const std::string name : {"meshes/part.obj", "package://meshes/part.obj"}) {
    const auto model =
        import(folder, robot(link("root", collision("<mesh filename=\"" + name + "\" scale=\"2 1 1\"/>"))));
    ASSERT_TRUE(model.ok()) << toString(model.error());
    EXPECT_TRUE(boundingBox(*(*model)[0].mesh).max().isApprox(Vector3(2, 2, 3)));
  }
}

struct MalformedRobot {
  const char* what;
  std::string text;
  const char* place;
  const char* reason;
};

/// Two joints between each link and the next: 2^60 paths from the root to the last link.
std::string chainOfPairs() {
  std::string content = link("l0", collision(kBox));
  for (int i = 1; i <= 60; ++i) {
    const std::string child = "l" + std::to_string(i);
    content += link(child, collision(kBox));
    for (const char* name : {"a", "b"}) {
      content += "<joint name=\"" + (name + child) + "\" type=\"fixed\"><parent link=\"l" + std::to_string(i - 1) +
                 "\"/><child link=\"" + child + "\"/></joint>";
    }
  }
  return content;
}

std::string chain(int links) {
  std::string content = link("l0", collision(kBox));
  for (int i = 1; i < links; ++i) {
    const std::string child = "l" + std::to_string(i);
    content += link(child) + "<joint name=\"" + child + "\" type=\"fixed\"><parent link=\"l" + std::to_string(i - 1) +
               "\"/><child link=\"" + child + "\"/></joint>";
  }
  return content;
}

/// 413 KB with a depth of 30,000 elements that attributes hid.
std::string hiddenDepth() {
  std::string text = "<robot name=\"r\">";
  for (int i = 0; i < 30'000; ++i) text += "<a b=\"</a>\">";
  return text;
}

std::vector<MalformedRobot> malformedRobots() {
  std::string deep;
  for (int i = 0; i < 50'000; ++i) deep += "<a>";
  const auto joined = [](const std::string& parent, const std::string& child) {
    return "<joint name=\"" + parent + child + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" +
           child + "\"/></joint>";
  };
  return {
      {"a broken number", robot(link("root", collision("<box size=\"1 x 3\"/>"))), "", "[x]"},
      {"an unknown shape", robot(link("root", collision("<cone/>"))), "", "'cone'"},
      {"a negative box", robot(link("root", collision("<box size=\"1 -2 3\"/>"))), "link 'root'", "positive"},
      {"a flat cylinder", robot(link("root", collision("<cylinder radius=\"0\" length=\"1\"/>"))), "link 'root'",
       "positive"},
      {"an enormous sphere", robot(link("root", collision("<sphere radius=\"1e300\"/>"))), "link 'root'", "positive"},
      {"a NaN", robot(link("root", collision("<sphere radius=\"nan\"/>"))), "", "[nan]"},
      {"a far origin", robot(link("root", collision(kBox, "<origin xyz=\"1e200 0 0\"/>"))), "link 'root'",
       "not finite"},
      {"a movable joint", robot(link("root") + link("arm", collision(kBox)) + joint("revolute", "arm", "")),
       "joint 'to_arm'", "not fixed"},
      {"a lost parent", robot(link("arm", collision(kBox)) + joint("fixed", "arm", "")), "", "[root]"},
      {"two roots", robot(link("a", collision(kBox)) + link("b", collision(kBox))), "", "Two root links"},
      {"equal names", robot(link("a", collision(kBox)) + link("a", collision(kBox))), "", "'a' is not unique"},
      {"no geometry", robot(link("root")), "", "holds no shape"},
      {"a missing mesh", robot(link("root", collision("<mesh filename=\"gone.stl\"/>"))), "", "No such file"},
      {"a mesh outside", robot(link("root", collision("<mesh filename=\"../gone.stl\"/>"))), "link 'root'", "leaves"},
      {"a mesh by address", robot(link("root", collision("<mesh filename=\"file:///etc/passwd.stl\"/>"))), "",
       "No such file"},
      {"a package outside", robot(link("root", collision("<mesh filename=\"package://a/../../gone.stl\"/>"))),
       "link 'root'", "leaves"},
      {"broken XML", "<robot name=\"r\">\n<link name=\"a\"", "line 2", "does not end"},
      {"deep XML", "<robot>" + deep, "line 1", "nested too deeply"},
      {"a hidden depth", hiddenDepth(), "line 1", "&lt;"},
      {"two joints of one child", robot(chainOfPairs()), "", "child of two joints"},
      {"a ring beside the tree",
       robot(link("root", collision(kBox)) + link("a", collision(kBox)) + link("b", collision(kBox)) +
             joined("a", "b") + joined("b", "a")),
       "", "no joint connects"},
      {"very many links", robot(chain(10'000)), "", "more than 4000 links"},
      {"a very small box", robot(link("root", collision("<box size=\"1 1e-13 1\"/>"))), "link 'root'", "1e-12"},
      {"an origin beyond the limit", robot(link("root", collision(kBox, "<origin xyz=\"1.1e9 0 0\"/>"))), "link 'root'",
       "1e9"},
      {"another root", "<sdf/>", "", "'robot'"},
      {"a document type", "<!DOCTYPE r [<!ENTITY a \"b\">]><robot name=\"r\"/>", "", "document type"},
      {"invalid UTF-8", robot(link("ro\xff\xfeot", collision(kBox))), "line 2", "UTF-8"},
      {"an empty file", "", "", "empty"},
      {"text", "hello", "", "empty"},
  };
}

TEST(Urdf, AChainOfAllLinksAllowedIsRead) {
  const TemporaryFolder folder;
  const auto model = import(folder, robot(chain(4000)));
  ASSERT_TRUE(model.ok()) << toString(model.error());
  EXPECT_EQ(model->size(), 1U);
}

TEST(Urdf, MalformedFilesGiveOneClearMessage) {
  for (const MalformedRobot& row : malformedRobots()) {
    SCOPED_TRACE(row.what);
    const TemporaryFolder folder;
    const Result<std::vector<Occurrence>> model = import(folder, row.text);
    ASSERT_FALSE(model.ok());
    EXPECT_EQ(model.error().kind, ErrorKind::MalformedInput);
    EXPECT_THAT(model.error().file, testing::StartsWith(folder.path()));
    EXPECT_THAT(toString(model.error().location), testing::StartsWith(row.place));
    ASSERT_NE(std::string(row.reason), "");
    EXPECT_THAT(toString(model.error().reason), testing::HasSubstr(row.reason));
    EXPECT_FALSE(model.error().advice.empty());
  }
}

}  // namespace
}  // namespace glissade
