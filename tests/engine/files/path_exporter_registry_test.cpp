#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/engine/files/path_exporter_conformance.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {

/// Every exporter of the product.
PathExportersUnderTest pathExportersUnderTest() {
  PathExportersUnderTest exporters{makePathExporterRegistry(), {}};
  for (const PathExporter& exporter : exporters.registry.entries()) exporters.ids.push_back(exporter.id);
  return exporters;
}

namespace {

TEST(PathExporterRegistry, NoTwoShareAnIdOrAnEnding) {
  std::set<std::string> ids;
  std::set<std::string> endings;
  const PathExporterRegistry registry = makePathExporterRegistry();
  for (const PathExporter& exporter : registry.entries()) {
    EXPECT_TRUE(ids.insert(exporter.id).second) << exporter.id;
    for (const std::string& ending : exporter.endings) EXPECT_TRUE(endings.insert(ending).second) << ending;
  }
  EXPECT_EQ(registry.find("video"), nullptr);
}

TEST(PathExporterRegistry, EndingsMayBeInUpperCaseAndUnknownOnesAreOneErrorThatListsThem) {
  EXPECT_EQ(pathExporterFor("A.GLB")->id, "glb");
  for (const char* file : {"path", "path.", "path.unknown", "folder.csv/path", ".csv"}) {
    const Result<PathExporter> none = pathExporterFor(file);
    ASSERT_FALSE(none.ok()) << file;
    EXPECT_EQ(none.error().kind, ErrorKind::Usage);
    EXPECT_EQ(none.error().file, file);
    EXPECT_THAT(toString(none.error().advice), testing::HasSubstr("Table (.csv), With provenance (.json)"));
    EXPECT_THAT(toString(none.error().advice), testing::HasSubstr(".glb"));
  }
  const test::TemporaryFolder folder;
  EXPECT_FALSE(writePath({}, {}, {}, folder / "path.unknown").ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "path.unknown"));
}

}  // namespace
}  // namespace glissade
