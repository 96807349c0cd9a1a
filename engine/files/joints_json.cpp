#include "engine/files/joints_json.h"

#include <cmath>

#include "engine/base/enum_names.h"
#include "engine/geometry/pose_json.h"
#include "engine/model/body_id_json.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr EnumNames<JointEdit::Word, 4> kWordNames{{"confirmed", "dissolved", "pressed_out", "opened"}};

/// The member "made" of a statement: the joint, and the ids of what it clamps.
struct MadeJoint : Joint {
  std::vector<BodyId> ids{};
};

Json idsJson(const std::vector<std::size_t>& bodies, const AssembledProduct& product) {
  Json ids = Json::array();
  for (const std::size_t body : bodies) ids.push_back(product.bodies[body].id);
  return ids;
}

std::optional<MadeJoint> madeOf(const JointEdit& edit) {
  if (!edit.made) return std::nullopt;
  return MadeJoint{*edit.made, edit.clamped};
}

void setMade(JointEdit& edit, MadeJoint made) {
  edit.clamped = std::move(made.ids);
  edit.made = std::move(static_cast<Joint&>(made));
  edit.made->kind = edit.key.kind;
  edit.made->state = JointState::Confirmed;
}

}  // namespace

template <class Archive>
void describe(Archive& thread, Type<JointThread> /*type*/) {
  thread.type("joint_thread");
  thread.required("diameter_m", &JointThread::diameter, kLength, "Metres, outer diameter.");
  thread.required("pitch_m", &JointThread::pitch, kPitch, "Metres a turn; below 0: left-handed.");
  thread.required("engaged_m", &JointThread::engaged, kLength, "Metres of the thread inside the other body.");
  thread.optional("travel_m", &JointThread::travel, kLengthOrZero,
                  "Metres along the axis until the thread is free. Absent: as engaged.");
  thread.check([](JointThread& read, const JsonCursor& /*at*/) { read.isPitchStated = true; });
}

template <class Archive>
void describe(Archive& made, Type<MadeJoint> /*type*/) {
  made.type("made_joint", "Only with the word confirmed: a joint that a person has made or changed.");
  made.optional("clamped", &MadeJoint::ids, listOf(kBodyId),
                "Ids of what a screw or a nut clamps, the nearest to the head first.");
  made.optional("point", &Joint::point, kVector, "On the axis, world frame.", Always());
  made.optional("direction", &Joint::direction, DirectionFormat(), "Direction in which the body leaves, world frame.",
                Always());
  made.optional("thread", &Joint::thread, kObject<JointThread>);
  made.optional("drive", &Joint::drive, named(kDriveNames));
  made.optional("drive_size_m", &Joint::driveSize, kLengthOrZero, "Metres across the flats, or the width.");
  made.optional("bend_m", &Joint::bend, kLengthOrZero, "Metres that the hook of a snap bends.");
  made.optional("designation", &Joint::designation, kNonEmptyText, "The designation in a name: ISO 4762 M3x8.");
}

template <class Archive>
void describe(Archive& key, Type<JointKey> /*type*/) {
  key.type("joint_key");
  key.required("kind", &JointKey::kind, named(kJointKindNames));
  key.required("body", &JointKey::body, kBodyId,
               "Id of the screw, the nut, one of two bodies that are screwed together, the guest of an insert, the "
               "pin, the body with the hook, the flexible body, or the first body of a unit or a permanent joint.");
  key.optional("others", &JointKey::others, listOf(kBodyId),
               "Ids of the bodies that it is in, on or around, or of the other bodies of a unit or a permanent joint.");
}

template <class Archive>
void describe(Archive& edit, Type<JointEdit> /*type*/) {
  edit.type("joint_edit", "A person's statement about a joint, beside the joints that shapes and names show.");
  edit.embed(&JointEdit::key);
  edit.required("word", &JointEdit::word, named(kWordNames),
                "confirmed: the joint exists, as found or as 'made' states; dissolved: it does not exist; "
                "pressed_out: an insert is pressed out along its axis; opened: a unit is taken apart.");
  edit.optional("made", Accessor{madeOf, setMade}, kObject<MadeJoint>);
  edit.check([](const JointEdit& read, const JsonCursor& at) {
    if (!read.made || read.word == JointEdit::Word::Confirmed) return;
    at.at("made").fail(GLISSADE_TEXT("has no effect, because the joint is not confirmed"),
                       GLISSADE_TEXT("Remove it, or say \"confirmed\"."));
  });
}

std::vector<JointEdit> JointEditsFormat::read(const JsonCursor& at) const {
  std::vector<JointEdit> edits = kObjects<JointEdit>.read(at);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    for (std::size_t earlier = 0; earlier < i; ++earlier) {
      if (edits[earlier].key == edits[i].key)
        at.element(i).fail(GLISSADE_TEXT("is about a joint that was there before"), GLISSADE_TEXT("Remove one."));
    }
  }
  return edits;
}

Json JointEditsFormat::write(const std::vector<JointEdit>& edits) const { return kObjects<JointEdit>.write(edits); }

Json JointEditsFormat::schema(SchemaDefinitions& definitions) const { return kObjects<JointEdit>.schema(definitions); }

Json toJson(const Joint& joint, const AssembledProduct& product) {
  Json json{{"kind", kJointKindNames.of(joint.kind)},     {"state", kJointStateNames.of(joint.state)},
            {"body", product.bodies[joint.body].id},      {"others", idsJson(joint.others, product)},
            {"clamped", idsJson(joint.clamped, product)}, {"point", toJson(joint.point)},
            {"direction", toJson(joint.direction)}};
  if (joint.thread) {
    json["thread"] = kObject<JointThread>.write(*joint.thread);
    json["thread"]["pitch_stated"] = joint.thread->isPitchStated;
    json["thread"]["turns"] = joint.thread->turns();
  }
  if (joint.drive != DriveKind::None) json["drive"] = kDriveNames.of(joint.drive);
  if (joint.driveSize > 0.0) json["drive_size_m"] = joint.driveSize;
  if (joint.bend > 0.0) json["bend_m"] = joint.bend;
  if (!joint.designation.empty()) json["designation"] = joint.designation;
  json["doubtful"] = joint.isDoubtful;
  if (joint.makesHole) json["makes_hole"] = true;
  json["evidence"] = Json::array();
  for (const Message& each : joint.evidence) json["evidence"].push_back(toString(each));
  return json;
}

}  // namespace glissade
