#include "engine/places/body_labels.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

RigidBody labelled(const std::string& id, const std::string& label) {
  RigidBody body;
  body.id = BodyId(id);
  body.name = id;
  body.label = label;
  return body;
}

TEST(BodyLabels, WarningsNameBodiesAsTablesDo) {
  const std::vector<RigidBody> bodies{labelled("pump/rotor", "Rotor A"), labelled("unit/pump/rotor#2", "Rotor B")};
  Warnings warnings;
  const Message part(GLISSADE_TEXT("'%1'"), {"pump/rotor"});
  warnings.push_back({ErrorKind::MalformedInput, "a.step", {GLISSADE_TEXT("%1 of %2"), {"#12", part}}, {}, {}});
  warnings.push_back({ErrorKind::MalformedInput, "a.step", {GLISSADE_TEXT("'%1'"), {"pump/rotor#2"}}, {}, {}});
  warnings.push_back({ErrorKind::MalformedInput, "a.step", {GLISSADE_TEXT("'%1'"), {"rotor"}}, {}, {}});
  nameByLabels(warnings, bodies);
  EXPECT_EQ(toString(warnings[0].location), "#12 of 'Rotor A'");
  EXPECT_EQ(toString(warnings[1].location), "'Rotor B'") << "as the importer names it, within its file";
  EXPECT_EQ(toString(warnings[2].location), "'Rotor A'");
}

}  // namespace
}  // namespace glissade
