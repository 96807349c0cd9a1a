#include "engine/files/path_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/utf8.h"
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
      {"{\"format\": \"glissade-path\", \"version\": 1, \"configurations\": [{\"position\": [0, 0, 0], "
       "\"orientation\": [0, 0, 0, 1], \"author\": \"contact\"}], \"checksum\": \"sha256:00\"}",
       "/checksum"},
      {"{\"format\": \"glissade-scenario\"}", "/format"},
      {"{", "line 1"},
      {good + "1e9 0 0 0 0 0 1\n1.1e9 0 0 0 0 0 1\n", "line 3"},
      {good + "0 -1e19 0 0 0 0 1\n", "line 2"},
      {good + "0 0 \xff\xfe\x1b[31m 0 0 0 1\n", "line 2"},
      {good + "0 0 \xC3( 0 0 0 1\n", "line 2"},
      {header + "0,0,0,0,0,0,0,0,1,1,0,\x1b]0;x\x07\n", "line 2"},
      {good + std::string(1'000'000, ' ') + "\n", "line 2"},
      {"{\"format\": \"glissade-path\", \"version\": 1, \"configurations\": [{\"position\": [0, 1e12, 0], "
       "\"orientation\": [0, 0, 0, 1], \"author\": \"contact\"}]}",
       "/configurations/0/position/1"},
      {std::string(200'000, '['), "line 1"},
      {"glTF\2", ""},
      {"", ""},
  };
  for (const auto& [text, place] : table) {
    SCOPED_TRACE(text.substr(0, 200));
    const std::string file = folder.write("path", text);
    const Result<std::vector<PathPoint>> points = readPath(file);
    ASSERT_FALSE(points.ok());
    EXPECT_EQ(points.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(points.error().file, file);
    EXPECT_THAT(toString(points.error().location), testing::StartsWith(place));
    EXPECT_TRUE(isUtf8(toString(points.error().reason)));
    EXPECT_EQ(toString(points.error().reason).find('\x1b'), std::string::npos);
    EXPECT_LT(toString(points.error().reason).size(), 200U);
    EXPECT_EQ(points.error().location.empty(), place.empty());
    EXPECT_FALSE(points.error().reason.empty());
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
