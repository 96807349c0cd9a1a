#include "engine/import/omplapp_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/support/sample_cfg.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

const std::string kConfig = test::kSampleCfg;

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kConfig;
  return text.replace(text.find(from), from.size(), to);
}

TEST(OmplApp, IsReadAsOmplAppReadsIt) {
  const test::TemporaryFolder folder;
  const Result<OmplAppConfig> config = readOmplAppConfig(folder.write("test.cfg", kConfig));
  ASSERT_TRUE(config.ok()) << toString(config.error());
  EXPECT_EQ(config->name, "Test");
  EXPECT_EQ(config->start.position, Vector3(1, 2, 3));
  EXPECT_TRUE((config->start.orientation * Vector3::UnitX()).isApprox(Vector3::UnitY(), 1e-12));
  EXPECT_EQ(config->volume.max().x(), 20.0);  // extended to contain the goal
  EXPECT_EQ(config->volume.min().x(), -5.0);
}

TEST(OmplApp, FaultsAreNamedWithTheirKeyOrLine) {
  const std::vector<std::tuple<std::string, std::string, std::string>> table{
      {replaced("start.x = 1", "start.x = 1,5"), "start.x", "not a finite number"},
      {replaced("start.x = 1", "start.x = nan"), "start.x", "not a finite number"},
      {replaced("start.x = 1", "start.x 1"), "line 6", "key = value"},
      {replaced("start.axis.z = 2", "start.axis.z = 0"), "start.axis", "zero"},
      {replaced("goal.z = 0\n", ""), "goal.z", "missing"},
      {replaced("volume.min.x = -5", "volume.min.x = 50"), "volume", "above"},
      {"[planner]\nrrt=\n", "[problem]", "missing"},
  };
  for (const auto& [text, place, reason] : table) {
    SCOPED_TRACE(place + " " + reason);
    const test::TemporaryFolder folder;
    const Result<OmplAppConfig> config = readOmplAppConfig(folder.write("test.cfg", text));
    ASSERT_FALSE(config.ok());
    EXPECT_EQ(config.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(config.error().location), place);
    EXPECT_THAT(toString(config.error().reason), testing::HasSubstr(reason));
  }
}

}  // namespace
}  // namespace glissade
