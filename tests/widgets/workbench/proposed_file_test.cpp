#include "widgets/workbench/proposed_file.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(ProposedFile, IsNamedAsTheProductAndNeverAsAPart) {
  LoadedScenario loaded;
  loaded.scenario.object.first().name = loaded.scenario.name = "nut";
  loaded.file = "/somewhere/as1.json";
  EXPECT_EQ(proposedFile(loaded, QStringLiteral("path.mp4")), QStringLiteral("as1-path.mp4"));
  EXPECT_EQ(proposedFile(loaded, QStringLiteral(".json")), QStringLiteral("as1.json"));
  loaded.scenario.name = "up/down";
  EXPECT_EQ(proposedFile(loaded, QStringLiteral(".json")), QStringLiteral("up-down.json"));
  loaded.scenario.name.clear();
  loaded.file.clear();
  EXPECT_EQ(proposedFile(loaded, QStringLiteral("path.mp4")), QStringLiteral("path.mp4"));
  EXPECT_EQ(proposedFile(loaded, QStringLiteral(".json")), QStringLiteral("scenario.json"));
}

}  // namespace
}  // namespace glissade
