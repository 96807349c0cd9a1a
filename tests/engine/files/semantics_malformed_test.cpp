#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/files/scenario_io.h"
#include "tests/engine/files/broken_semantics.h"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(MalformedSemantics, EachFaultIsOneErrorWithFileAndPlace) {
  for (const test::BrokenScenario& row : test::brokenSemantics()) {
    SCOPED_TRACE(row.patch);
    const Result<Scenario> read = parseScenario(test::broken(row), "broken.json");
    EXPECT_FALSE(read.ok());
    if (read.ok()) continue;
    EXPECT_EQ(read.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(read.error().file, "broken.json");
    EXPECT_THAT(toString(read.error().location), StartsWith(row.place));
    EXPECT_THAT(toString(read.error().reason), HasSubstr(row.reason));
    EXPECT_FALSE(read.error().advice.empty());
  }
}

}  // namespace
}  // namespace glissade
