#include "engine/places/semantic_model.h"

#include <gtest/gtest.h>

#include "tests/engine/support/environment_worlds.h"

namespace glissade {
namespace {

using test::kFarAway;
using test::kHole;
using test::kInTheWall;
using test::kLeft;

EnvironmentModelPtr rooms(const char* identifier = "region-growing") {
  return test::environmentOf(test::wallWithAHole(), test::twoRooms(), {1.0 / 32, 16, 6, identifier});
}

struct Model {
  explicit Model(const SemanticEdits& edits, const char* identifier = "region-growing",
                 const std::vector<double>& compatibility = {})
      : environment(rooms(identifier)), semantic(environment, test::wallWithAHole(), "me", edits, compatibility) {}

  ProvenValue at(const Vector3& p_W, const char* attribute) const {
    return semantic.ofPlace(static_cast<std::size_t>(environment->map.placeAt(p_W)), attribute);
  }
  const std::string& nameAt(const Vector3& p_W) const {
    return semantic.placeName(static_cast<std::size_t>(environment->map.placeAt(p_W)));
  }

  EnvironmentModelPtr environment;
  SemanticModel semantic;
};

void expectValue(const ProvenValue& actual, const AttributeValue& value, Provenance provenance) {
  EXPECT_EQ(actual.value, value);
  EXPECT_EQ(actual.provenance, provenance);
}

TEST(SemanticModel, KnowsWhereValuesComeFrom) {
  SemanticEdits edits;
  edits.places = {{kHole, "Door", {{"complexity", 7.0}, {"forbidden", true}}}};
  edits.bodies["left"] = {{"shape", std::string("slab")}};
  const Model model(edits);
  expectValue(model.at(kHole, "complexity"), 7.0, Provenance::Edited);
  expectValue(model.at(kHole, "forbidden"), true, Provenance::Edited);
  expectValue(model.at(kHole, "cluttered"), false, Provenance::Computed);
  expectValue(model.at(kHole, "preference"), 1.0, Provenance::Initial);
  expectValue(model.at(kLeft, "complexity"), 1.0, Provenance::Computed);
  expectValue(model.at(kLeft, "forbidden"), false, Provenance::Initial);
  expectValue(model.semantic.ofBody("left", "shape"), std::string("slab"), Provenance::Edited);
  expectValue(model.semantic.ofBody("left", "mobility"), std::string("static"), Provenance::Computed);
  expectValue(model.semantic.ofObject("mobility"), std::string("mobile"), Provenance::Computed);
  expectValue(model.semantic.ofObject("shape"), std::string(), Provenance::Initial);
  EXPECT_EQ(model.nameAt(kHole), "Door");
}

TEST(SemanticModel, WithoutTheEditTheComputedValueIsBack) {
  SemanticEdits edits;
  edits.places = {{kHole, "", {{"complexity", 7.0}}}};
  const Model edited(edits);
  edits.places[0].attributes.clear();
  const Model reset(edits);
  expectValue(edited.at(kHole, "complexity"), 7.0, Provenance::Edited);
  const Place& hole = reset.environment->map.places.back();
  ASSERT_TRUE(hole.passage);
  expectValue(reset.at(kHole, "complexity"), static_cast<double>(hole.complexity), Provenance::Computed);
}

TEST(SemanticModel, EditsAreBoundToAPointAndSurviveAnotherIdentifier) {
  SemanticEdits edits;
  edits.places = {{kHole, "Door", {{"shape", std::string("square")}}}, {kLeft, "Hall", {}}};
  for (const char* identifier : {"region-growing", "watershed"}) {
    const Model model(edits, identifier);
    EXPECT_EQ(model.nameAt(kHole), "Door");
    EXPECT_EQ(model.nameAt(kLeft), "Hall");
    expectValue(model.at(kHole, "shape"), std::string("square"), Provenance::Edited);
  }
}

TEST(SemanticModel, AnEditWhereABodyCameToStandCountsForTheNearestPlace) {
  SemanticEdits edits;
  edits.places = {{kInTheWall, "Hall", {{"forbidden", true}}}};
  const Model model(edits);
  EXPECT_EQ(model.nameAt(kLeft), "Hall");
  expectValue(model.at(kLeft, "forbidden"), true, Provenance::Edited);
}

TEST(SemanticModel, AnEditFarFromAnyPlaceCountsForNone) {
  SemanticEdits edits;
  edits.places = {{kLeft, "Hall", {}}, {kFarAway, "Nowhere", {{"forbidden", true}}}};
  const Model model(edits);
  EXPECT_EQ(model.nameAt(kLeft), "Hall");
  for (std::size_t place = 0; place < model.semantic.placeCount(); ++place) {
    EXPECT_NE(model.semantic.placeName(place), "Nowhere");
    expectValue(model.semantic.ofPlace(place, "forbidden"), false, Provenance::Initial);
  }
}

TEST(SemanticModel, CompatibilityIsComputedUnlessEdited) {
  SemanticEdits edits;
  edits.places = {{kLeft, "", {{"compatibility", 0.25}}}};
  const Model model(edits, "region-growing", {0.75, 0.75, 0.75});
  expectValue(model.at(kHole, "compatibility"), 0.75, Provenance::Computed);
  expectValue(model.at(kLeft, "compatibility"), 0.25, Provenance::Edited);
  expectValue(Model(SemanticEdits{}).at(kHole, "compatibility"), 1.0, Provenance::Initial);
}

TEST(SemanticModel, ALinkHasWhatItsBodyHasUnlessItSaysOtherwise) {
  SemanticEdits edits;
  edits.bodies["robot"] = {{"shape", std::string("arm")}};
  edits.bodies["robot/hand"] = {{"shape", std::string("hand")}};
  const Model model(edits);
  expectValue(model.semantic.ofBody("robot/elbow", "shape"), std::string("arm"), Provenance::Edited);
  expectValue(model.semantic.ofBody("robot/hand", "shape"), std::string("hand"), Provenance::Edited);
}

TEST(SemanticModel, TheUsersOwnAttributesStartAtTheirInitialValue) {
  SemanticEdits edits;
  AttributeDefinition level;
  level.name = "level";
  level.type = AttributeType::Integer;
  level.initial = 4.0;
  edits.definitions = {level};
  edits.places = {{kHole, "", {{"level", 2.0}}}};
  const Model model(edits);
  expectValue(model.at(kLeft, "level"), 4.0, Provenance::Initial);
  expectValue(model.at(kHole, "level"), 2.0, Provenance::Edited);
}

TEST(CheckEdits, AcceptsWhatIsSound) {
  SemanticEdits edits;
  edits.places = {{kHole, "Door", {{"compatibility", 1.0}, {"forbidden", true}}}};
  edits.bodies["me"] = {{"shape", std::string("star")}};
  EXPECT_TRUE(checkEdits(edits, {"me", "wall"}).ok());
}

TEST(CheckEdits, RefusesEachFaultAtItsPlace) {
  AttributeDefinition taken;
  taken.name = "shape";
  taken.initial = std::string();
  struct Row {
    SemanticEdits edits;
    const char* place;
  };
  const PlaceEdit sound{kHole, "", {}};
  const std::vector<Row> rows{
      {{{taken}, {}, {}, {}}, "/attributes"},
      {{{}, {sound, {kHole, "", {{"forbidden", 1.0}}}}, {}, {}}, "/places/1/attributes/forbidden"},
      {{{}, {{kHole, "", {{"colour", 1.0}}}}, {}, {}}, "/places/0/attributes/colour"},
      {{{}, {{kHole, "", {{"mobility", std::string("static")}}}}, {}, {}}, "/places/0/attributes/mobility"},
      {{{}, {{kHole, "", {{"compatibility", 2.0}}}}, {}, {}}, "/places/0/attributes/compatibility"},
      {{{}, {}, {{"ghost", {{"shape", std::string("x")}}}}, {}}, "/bodies/ghost"},
      {{{}, {}, {{"wall", {{"forbidden", true}}}}, {}}, "/bodies/wall/attributes/forbidden"},
      {{{}, {}, {{"wall", {{"mobility", std::string("slow")}}}}, {}}, "/bodies/wall/attributes/mobility"},
  };
  for (const Row& row : rows) {
    const Outcome checked = checkEdits(row.edits, {"me", "wall"});
    ASSERT_FALSE(checked.ok()) << row.place;
    EXPECT_EQ(checked.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(toString(checked.error().location), row.place);
    EXPECT_FALSE(checked.error().reason.empty());
    EXPECT_FALSE(checked.error().advice.empty());
  }
}

}  // namespace
}  // namespace glissade
