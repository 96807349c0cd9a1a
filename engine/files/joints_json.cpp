#include "engine/files/joints_json.h"

#include <cmath>

#include "engine/base/enum_names.h"
#include "engine/base/limits.h"
#include "engine/geometry/pose_json.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr EnumNames<JointEdit::Word, 4> kWordNames{{"confirmed", "dissolved", "pressed_out", "opened"}};

std::vector<std::string> readIds(const std::optional<JsonCursor>& at) {
  std::vector<std::string> ids;
  if (!at) return ids;
  for (std::size_t i = 0; i < at->sizeUpTo(limits::kMostBodies); ++i) ids.push_back(at->element(i).nonEmptyText());
  return ids;
}

double readPitchOf(const JsonCursor& at) {
  const double pitch = at.number();
  constexpr double kLeast = 1e-5;
  constexpr double kMost = 1.0;
  if (std::abs(pitch) >= kLeast && std::abs(pitch) <= kMost) return pitch;
  at.fail(GLISSADE_TEXT("is not a pitch"),
          GLISSADE_TEXT("Give metres a turn, from 0.00001 to 1; below zero for a left-handed thread."));
}

double readNotNegative(const JsonCursor& at) {
  const double value = at.coordinate();
  if (value < 0.0) at.fail(GLISSADE_TEXT("is below zero"), GLISSADE_TEXT("Give metres, 0 or more."));
  return value;
}

JointThread readThread(const JsonCursor& at) {
  at.allowOnly({"diameter_m", "pitch_m", "engaged_m", "travel_m"});
  JointThread thread;
  thread.diameter = at.at("diameter_m").length();
  thread.pitch = readPitchOf(at.at("pitch_m"));
  thread.isPitchStated = true;
  thread.engaged = at.at("engaged_m").length();
  if (const auto travel = at.find("travel_m")) thread.travel = readNotNegative(*travel);
  return thread;
}

Vector3 readDirection(const JsonCursor& at) {
  const Vector3 direction = readVector(at);
  const double length = direction.norm();
  if (!(length > 1e-9)) at.fail(GLISSADE_TEXT("has no length"), GLISSADE_TEXT("Give a direction, as [0, 0, 1]."));
  // A direction of unit length within rounding is kept, so that files are read and written without a change.
  return std::abs(length - 1.0) < 1e-12 ? direction : Vector3(direction / length);
}

Joint readMade(const JsonCursor& at, JointKind kind, std::vector<std::string>* clamped) {
  at.allowOnly({"clamped", "point", "direction", "thread", "drive", "drive_size_m", "bend_m", "designation"});
  Joint joint;
  joint.kind = kind;
  joint.state = JointState::Confirmed;
  *clamped = readIds(at.find("clamped"));
  if (const auto point = at.find("point")) joint.point = readVector(*point);
  if (const auto direction = at.find("direction")) joint.direction = readDirection(*direction);
  if (const auto thread = at.find("thread")) joint.thread = readThread(*thread);
  if (const auto drive = at.find("drive")) joint.drive = drive->named(kDriveNames);
  if (const auto size = at.find("drive_size_m")) joint.driveSize = readNotNegative(*size);
  if (const auto bend = at.find("bend_m")) joint.bend = readNotNegative(*bend);
  if (const auto said = at.find("designation")) joint.designation = said->nonEmptyText();
  return joint;
}

JointEdit readJointEdit(const JsonCursor& at) {
  at.allowOnly({"kind", "body", "others", "word", "made"});
  JointEdit edit;
  edit.key.kind = at.at("kind").named(kJointKindNames);
  edit.key.body = at.at("body").nonEmptyText();
  edit.key.others = readIds(at.find("others"));
  edit.word = at.at("word").named(kWordNames);
  if (const auto made = at.find("made")) {
    if (edit.word != JointEdit::Word::Confirmed) {
      made->fail(GLISSADE_TEXT("has no effect, because the joint is not confirmed"),
                 GLISSADE_TEXT("Remove it, or say \"confirmed\"."));
    }
    edit.made = readMade(*made, edit.key.kind, &edit.clamped);
  }
  return edit;
}

Json threadJson(const JointThread& thread) {
  Json json{{"diameter_m", thread.diameter}, {"pitch_m", thread.pitch}, {"engaged_m", thread.engaged}};
  if (thread.travel > 0.0) json["travel_m"] = thread.travel;
  return json;
}

void addDrive(const Joint& joint, Json& json) {
  if (joint.drive != DriveKind::None) json["drive"] = kDriveNames.of(joint.drive);
  if (joint.driveSize > 0.0) json["drive_size_m"] = joint.driveSize;
}

Json toJson(const JointEdit& edit) {
  Json json{{"kind", kJointKindNames.of(edit.key.kind)}, {"body", edit.key.body}};
  if (!edit.key.others.empty()) json["others"] = edit.key.others;
  json["word"] = kWordNames.of(edit.word);
  if (!edit.made) return json;
  const Joint& made = *edit.made;
  Json& section = json["made"] = Json::object();
  if (!edit.clamped.empty()) section["clamped"] = edit.clamped;
  section["point"] = glissade::toJson(made.point);
  section["direction"] = glissade::toJson(made.direction);
  if (made.thread) section["thread"] = threadJson(*made.thread);
  addDrive(made, section);
  if (made.bend > 0.0) section["bend_m"] = made.bend;
  if (!made.designation.empty()) section["designation"] = made.designation;
  return json;
}

Json idsJson(const std::vector<std::size_t>& bodies, const AssembledProduct& product) {
  Json ids = Json::array();
  for (const std::size_t body : bodies) ids.push_back(product.bodies[body].id);
  return ids;
}

}  // namespace

std::vector<JointEdit> readJointEdits(const JsonCursor& at) {
  std::vector<JointEdit> edits;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) {
    JointEdit edit = readJointEdit(at.element(i));
    for (const JointEdit& earlier : edits) {
      if (earlier.key == edit.key)
        at.element(i).fail(GLISSADE_TEXT("is about a joint that was there before"), GLISSADE_TEXT("Remove one."));
    }
    edits.push_back(std::move(edit));
  }
  return edits;
}

void addJointEdits(const std::vector<JointEdit>& edits, Json& json) {
  if (edits.empty()) return;
  Json section = Json::array();
  for (const JointEdit& edit : edits) section.push_back(toJson(edit));
  json["joints"] = std::move(section);
}

Json toJson(const Joint& joint, const AssembledProduct& product) {
  Json json{{"kind", kJointKindNames.of(joint.kind)},     {"state", kJointStateNames.of(joint.state)},
            {"body", product.bodies[joint.body].id},      {"others", idsJson(joint.others, product)},
            {"clamped", idsJson(joint.clamped, product)}, {"point", toJson(joint.point)},
            {"direction", toJson(joint.direction)}};
  if (joint.thread) {
    json["thread"] = threadJson(*joint.thread);
    json["thread"]["pitch_stated"] = joint.thread->isPitchStated;
    json["thread"]["turns"] = joint.thread->turns();
  }
  addDrive(joint, json);
  if (joint.bend > 0.0) json["bend_m"] = joint.bend;
  if (!joint.designation.empty()) json["designation"] = joint.designation;
  json["doubtful"] = joint.isDoubtful;
  if (joint.makesHole) json["makes_hole"] = true;
  json["evidence"] = Json::array();
  for (const Message& each : joint.evidence) json["evidence"].push_back(toString(each));
  return json;
}

}  // namespace glissade
