#include <gtest/gtest.h>

#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

TEST(SemanticsFile, KeepsEveryValue) {
  const Scenario written = test::fullScenario();
  const Result<Scenario> read = parseScenario(writeScenario(written), "test.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->environment, written.environment);
  EXPECT_EQ(read->attributeDefinitions, written.attributeDefinitions);
  EXPECT_EQ(read->places, written.places);
  EXPECT_EQ(read->milestones, written.milestones);
  EXPECT_EQ(read->rules, written.rules);
  EXPECT_EQ(read->object.first().attributes, written.object.first().attributes);
}

TEST(SemanticsFile, SaysNothingWhereNothingWasSaid) {
  const std::string text = writeScenario(test::boxScenario());
  for (const char* key : {"environment", "attributes", "places", "milestones", "rules"}) {
    EXPECT_EQ(text.find("\"" + std::string(key) + "\""), std::string::npos) << key;
  }
}

TEST(SemanticsFile, EditsGoIntoAScenarioAndComeOutTheSame) {
  const SemanticEdits edits = semanticEditsOf(test::fullScenario());
  EXPECT_EQ(edits.bodies.size(), 4U);  // the mesh, the two bodies of the object, and an assembly
  Scenario plain = test::fullScenario();
  setSemanticEdits({}, plain);
  EXPECT_EQ(semanticEditsOf(plain), SemanticEdits{});
  setSemanticEdits(edits, plain);
  EXPECT_EQ(semanticEditsOf(plain), edits);
}

TEST(SemanticsFile, TheSecondPapersSamplesAreCanonical) {
  for (const char* preset : {"paper-like", "tight"}) {
    for (const char* shape : {"circle", "square", "triangle", "pentagon", "star"}) {
      const std::string file = test::sourceDirectory() + "/samples/shape-game/" + preset + "-" + shape + ".json";
      const std::string text = test::readWhole(file);
      const Result<Scenario> read = parseScenario(text, file);
      ASSERT_TRUE(read.ok()) << toString(read.error());
      EXPECT_EQ(read->places.size(), 9U);
      EXPECT_EQ(writeScenario(*read), text) << file;
    }
  }
}

}  // namespace
}  // namespace glissade
