#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::boxScenario;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

Result<LoadedScenario> load(const Scenario& scenario) { return loadGeometry(scenario, ".", "boxes.json"); }

/// boxScenario with a second body from a mesh file.
Scenario withMesh(const std::string& path) {
  Scenario scenario = boxScenario();
  scenario.assets = {{"part", path, "", 1.0, UpAxis::Z}};
  BodyDescription part;
  part.id = "part";
  part.name = "part";
  part.geometry = MeshGeometry{"part"};
  part.pose = Pose::translation({0, 0, 4});
  scenario.bodies.push_back(part);
  return scenario;
}

void expectRefused(const Result<LoadedScenario>& loaded, const std::string& file, const std::string& reason) {
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().kind, ErrorKind::MalformedInput);
  EXPECT_THAT(loaded.error().file, HasSubstr(file));
  EXPECT_THAT(toString(loaded.error().reason), HasSubstr(reason));
  EXPECT_FALSE(loaded.error().advice.empty());
}

TEST(LoadScenario, RefusesWhatReachesBeyondTheLimitsOfLengths) {
  Scenario scenario = boxScenario();
  scenario.bodies[0].pose = Pose::translation({1e9, 0, 0});
  expectRefused(load(scenario), "boxes.json", "beyond 1e9 m");
  scenario = boxScenario();
  scenario.object.first().geometry = BoxGeometry{{1e-11, 1e-11, 1e-11}};
  expectRefused(load(scenario), "boxes.json", "1e10 times as large as the object");
  const TemporaryFolder folder;
  scenario = withMesh(folder.write("part.obj", kObj));
  scenario.assets[0].unit = 1e9;
  expectRefused(load(scenario), "boxes.json", "beyond 1e9 m");
}

TEST(LoadScenario, SavingNamesAFileWhoseNameIsNoUtf8) {
  const TemporaryFolder folder;
  const Scenario scenario = withMesh(folder.write("part\xff.obj", kObj));
  const Outcome saved = saveScenario(scenario, folder / "scenario.json");
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().kind, ErrorKind::MalformedInput);
  EXPECT_THAT(toString(saved.error().reason), HasSubstr("not valid UTF-8"));
  EXPECT_FALSE(std::filesystem::exists(folder / "scenario.json"));
}

class Samples : public testing::TestWithParam<const char*> {};

TEST_P(Samples, StartGoalAndWayPointsAreFree) {
  const Result<LoadedScenario> loaded = loadScenario(test::sample(GetParam()));
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  EXPECT_TRUE(loaded->warnings.empty()) << toString(loaded->warnings.front());
  EXPECT_FALSE(loaded->scenario.wayPoints.empty());
  const auto query = loaded->problem.world->makeQuery();
  EXPECT_FALSE(query->collides(loaded->problem.start));
  EXPECT_FALSE(query->collides(std::get<Pose>(loaded->problem.goal)));
  for (const Pose& q : loaded->scenario.wayPoints) EXPECT_FALSE(query->collides(q));
}

INSTANTIATE_TEST_SUITE_P(All, Samples, testing::Values("environment-1", "environment-2", "sliding-plane"));

TEST(LoadScenario, EnvironmentOneIsThePapers) {
  const Result<LoadedScenario> loaded = loadScenario(test::sample("environment-1"));
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  ASSERT_EQ(loaded->obstacles.size(), 10U);
  const auto found = std::find_if(loaded->obstacles.begin(), loaded->obstacles.end(),
                                  [](const RigidBody& body) { return body.id == "environment/wall_L1"; });
  ASSERT_NE(found, loaded->obstacles.end());
  const RigidBody& wall = *found;
  EXPECT_EQ(wall.name, "wall_L1");
  EXPECT_TRUE(boundingBox(*wall.mesh, wall.X_WB).max().isApprox(Vector3(5.9, 1.4, 5.15), 1e-12));
  EXPECT_GT(wall.colour[2], wall.colour[0]);                        // blue
  EXPECT_NEAR(loaded->problem.world->objectRadius(), 1.536, 1e-3);  // radius of the L
  EXPECT_EQ(loaded->parameters[ParameterId::ContactDistance], 0.15);
  EXPECT_EQ(loaded->parameters.integer(ParameterId::ContactSamples), 10);
  EXPECT_EQ(loaded->problem.bounds.min().x(), -2.5);
}

TEST(LoadScenario, FilesThatAreNoneAreRefused) {
  const TemporaryFolder folder;
  expectRefused(loadScenario(folder / "gone.json"), "gone.json", "No such file");
  expectRefused(loadScenario(folder.write("empty.json", "")), "empty.json", "empty");
  expectRefused(loadScenario(folder.path()), folder.path(), "regular");
  ASSERT_EQ(::mkfifo((folder / "fifo.json").c_str(), 0600), 0);
  expectRefused(loadScenario(folder / "fifo.json"), "fifo.json", "regular");
}

TEST(LoadScenario, AssetsAreFoundBesideTheFile) {
  const TemporaryFolder folder;
  folder.write("meshes/part.obj", kObj);
  const Result<LoadedScenario> loaded =
      loadScenario(folder.write("scenario.json", writeScenario(withMesh("meshes/part.obj"))));
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  EXPECT_EQ(loaded->obstacles[1].mesh->triangles.size(), 4U);
  EXPECT_TRUE(loaded->warnings.empty());
}

TEST(LoadScenario, MissingAndBrokenAssetsAreNamed) {
  const TemporaryFolder folder;
  expectRefused(loadGeometry(withMesh("gone.stl"), folder.path(), "s.json"), "gone.stl", "No such file");
  folder.write("broken.stl", "solid a\nfacet");
  expectRefused(loadGeometry(withMesh("broken.stl"), folder.path(), "s.json"), "broken.stl", "endsolid");
  expectRefused(loadGeometry(withMesh("/etc/passwd"), folder.path(), "s.json"), "passwd", "kind");
}

TEST(LoadScenario, AChangedAssetIsAWarning) {
  const TemporaryFolder folder;
  folder.write("part.obj", kObj);
  Scenario scenario = withMesh("part.obj");
  scenario.assets[0].sha256 = std::string(64, '0');
  const Result<LoadedScenario> loaded = loadGeometry(scenario, folder.path(), "s.json");
  ASSERT_TRUE(loaded.ok());
  ASSERT_EQ(loaded->warnings.size(), 1U);
  EXPECT_THAT(toString(loaded->warnings[0].reason), HasSubstr("changed"));
}

TEST(LoadScenario, AnOpenSurfaceIsAWarning) {
  const TemporaryFolder folder;
  folder.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Result<LoadedScenario> open = loadGeometry(withMesh("part.obj"), folder.path(), "s.json");
  ASSERT_TRUE(open.ok());
  ASSERT_EQ(open->warnings.size(), 1U);
  EXPECT_THAT(toString(open->warnings[0].location), HasSubstr("part"));
}

TEST(LoadScenario, AUrdfFileHasNoUnitOfItsOwn) {
  const TemporaryFolder folder;
  Scenario scenario = withMesh("part.urdf");
  scenario.bodies[1].geometry = UrdfGeometry{"part"};
  scenario.assets[0].unit = 0.001;
  expectRefused(loadGeometry(scenario, folder.path(), "s.json"), "s.json", "unit");
}

TEST(LoadScenario, ParametersOutOfRangeAreNamed) {
  Scenario scenario = boxScenario();
  scenario.parameters[ParameterId::Alpha] = 1.5;
  const Result<LoadedScenario> loaded = load(scenario);
  expectRefused(loaded, "boxes.json", "Computer share");
  EXPECT_EQ(toString(loaded.error().location), "/parameters/alpha");
}

TEST(LoadScenario, RotationsAreMadeUnit) {
  Scenario scenario = boxScenario();
  scenario.start.orientation.coeffs() *= 1.0005;  // as in a rounded file
  scenario.goal = scenario.start;
  scenario.bodies[0].pose.orientation.coeffs() *= 1.0005;
  const Result<LoadedScenario> loaded = load(scenario);
  ASSERT_TRUE(loaded.ok());
  EXPECT_NEAR(loaded->problem.start.orientation.norm(), 1.0, 1e-15);
  EXPECT_NEAR(std::get<Pose>(loaded->problem.goal).orientation.norm(), 1.0, 1e-15);
  EXPECT_NEAR(loaded->obstacles[0].X_WB.orientation.norm(), 1.0, 1e-15);
}

TEST(LoadScenario, TheUnitAndTheUpAxisOfAnAssetAreApplied) {
  const TemporaryFolder folder;
  folder.write("part.obj", kObj);
  Scenario scenario = withMesh("part.obj");
  scenario.assets[0].unit = 0.5;
  scenario.assets[0].up = UpAxis::Y;
  const Result<LoadedScenario> loaded = loadGeometry(scenario, folder.path(), "s.json");
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  const Box3 box = boundingBox(*loaded->obstacles[1].mesh);
  EXPECT_TRUE(box.max().isApprox(Vector3(0.5, 0, 1), 1e-12)) << box.max().transpose();  // y became z
  EXPECT_NEAR(box.min().y(), -1.5, 1e-12);                                              // z became -y
}

TEST(LoadGeometry, GeometryThatIsKnownIsNotReadAgainAndGivesTheSame) {
  const TemporaryFolder folder;
  folder.write("part.obj", kObj);
  Scenario scenario = withMesh("part.obj");
  const auto first = loadGeometry(scenario, folder.path(), "s.json");
  ASSERT_TRUE(first.ok()) << toString(first.error());
  std::filesystem::remove(folder / "part.obj");
  scenario.bodies.back().pose = Pose::translation({0, 0, 5});
  EXPECT_FALSE(loadGeometry(scenario, folder.path(), "s.json").ok());
  const auto moved = loadGeometry(scenario, folder.path(), "s.json", first->geometry);
  ASSERT_TRUE(moved.ok()) << toString(moved.error());
  EXPECT_EQ(moved->obstacles.back().mesh, first->obstacles.back().mesh);
  EXPECT_EQ(moved->obstacles.back().X_WB, scenario.bodies.back().pose);
  EXPECT_EQ(moved->object.mesh->vertices, first->object.mesh->vertices);

  scenario.assets.front().unit = 0.5;  // other import options give another geometry
  EXPECT_FALSE(loadGeometry(scenario, folder.path(), "s.json", first->geometry).ok());
}

}  // namespace
}  // namespace glissade
