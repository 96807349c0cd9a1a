#include "engine/files/part_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "engine/base/file.h"
#include "engine/files/scenario_io.h"
#include "engine/session/start_check.h"
#include "tests/engine/support/part_fixture.h"
#include "tests/engine/support/test_host.h"

namespace glissade {
namespace {

using test::TrayProduct;
using testing::HasSubstr;

constexpr double kMillimetre = 0.001;
const std::string kUrdf =
    "<robot name=\"r\"><link name=\"post\"><collision><origin xyz=\"0 0 0.5\"/><geometry><box size=\"0.1 0.2 1\"/>"
    "</geometry></collision></link></robot>";

PartFile partOf(const std::string& path, PartRole role = PartRole::Static) {
  PartFile part = usualPart(path);
  part.role = role;
  return part;
}

Scenario scenarioOf(const TrayProduct& product) {
  auto scenario = scenarioOfParts({partOf(product.tray), partOf(product.block, PartRole::Moves)});
  EXPECT_TRUE(scenario) << toString(scenario.error());
  return std::move(*scenario);
}

std::vector<std::string> bodyIds(const Scenario& scenario) {
  std::vector<std::string> ids;
  for (const BodyDescription& body : scenario.bodies) ids.push_back(body.id.text());
  return ids;
}

template <class T>
void expectRefused(const Result<T>& result, ErrorKind kind, const std::string& file, const std::string& reason) {
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, kind);
  EXPECT_THAT(result.error().file, HasSubstr(file));
  EXPECT_THAT(toString(result.error().reason), HasSubstr(reason));
  EXPECT_FALSE(result.error().advice.empty());
}

/// Bounding boxes of all bodies and of the object at its start.
std::vector<Box3> boxesOf(const LoadedScenario& loaded) {
  std::vector<Box3> boxes{boundingBox(*loaded.object.mesh, loaded.object.X_WB)};
  for (const RigidBody& body : loaded.obstacles) boxes.push_back(boundingBox(*body.mesh, body.X_WB));
  return boxes;
}

TEST(ScenarioOfParts, PartsLieWhereTheirFilesHaveThem) {
  const TrayProduct product;
  const Scenario scenario = scenarioOf(product);
  const auto loaded = loadGeometry(scenario, "/none", "");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  EXPECT_TRUE(loaded->warnings.empty());
  const std::vector<Box3> boxes = boxesOf(*loaded);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_TRUE(boxes[0].center().isApprox(kMillimetre * product.centre, 1e-6));
  EXPECT_TRUE(boxes[0].sizes().isApprox(kMillimetre * product.blockSize, 1e-3));
  EXPECT_TRUE(boxes[1].sizes().isApprox(Vector3(0.11, 0.09, 0.065), 1e-3));
  EXPECT_EQ(scenario.name, "") << "not that of the part that moves";
  EXPECT_EQ(scenario.object.first().id, "block");
  EXPECT_EQ(bodyIds(scenario), std::vector<std::string>{"tray"});
  EXPECT_EQ(scenario.seed, 1U);
}

TEST(ScenarioOfParts, TheReferencePointIsInThePartHoweverFarTheFilesOriginIs) {
  const TrayProduct product;
  const auto loaded = loadGeometry(scenarioOf(product), "/none", "");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  EXPECT_NEAR(loaded->problem.world->objectRadius(), 0.5 * kMillimetre * product.blockSize.norm(), 1e-5);
  EXPECT_TRUE(loaded->problem.start.position.isApprox(kMillimetre * product.centre, 1e-6));
}

TEST(ScenarioOfParts, ABlockIsPlannedOutOfItsTray) {
  const TrayProduct product;
  const auto loaded = loadGeometry(scenarioOf(product), "/none", "");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  const Outcome start = checkStart(loaded->problem, loaded->parameters[ParameterId::RequiredClearance]);
  ASSERT_TRUE(start) << toString(start.error());
  const PlannerRegistry registry = makePlannerRegistry();
  const PlannerEntry* entry = registry.find(loaded->scenario.planner);
  ASSERT_NE(entry, nullptr);
  TestHost host(loaded->problem, 200000);
  const auto planner = entry->make(loaded->problem, loaded->scenario.seed);
  ASSERT_TRUE(planner->solve(host));
  EXPECT_EQ(planner->path()->certificate.status, CertificateStatus::Certified);
  const Box3 out = boundingBox(*loaded->object.mesh, planner->path()->points.back().q);
  EXPECT_TRUE(out.intersection(loaded->problem.world->obstaclesBox()).isEmpty());
}

TEST(ScenarioOfParts, OutIsWithinReachOnEverySide) {
  const TrayProduct product;
  const auto loaded = loadGeometry(scenarioOf(product), "/none", "");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  const Box3& obstacles = loaded->problem.world->obstaclesBox();
  const Vector3 radius = Vector3::Constant(loaded->problem.world->objectRadius());
  EXPECT_TRUE(loaded->problem.bounds.contains(Box3(obstacles.min() - radius, obstacles.max() + radius)));
}

TEST(ScenarioOfParts, SavedAndReadAgainItIsTheSame) {
  const TrayProduct product;
  const std::string robot = product.folder.write("post.urdf", kUrdf);
  const std::vector<std::vector<PartFile>> products{
      {partOf(product.tray), partOf(product.block, PartRole::Moves)},
      {partOf(product.block), partOf(product.block, PartRole::Mobile), partOf(product.tray, PartRole::Moves)},
      {partOf(robot, PartRole::Moves), partOf(product.tray, PartRole::Mobile)},
      {{product.tray, PartRole::Static, 0.0254, UpAxis::Y}, {product.block, PartRole::Moves, 1.0 / 3.0, UpAxis::Z}},
      {partOf(product.block, PartRole::Moves)}};
  const std::string file = product.folder / "scenario.json";
  for (const auto& parts : products) {
    auto scenario = scenarioOfParts(parts);
    ASSERT_TRUE(scenario) << toString(scenario.error());
    const auto before = loadGeometry(*scenario, "/none", "");
    ASSERT_TRUE(before) << toString(before.error());
    ASSERT_TRUE(saveScenario(*scenario, file));
    const auto after = loadScenario(file);
    ASSERT_TRUE(after) << toString(after.error());
    for (Asset& asset : scenario->assets) asset.sha256 = *assetSha256(asset, file);
    EXPECT_EQ(writeScenario(after->scenario), writeScenario(*scenario));
    EXPECT_EQ(after->problem.start, before->problem.start);
    const auto there = boxesOf(*after);
    const auto here = boxesOf(*before);
    ASSERT_EQ(there.size(), parts.size());
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_TRUE(there[i].isApprox(here[i], 0.0));
  }
}

TEST(ScenarioOfParts, IdsComeFromFileNamesAndAreUnique) {
  const TrayProduct product;
  const std::string other = product.writeBlock("other/block.obj", {0, 0, 400});
  const std::string third = product.writeBlock("third/block.obj", {0, 0, 800});
  const std::vector<PartFile> parts{partOf(product.block), partOf(other, PartRole::Moves),
                                    partOf(third, PartRole::Mobile)};
  const auto scenario = scenarioOfParts(parts);
  ASSERT_TRUE(scenario) << toString(scenario.error());
  EXPECT_EQ(scenario->object.first().id, "block");
  EXPECT_EQ(bodyIds(*scenario), (std::vector<std::string>{"block-2", "block-3"}));
  EXPECT_EQ(scenario->bodies[0].mobility, Mobility::Static);
  EXPECT_EQ(scenario->bodies[1].mobility, Mobility::Mobile);
  EXPECT_EQ(scenario->assets.size(), 3U);
  EXPECT_EQ(writeScenario(*scenario), writeScenario(*scenarioOfParts(parts)));
}

TEST(ScenarioOfParts, OnePartMovesOrSeveralAsOne) {
  const TrayProduct product;
  expectRefused(scenarioOfParts({}), ErrorKind::Usage, "", "no part");
  expectRefused(scenarioOfParts({partOf(product.tray)}), ErrorKind::Usage, "", "no part is the moving part");
  const auto both = scenarioOfParts({partOf(product.tray, PartRole::Moves), partOf(product.block, PartRole::Moves)});
  ASSERT_TRUE(both) << toString(both.error());
  EXPECT_TRUE(both->bodies.empty());
  ASSERT_EQ(both->object.bodies.size(), 2U);
  EXPECT_EQ(both->object.first().id, "tray");
  EXPECT_EQ(both->object.bodies[1].id, "block");
  expectRefused(scenarioOfParts({{product.tray, PartRole::Moves, 0.0, UpAxis::Z}}), ErrorKind::Usage, "tray.obj",
                "unit");
}

TEST(ScenarioOfParts, FilesThatCannotBeReadAreNamed) {
  const TrayProduct product;
  const auto with = [&](const PartFile& part) {
    return scenarioOfParts({partOf(product.block, PartRole::Moves), part});
  };
  constexpr ErrorKind kMalformed = ErrorKind::MalformedInput;
  expectRefused(with(partOf(product.folder / "gone.stl")), kMalformed, "gone.stl", "No such file");
  expectRefused(with(partOf(product.folder.write("a.stl", "solid a\nfacet"))), kMalformed, "a.stl", "endsolid");
  expectRefused(with(partOf(product.folder.write("a.iges", "S"))), kMalformed, "a.iges", "cannot be read as IGES");
  expectRefused(with(partOf(product.folder.write("a.SLDPRT", "x"))), kMalformed, "a.SLDPRT", "is a SolidWorks file");
  expectRefused(with(partOf(product.folder.write("a.xyz", "x"))), kMalformed, "a.xyz", "kind");
  expectRefused(with(partOf(product.folder.write("a.step", "ISO"))), kMalformed, "a.step", "not a STEP file");
  expectRefused(with(partOf(product.folder.write("point.obj", "v 1 2 3\nf 1 1 1\n"))), kMalformed, "point.obj",
                "triangle");
  PartFile robot = partOf(product.folder.write("post.urdf", kUrdf));
  robot.unit = kMillimetre;
  const auto refused = with(robot);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(toString(refused.error()), HasSubstr("post"));
}

TEST(WithParts, AddsBodiesBesideThoseThatAreThere) {
  const TrayProduct product;
  const Scenario scenario = scenarioOf(product);
  const std::string lid = product.folder.write("lid/tray.obj", readFile(product.tray, 1U << 20).value());
  const auto more = withParts(scenario, "", {partOf(lid, PartRole::Mobile), partOf(product.block)});
  ASSERT_TRUE(more) << toString(more.error());
  EXPECT_EQ(bodyIds(*more), (std::vector<std::string>{"tray", "tray-2", "block-2"}));
  EXPECT_EQ(more->bodies[1].mobility, Mobility::Mobile);
  EXPECT_EQ(more->assets.size(), 3U) << "the block's file is one asset";
  EXPECT_EQ(std::get<MeshGeometry>(more->bodies[2].geometry).asset, "block");
}

TEST(WithParts, AFileTakenAnotherWayIsAnotherAsset) {
  const TrayProduct product;
  const Scenario scenario = scenarioOf(product);
  const auto more = withParts(scenario, "", {{product.tray, PartRole::Static, kMillimetre, UpAxis::Y}});
  ASSERT_TRUE(more) << toString(more.error());
  EXPECT_EQ(more->assets.size(), 3U);
}

TEST(WithParts, ASavedScenarioNamesThemAsItsOtherFiles) {
  const TrayProduct product;
  const std::string file = product.folder / "scenario.json";
  const auto more = withParts(scenarioOf(product), file, {partOf(product.writeBlock("more/pin.obj", {0, 0, 90}))});
  ASSERT_TRUE(more) << toString(more.error());
  EXPECT_EQ(more->assets.back().path, "more/pin.obj");
  ASSERT_TRUE(saveScenario(*more, file));
  const auto loaded = loadScenario(file);
  ASSERT_TRUE(loaded) << toString(loaded.error());
  EXPECT_EQ(loaded->obstacles.size(), 2U);
  const auto again = withParts(*more, file, {partOf(product.folder / "more/../more/pin.obj")});
  ASSERT_TRUE(again) << toString(again.error());
  EXPECT_EQ(again->assets.size(), more->assets.size());
}

TEST(WithParts, OutStaysWithinReachAndOtherWorkspacesAsTheyAre) {
  const TrayProduct product;
  Scenario scenario = scenarioOf(product);
  const PartFile far = partOf(product.writeBlock("far.obj", {5000, 0, 0}));
  const auto grown = withParts(scenario, "", {far});
  ASSERT_TRUE(grown) << toString(grown.error());
  EXPECT_TRUE(grown->workspace.contains(scenario.workspace));
  EXPECT_GT(grown->workspace.max().x(), 7.0);
  scenario.goal = scenario.start;
  const auto kept = withParts(scenario, "", {far});
  ASSERT_TRUE(kept) << toString(kept.error());
  EXPECT_TRUE(kept->workspace.isApprox(scenario.workspace, 0.0));
}

TEST(WithParts, RefusesWhatItCannotAdd) {
  const TrayProduct product;
  const Scenario scenario = scenarioOf(product);
  expectRefused(withParts(scenario, "", {}), ErrorKind::Usage, "", "no part");
  expectRefused(withParts(scenario, "", {partOf(product.tray, PartRole::Moves)}), ErrorKind::Usage, "tray.obj",
                "moving part");
  expectRefused(withParts(scenario, "", {partOf(product.folder / "gone.obj")}), ErrorKind::MalformedInput, "gone.obj",
                "No such file");
}

/// Two boxes as groups of one OBJ file, the second one in two pieces.
std::string writeGroups(const test::TemporaryFolder& folder) {
  const std::string v =
      "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 10 10 0\nv 0 0 10\nv 10 0 10\nv 0 10 10\nv 10 10 10\n"
      "v 20 0 0\nv 50 0 0\nv 20 30 0\nv 50 30 0\nv 20 0 30\nv 50 0 30\nv 20 30 30\nv 50 30 30\n";
  return folder.write("two.obj", v + "g lid/top\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
                                     "g base\nf 9 11 12 10\nf 13 14 16 15\nf 9 10 14 13\ng other\ng base\n"
                                     "f 11 15 16 12\nf 9 13 15 11\nf 10 12 16 14\n");
}

/// '/' separates steps in paths of parts. Triangles before the first statement are in a group without a name.
TEST(PartFiles, GroupsOfDifferentNamesAreDifferentParts) {
  const test::TemporaryFolder folder;
  std::string text;
  for (const char* statement : {"", "g group\n", "g a/b\n", "g a.b\n"}) {
    text +=
        std::string(statement) + "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n";
  }
  GeometryCache read;
  const auto parts = partsInFile(folder.write("groups.obj", text), read, {}, true);
  ASSERT_TRUE(parts) << toString(parts.error());
  std::set<std::string> names;
  for (const MeasuredPart& part : *parts) names.insert(part.part);
  EXPECT_EQ(names, (std::set<std::string>{"group", "group#2", "a.b", "a.b#2"}));
}

TEST(PartFiles, GroupsOfAnObjFileArePartsOnDemand) {
  const test::TemporaryFolder folder;
  PartFile whole = partOf(writeGroups(folder));
  PartFile moving = usualPart(whole.path + ":lid.top");
  moving.role = PartRole::Moves;
  EXPECT_TRUE(moving.groups);
  GeometryCache read;
  EXPECT_EQ(partsInFile(whole.path, read)->size(), 1U) << "as it always was";
  EXPECT_EQ(partsInFile(whole.path, read, {}, true)->size(), 2U);
  whole.groups = true;
  const auto scenario = scenarioOfParts({moving, whole}, &read);
  ASSERT_TRUE(scenario) << toString(scenario.error());
  const std::string text = writeScenario(*scenario);
  const auto again = parseScenario(text, "groups.json");
  ASSERT_TRUE(again) << toString(again.error());
  EXPECT_EQ(writeScenario(*again), text);
  const auto loaded = loadGeometry(*again, "/none", "");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  EXPECT_TRUE(loaded->warnings.empty()) << toString(loaded->warnings.front());
  ASSERT_EQ(loaded->obstacles.size(), 1U);
  EXPECT_EQ(loaded->obstacles.front().name, "base");
  EXPECT_EQ(loaded->obstacles.front().mesh->triangles.size(), 12U);
  EXPECT_EQ(loaded->obstacles.front().mesh->vertices.size(), 8U);
  EXPECT_EQ(loaded->object.mesh->vertices.size(), 8U);
  expectRefused(scenarioOfParts({usualPart(whole.path + ":gone"), moving}), ErrorKind::MalformedInput, "two.obj",
                "is not in the file");
}

TEST(PartFiles, AreTakenAsTheirKindUsuallyIs) {
  EXPECT_EQ(usualPart("a.3mf:#1").path, "a.3mf") << "the kind is said, and not that no file has this name";
  EXPECT_EQ(usualPart("a.STL").unit, kMillimetre);
  EXPECT_EQ(usualPart("a.obj").up, UpAxis::Z);
  for (const char* collada : {"a.dae", "a.gltf", "a.GLB"}) {
    EXPECT_EQ(usualPart(collada).unit, 1.0) << collada;
    EXPECT_EQ(usualPart(collada).up, UpAxis::Y) << collada;
  }
  for (const char* own : {"a.urdf", "a.STEP", "b.stp"}) {
    EXPECT_EQ(usualPart(own).unit, 1.0) << own;
    EXPECT_EQ(usualPart(own).up, UpAxis::Z) << own;
    EXPECT_TRUE(saysItsUnit(own) && isPartFile(own)) << own;
  }
  EXPECT_FALSE(saysItsUnit("a.stl"));
  EXPECT_TRUE(isUrdfFile("a.URDF"));
  EXPECT_FALSE(isUrdfFile("urdf.stl"));
}

TEST(PartFiles, TheBoxIsThatOfTheLoadedPart) {
  const TrayProduct product;
  const std::string robot = product.folder.write("post.urdf", kUrdf);
  const std::vector<PartFile> parts{partOf(robot),
                                    {product.tray, PartRole::Static, 0.0254, UpAxis::Y},
                                    {product.tray, PartRole::Mobile, 1.0, UpAxis::Z},
                                    partOf(product.block, PartRole::Moves)};
  const auto scenario = scenarioOfParts(parts);
  ASSERT_TRUE(scenario) << toString(scenario.error());
  const auto loaded = loadGeometry(*scenario, "/none", "");
  ASSERT_TRUE(loaded) << toString(loaded.error());
  for (std::size_t i = 0; i < loaded->obstacles.size(); ++i) {
    GeometryCache read;
    const auto measured = partsInFile(parts[i].path, read);
    ASSERT_TRUE(measured) << toString(measured.error());
    ASSERT_EQ(measured->size(), 1U);
    const Box3 box = boxOfPart(parts[i], measured->front().inFile);
    EXPECT_TRUE(box.isApprox(boundingBox(*loaded->obstacles[i].mesh), 1e-12)) << parts[i].path << ' ' << i;
  }
  GeometryCache none;
  expectRefused(partsInFile(product.folder / "gone.obj", none), ErrorKind::MalformedInput, "gone.obj", "No such file");
}

}  // namespace
}  // namespace glissade
