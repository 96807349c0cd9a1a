#include "engine/files/joints_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glissade {
namespace {

using Json = JsonCursor::Json;

Result<std::vector<JointEdit>> readEdits(const std::string& text) {
  return readJson(text, "s.json", [](const JsonCursor& at) { return JointEditsFormat().read(at.at("joints")); });
}

std::vector<JointEdit> someEdits() {
  Joint made;
  made.kind = JointKind::Screw;
  made.state = JointState::Confirmed;
  made.point = {1.0 / 3.0, 0.0, -2.0};
  made.direction = {0.6, 0.8, 0.0};
  made.thread = JointThread{0.003, -0.0005, true, 0.004, 0.005};
  made.drive = DriveKind::SixLobe;
  made.driveSize = 0.0039;
  made.designation = "ISO 14583 M3x8";
  Joint snap;
  snap.kind = JointKind::Snap;
  snap.state = JointState::Confirmed;
  snap.bend = 0.0006;
  return {{{JointKind::Screw, "s", {"nut", "plate"}}, JointEdit::Word::Confirmed, made, {"washer"}},
          {{JointKind::Snap, "clip", {"case"}}, JointEdit::Word::Confirmed, snap},
          {{JointKind::Unit, "m", {"n"}}, JointEdit::Word::Opened},
          {{JointKind::Insert, "i", {"case"}}, JointEdit::Word::PressedOut},
          {{JointKind::Flexible, "belt", {}}, JointEdit::Word::Confirmed},
          {{JointKind::Pin, "p", {"q"}}, JointEdit::Word::Dissolved}};
}

TEST(JointsJson, WhatIsWrittenIsReadAndWrittenAgain) {
  const Json json{{"joints", JointEditsFormat().write(someEdits())}};
  const std::string text = json.dump();
  const auto read = readEdits(text);
  ASSERT_TRUE(read) << toString(read.error());
  EXPECT_EQ(*read, someEdits());
  const Json again{{"joints", JointEditsFormat().write(*read)}};
  EXPECT_EQ(again.dump(), text);
}

TEST(JointsJson, EachFaultIsNamedWithItsPlace) {
  const Json sound{{"joints", JointEditsFormat().write(someEdits())}};
  struct Fault {
    const char* patch;
    const char* place;
    const char* reason;
  };
  const std::vector<Fault> faults{
      {R"([{"op": "replace", "path": "/joints/0/kind", "value": "rivet"}])", "/joints/0/kind", "is not one of: screw"},
      {R"([{"op": "replace", "path": "/joints/0/word", "value": "loose"}])", "/joints/0/word",
       "is not one of: confirmed"},
      {R"([{"op": "remove", "path": "/joints/0/body"}])", "/joints/0/body", "missing"},
      {R"([{"op": "add", "path": "/joints/0/made/x", "value": 1}])", "/joints/0/made/x", "unknown key"},
      {R"([{"op": "replace", "path": "/joints/1/made/bend_m", "value": -1}])", "/joints/1/made/bend_m", "below zero"},
      {R"([{"op": "replace", "path": "/joints/0/made/drive", "value": "torx"}])", "/joints/0/made/drive",
       "is not one of: none"},
      {R"([{"op": "replace", "path": "/joints/0/made/direction", "value": [0, 0, 0]}])", "/joints/0/made/direction",
       "no length"},
      {R"([{"op": "replace", "path": "/joints/0/made/thread/pitch_m", "value": 0}])", "/joints/0/made/thread/pitch_m",
       "not a pitch"},
      {R"([{"op": "add", "path": "/joints/2/made", "value": {}}])", "/joints/2/made", "no effect"},
      {R"([{"op": "copy", "from": "/joints/2", "path": "/joints/3"}])", "/joints/3", "was there before"}};
  for (const Fault& fault : faults) {
    const auto read = readEdits(sound.patch(Json::parse(fault.patch)).dump());
    ASSERT_FALSE(read) << fault.patch;
    EXPECT_EQ(toString(read.error().location), fault.place);
    EXPECT_THAT(toString(read.error().reason), testing::HasSubstr(fault.reason));
  }
}

}  // namespace
}  // namespace glissade
