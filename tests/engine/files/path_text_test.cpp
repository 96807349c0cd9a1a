#include "engine/files/path_text.h"

#include <gmock/gmock.h>

#include "engine/files/path_reader.h"
#include "tests/engine/files/path_fixture.h"

namespace glissade {
namespace {

class PathText : public test::PathFixture {
 protected:
  void expectAuthors(const std::string& text, bool kept) const {
    const Result<std::vector<PathPoint>> points = readPath(folder_.write("path", text));
    ASSERT_TRUE(points.ok()) << toString(points.error());
    for (std::size_t i = 0; i < points->size(); ++i) {
      EXPECT_EQ((*points)[i].author, kept ? path_.points[i].author : Author::Computer) << i;
    }
  }
};

TEST_F(PathText, CsvTellsLengthClearanceAndContact) {
  const std::string text = *pathAsCsv(path_, scenario_, provenance_);
  EXPECT_THAT(text, testing::StartsWith(
                        "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author\n0,0,-3,0,0,0,0,0,1,2.25,0,computer\n"));
  EXPECT_THAT(text, testing::HasSubstr(",1,contact\n"));
  expectAuthors(text, true);
}

TEST_F(PathText, OmplIsSevenColumns) {
  const std::string text = *pathAsOmpl(path_, scenario_, provenance_);
  EXPECT_THAT(text, testing::StartsWith("-3 0 0 0 0 0 1\n-0.3333333333333333 3.5 0.1 "));
  expectAuthors(text, false);
}

TEST_F(PathText, JsonHasProvenanceAndCertificate) {
  const std::string text = *pathAsJson(path_, scenario_, provenance_);
  for (const char* part : {"\"scenario\": \"Boxes\"", "\"planner\": \"birrt\"", "\"seed\": 7",
                           "\"program\": \"Glissade ", "\"status\": \"certified\"", "\"edges\": ["}) {
    EXPECT_THAT(text, testing::HasSubstr(part));
  }
  expectAuthors(text, true);
}

}  // namespace
}  // namespace glissade
