#include "engine/check/read_question.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/scenario/judged_product.h"
#include "engine/scenario/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade::check {
namespace {

/// Two readers that share no code for scenarios agree on what a file says.
TEST(ReadQuestion, SaysOfEverySampleWhatThePlannersReaderSays) {
  std::size_t seen = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceDirectory() + "/samples")) {
    if (entry.path().extension() != ".json" && entry.path().extension() != ".cfg") continue;
    const auto loaded = loadScenario(entry.path().string(), StopToken());
    if (!loaded) continue;
    ++seen;
    const auto read = readQuestion(entry.path().string());
    ASSERT_TRUE(read.ok()) << entry.path() << toString(read.error());
    const Question expected = judgedQuestion(*loaded);
    ASSERT_EQ(read->product.bodies.size(), expected.product.bodies.size()) << entry.path();
    for (std::size_t i = 0; i < expected.product.bodies.size(); ++i) {
      const Body& a = read->product.bodies[i];
      const Body& b = expected.product.bodies[i];
      EXPECT_EQ(a.id, b.id);
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.X_WB, b.X_WB) << a.id;
      EXPECT_EQ(a.mesh->vertices, b.mesh->vertices) << a.id;
      EXPECT_EQ(a.mesh->triangles, b.mesh->triangles) << a.id;
      EXPECT_EQ(a.deflection, b.deflection) << a.id;
      EXPECT_EQ(a.spacing, b.spacing) << a.id;
    }
    EXPECT_EQ(read->goal, expected.goal);
    EXPECT_EQ(read->requiredClearance, expected.requiredClearance);
    EXPECT_EQ(read->contactGap, expected.contactGap);
    EXPECT_TRUE(read->workspace.isApprox(expected.workspace));
    EXPECT_EQ(read->product.fits.on, expected.product.fits.on);
    EXPECT_EQ(read->product.fits.pairs.size(), expected.product.fits.pairs.size());
  }
  EXPECT_GT(seen, 3U);
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
    EXPECT_EQ(refused.error().location, "/fits/pairs/0/pitch_m");
  }
  EXPECT_FALSE(question(R"("fits": {"mode": "on", "pairs": [{"a": "wall", "b": "nobody"}]})").ok());
}

}  // namespace
}  // namespace glissade::check
