#include "engine/scenario/path_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/scenario/scenario_io.h"
#include "tests/engine/scenario/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

class PathFiles : public testing::Test {
 protected:
  void SetUp() override {
    Result<LoadedScenario> loaded = realiseScenario(test::boxScenario(), folder_.path(), "boxes.json");
    ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
    scenario_ = *loaded;
    path_.points = {{Pose::translation({-3, 0, 0}), Author::Computer},
                    {{{-1.0 / 3.0, 2.5, 0.1}, fromRollPitchYaw(0.1, -0.2, 3.0)}, Author::Contact},
                    {Pose::translation({-0.8, 0, 0}), Author::Operator}};
  }

  void expectReadsBack(const std::string& file, bool withAuthors) const {
    const Result<std::vector<PathPoint>> points = readPath(file);
    ASSERT_TRUE(points.ok()) << toString(points.error());
    ASSERT_EQ(points->size(), path_.points.size());
    for (std::size_t i = 0; i < points->size(); ++i) {
      EXPECT_EQ((*points)[i].q, path_.points[i].q) << i;  // bit by bit
      EXPECT_EQ((*points)[i].author, withAuthors ? path_.points[i].author : Author::Computer) << i;
    }
  }

  TemporaryFolder folder_;
  LoadedScenario scenario_;
  Path path_;
};

TEST_F(PathFiles, CsvRoundTrips) {
  const std::string file = folder_ / "path.csv";
  ASSERT_TRUE(writePathCsv(path_, scenario_, file).ok());
  expectReadsBack(file, true);
  const std::string text = test::readWhole(file);
  EXPECT_THAT(text, testing::StartsWith(
                        "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author\n0,0,-3,0,0,0,0,0,1,2.25,0,computer\n"));
  EXPECT_THAT(text, testing::HasSubstr(",1,contact\n"));
}

TEST_F(PathFiles, OmplAndJsonRoundTrip) {
  ASSERT_TRUE(writePathOmpl(path_, folder_ / "ompl.path").ok());
  expectReadsBack(folder_ / "ompl.path", false);
  ASSERT_TRUE(writePathJson(path_, scenario_, {"birrt", 7}, folder_ / "path.json").ok());
  expectReadsBack(folder_ / "path.json", true);
  EXPECT_THAT(test::readWhole(folder_ / "path.json"), testing::HasSubstr("\"seed\": 7"));
}

TEST(ReadPath, NamesTheLineOfAFault) {
  const TemporaryFolder folder;
  const std::string good = "0 0 0 0 0 0 1\n";
  const std::string header = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author\n";
  const std::vector<std::tuple<std::string, std::string>> table{
      {good + "1 2 3\n", "line 2"},
      {good + "0 0 0 0 0 0 nan\n", "line 2"},
      {good + "\n0 0 0 0 0 0 2\n", "line 3"},
      {good + "0,5 0 0 0 0 0 1\n", "line 2"},
      {header + "0,0,0,0,0,0,0,0,1,1,0,nobody\n", "line 2"},
      {header + "0,0,0,0,0,0,0,0,1,1,0\n", "line 2"},
      {header, ""},
      {"{\"format\": \"glissade-path\", \"version\": 1, \"configurations\": [{\"author\": \"contact\"}]}",
       "/configurations/0"},
      {"{\"format\": \"glissade-scenario\"}", "/format"},
      {"{", "line 1"},
      {"", ""},
  };
  for (const auto& [text, place] : table) {
    SCOPED_TRACE(text);
    const std::string file = folder.write("path", text);
    const Result<std::vector<PathPoint>> points = readPath(file);
    ASSERT_FALSE(points.ok());
    EXPECT_EQ(points.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(points.error().file, file);
    EXPECT_THAT(points.error().place, testing::StartsWith(place));
  }
  EXPECT_TRUE(readPath(folder.write("crlf", "0 0 0 0 0 0 1\r\n  1\t0 0 0 0 0 1 \r\n")).ok());
}

TEST(IsPathFile, GoesByTheEndingAndOfJsonByTheFormat) {
  const TemporaryFolder folder;
  EXPECT_TRUE(isPathFile("a.csv"));
  EXPECT_TRUE(isPathFile("a.path"));
  EXPECT_FALSE(isPathFile("a.stl"));
  EXPECT_FALSE(isPathFile(folder / "gone.json"));
  EXPECT_TRUE(isPathFile(folder.write("path.json", "{\"format\": \"glissade-path\"}")));
  EXPECT_FALSE(isPathFile(folder.write("scenario.json", "{\"format\": \"glissade-scenario\"}")));
  EXPECT_FALSE(isPathFile(folder.write("list.json", "[1]")));
  EXPECT_FALSE(isPathFile(folder.write("broken.json", "{")));
}

}  // namespace
}  // namespace glissade
