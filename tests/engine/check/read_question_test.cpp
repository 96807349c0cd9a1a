#include "engine/check/read_question.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <tuple>

#include "engine/files/judged_product.h"
#include "engine/files/scenario_file.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade::check {
namespace {

/// Expects that the readers of the judge and of the planner give the same result for a file.
void expectSameQuestion(const std::string& file) {
  SCOPED_TRACE(file);
  const auto loaded = loadScenario(file, StopToken());
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  const auto read = readQuestion(file);
  ASSERT_TRUE(read.ok()) << toString(read.error());
  const Question expected = judgedQuestion(*loaded);
  ASSERT_EQ(read->product.bodies.size(), expected.product.bodies.size());
  for (std::size_t i = 0; i < expected.product.bodies.size(); ++i) {
    const Body& a = read->product.bodies[i];
    const Body& b = expected.product.bodies[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.X_WB, b.X_WB) << a.id;
    EXPECT_EQ(a.mesh->vertices, b.mesh->vertices) << a.id;
    EXPECT_EQ(a.mesh->triangles, b.mesh->triangles) << a.id;
    EXPECT_EQ(a.deflection, b.deflection) << a.id;
    EXPECT_EQ(a.spacing, b.spacing) << a.id;
    // The planner's name of a group also gives the number of further bodies.
    if (i + 1 < expected.product.bodies.size() || loaded->objectBodies.size() == 1) {
      EXPECT_EQ(a.name, b.name);
    }
  }
  EXPECT_EQ(read->goal, expected.goal);
  EXPECT_EQ(read->requiredClearance, expected.requiredClearance);
  EXPECT_EQ(read->contactGap, expected.contactGap);
  EXPECT_TRUE(read->workspace.isApprox(expected.workspace));
  EXPECT_EQ(read->product.fits.on, expected.product.fits.on);
  ASSERT_EQ(read->product.fits.pairs.size(), expected.product.fits.pairs.size());
  for (std::size_t i = 0; i < expected.product.fits.pairs.size(); ++i) {
    const PairWord& a = read->product.fits.pairs[i];
    const PairWord& b = expected.product.fits.pairs[i];
    EXPECT_EQ(std::tie(a.a, a.b, a.kind, a.allowance, a.accepted, a.pitch, a.turned),
              std::tie(b.a, b.b, b.kind, b.allowance, b.accepted, b.pitch, b.turned));
  }
}

/// Two readers that share no code for scenarios agree on what a file says.
TEST(ReadQuestion, SaysOfEverySampleWhatThePlannersReaderSays) {
  std::size_t seen = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceDirectory() + "/samples")) {
    if (entry.path().extension() != ".json" && entry.path().extension() != ".cfg") continue;
    if (!loadScenario(entry.path().string(), StopToken())) continue;
    ++seen;
    expectSameQuestion(entry.path().string());
  }
  EXPECT_GT(seen, 3U);
}

/// Boxes in a row, some of which move as one, with statements about random pairs.
Scenario randomGroup(RandomStream& random) {
  Scenario scenario;
  scenario.object.bodies.clear();
  const auto body = [&random](const std::string& id) {
    BodyDescription description{BodyId(id), "rack/" + id, Mobility::Static, BoxGeometry{{0.1, 0.1, 0.1}}};
    description.pose = randomPose(random, 1.0);
    return description;
  };
  for (const char* id : {"a", "b", "c", "d"}) scenario.bodies.push_back(body(id));
  for (const char* id : {"e", "f", "g"}) scenario.object.bodies.push_back(body(id));
  scenario.object.first().pose = Pose::identity();
  scenario.object.referencePoint = {0.01, 0.02, 0.03};
  scenario.start = randomPose(random, 1.0);
  scenario.goal = GoalOut{};
  scenario.workspace = Box3(Vector3::Constant(-5.0), Vector3::Constant(5.0));
  scenario.fits.on = true;
  const std::string ids = "abcdefg";
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (std::size_t j = i + 1; j < ids.size(); ++j) {
      if (random.uniform() < 0.4) continue;
      FitEdit edit{BodyId(ids.substr(i, 1)), BodyId(ids.substr(j, 1)), {}, {}, random.uniform() < 0.7};
      if (random.uniform() < 0.5) edit.kind = ContactKind::Planar;
      scenario.fits.pairs.push_back(edit);
    }
  }
  return scenario;
}

TEST(ReadQuestion, SaysOfGroupsWhatThePlannersReaderSays) {
  const test::TemporaryFolder folder;
  RandomStream random(1, "groups");
  for (int i = 0; i < 20; ++i) {
    const Scenario scenario = randomGroup(random);
    const std::string file = folder.write("group.json", writeScenario(scenario));
    expectSameQuestion(file);
    // A clash with a group is accepted if it is accepted for each of its bodies.
    const auto read = readQuestion(file);
    ASSERT_TRUE(read.ok());
    for (const BodyDescription& other : scenario.bodies) {
      const PairWord* word = read->product.fits.about("e", other.id);
      std::size_t accepted = 0;
      for (const FitEdit& edit : scenario.fits.pairs) {
        const bool isGroup = edit.b == "e" || edit.b == "f" || edit.b == "g";
        accepted += edit.a == other.id && isGroup && edit.accepted ? 1 : 0;
      }
      EXPECT_EQ(word != nullptr && word->accepted, accepted == 3U) << other.id;
    }
    // Plans concern the bodies of the group.
    const auto product = readProduct(file, 0.0);
    ASSERT_TRUE(product.ok()) << toString(product.error());
    EXPECT_EQ(product->bodies.size(), 7U);
    EXPECT_EQ(product->fits.pairs.size(), scenario.fits.pairs.size());
  }
}

TEST(ReadQuestion, WhatIsLeftOutIsNotThereAndIsSaid) {
  const test::TemporaryFolder folder;
  RandomStream random(2, "groups");
  Scenario scenario = randomGroup(random);
  scenario.fits.pairs.clear();
  scenario.leftOut.push_back(scenario.bodies.back());
  scenario.bodies.pop_back();
  const auto read = readQuestion(folder.write("left.json", writeScenario(scenario)));
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->product.bodies.size(), 4U);
  ASSERT_EQ(read->product.warnings.size(), 1U);
  EXPECT_EQ(toString(read->product.warnings.front().location), "'rack/d'");
  EXPECT_EQ(toString(read->product.warnings.front().reason), "is excluded");
}

TEST(ReadQuestion, ForbiddenRegionsAndPitchesAreRead) {
  const test::TemporaryFolder folder;
  const auto question = [&](const std::string& more) {
    return readQuestion(
        folder.write("scenario.json", R"({"format": "glissade-scenario", "version": 1, "bodies": [{"id": "wall",
      "geometry": {"box": [1, 1, 1]}}], "object": {"id": "part", "geometry": {"sphere": {"radius": 0.1}}},
      "start": {"position": [3, 0, 0], "orientation": [0, 0, 0, 1]}, "goal": "out",
      "workspace": {"min": [-9, -9, -9], "max": [9, 9, 9]}, )" +
                                          more + "}"));
  };
  const auto read = question(R"("forbidden_regions": [{"place": "P5", "boxes": [[0, 0, 0, 1, 2, 3]]}])");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  ASSERT_EQ(read->forbidden.size(), 1U);
  EXPECT_EQ(read->forbidden[0].place, "P5");
  EXPECT_EQ(read->forbidden[0].boxes[0].max(), Vector3(1, 2, 3));
  const auto pitch = [&](const std::string& value) {
    return question(R"("fits": {"mode": "on", "pairs": [{"a": "wall", "b": "part", "kind": "thread", "pitch_m": )" +
                    value + "}]}");
  };
  EXPECT_TRUE(pitch("0.0015").ok());
  for (const char* wrong : {"1e6", "0", "-1e-9", "1e12"}) {
    const auto refused = pitch(wrong);
    ASSERT_FALSE(refused.ok()) << wrong;
    EXPECT_EQ(toString(refused.error().location), "/fits/pairs/0/pitch_m");
  }
  EXPECT_FALSE(question(R"("fits": {"mode": "on", "pairs": [{"a": "wall", "b": "nobody"}]})").ok());
}

}  // namespace
}  // namespace glissade::check
