#include "engine/scenario/path_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

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
      {"glTF\2", ""},
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
