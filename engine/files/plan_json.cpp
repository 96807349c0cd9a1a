#include "engine/files/plan_json.h"

#include <glissade/version.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <variant>

#include "engine/base/message_json.h"
#include "engine/files/plan_file.h"
#include "engine/files/plan_upgrade.h"
#include "engine/files/sequence_json.h"
#include "engine/fits/contact_report.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"
#include "engine/model/body_id_json.h"
#include "engine/sequence/accepted_clashes.h"
#include "engine/sequence/subassembly_lines.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr std::uint64_t kMostEffort = 64;

constexpr EnumNames<ToolAccess, 3> kAccessNames{{"not_asked", "free", "blocked"}};
/// Status of a certificate. A flexible body leaves without a proof.
constexpr EnumNames<bool, 2> kStatusNames{{"not_certified", "certified"}};

constexpr auto kIds = listOf(kBodyId);

constexpr FunctionFormat kEffort{[](const JsonCursor& at) {
                                   const std::uint64_t effort = at.wholeNumber();
                                   if (effort >= kMostEffort) at.fail(GLISSADE_TEXT("is too large"));
                                   return static_cast<int>(effort);
                                 },
                                 kAsItIs, R"({"type": "integer", "minimum": 0, "maximum": 63})"};

/// Metres, or null: infinity.
constexpr FunctionFormat kClearance{[](const JsonCursor& at) {
                                      return at.json().is_null() ? std::numeric_limits<double>::infinity()
                                                                 : kLengthOrZero.read(at);
                                    },
                                    [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); },
                                    R"({"type": ["number", "null"], "minimum": 0})"};

/// Id of a body, or null: none.
constexpr const char* kAboutUp =
    "Upward direction of the work place, in the frame of the product: the base lies well so. Absent: [0, 0, 1].";

constexpr FunctionFormat kIdOrNull{
    [](const JsonCursor& at) { return at.json().is_null() ? BodyId() : kBodyId.read(at); },
    [](const BodyId& id) { return id.empty() ? Json(nullptr) : Json(id); },
    R"({"type": ["string", "null"], "minLength": 1})"};

/// A message as data; an empty message where the data is no message.
struct MessageFormat {
  Message read(const JsonCursor& at) const { return messageFrom(nlohmann::json(at.json())).value_or(Message()); }
  Json write(const Message& message) const { return glissade::toJson(message); }
  Json schema(SchemaDefinitions& definitions) const {
    return definitions.reference("message", Json::parse(R"({
      "description": "An English text with its arguments, which replace %1 to %9.",
      "type": "object", "additionalProperties": false, "required": ["text"],
      "properties": {
        "text": {"type": "string"},
        "arguments": {"type": "array", "items": {"anyOf": [
          {"type": "string"},
          {"type": "object", "additionalProperties": false, "required": ["length"],
           "properties": {"length": {"description": "Metres.", "type": "number"}}},
          {"type": "object", "additionalProperties": false, "required": ["depth"],
           "properties": {"depth": {"description": "Depth of an overlap, metres.", "type": "number"}}},
          {"$ref": "#/definitions/message"}]}}}})"));
  }
};

/// Deepest nesting of a reason that is stored as data, because the JSON reader refuses files that nest deeper than 32.
constexpr int kDeepestReason = 4;

bool isNestedWithin(int levels, const Message& message) {
  return levels > 0 &&
         std::all_of(message.arguments.begin(), message.arguments.end(), [&](const MessageArgument& each) {
           const auto* nested = std::get_if<Message>(&each.value);
           return nested == nullptr || isNestedWithin(levels - 1, *nested);
         });
}

bool isStoredAsData(const StuckBody& stuck) {
  return !stuck.reason.empty() && isNestedWithin(kDeepestReason, stuck.reason);
}

/// The reason as data replaces the plain one, unless a person has edited the plain one.
constexpr Accessor kReasonAsData{[](const StuckBody& stuck) { return stuck.reason; },
                                 [](StuckBody& stuck, Message data) {
                                   if (toString(data) == toString(stuck.reason)) stuck.reason = std::move(data);
                                 }};

/// The certificate of a motion: its proof, and whether the motion is proved at all.
struct StepCertificate : StepProof {
  bool certified = true;
};

constexpr Accessor kCertificate{[](const StepMotion& motion) {
                                  return StepCertificate{motion.proof, motion.certified};
                                },
                                [](StepMotion& motion, const StepCertificate& read) {
                                  motion.proof = static_cast<const StepProof&>(read);
                                  motion.certified = read.certified;
                                }};

constexpr Accessor kBodies{[](const StepMotion& motion) { return motion.bodies(); },
                           [](StepMotion& motion, std::vector<BodyId> ids) {
                             if (ids.empty()) return;
                             motion.body = ids.front();
                             motion.with.assign(ids.begin() + 1, ids.end());
                           }};

/// Follows from the allowances of the motions.
constexpr Accessor kAcceptedClashes{[](const AssemblyPlan& plan) { return acceptedClashesOf(plan); },
                                    [](AssemblyPlan& /*plan*/, const std::vector<AcceptedClash>& /*read*/) {}};

bool isThreaded(const StepJoint& joint) { return joint.pitch != 0.0; }

void checkPitch(const Allowance& allowance, const JsonCursor& at) {
  if (allowance.pitch != 0.0) return;
  if (at.has("pitch_m")) at.at("pitch_m").fail(GLISSADE_TEXT("is not a pitch"));
  if (at.has("turns")) at.at("turns").fail(GLISSADE_TEXT("is without a pitch"));
}

}  // namespace

template <class Archive>
void describe(Archive& proof, Type<StepCertificate> /*type*/) {
  proof.type("certificate",
             "The motion keeps the required clearance from all bodies that are there after so many steps of the plan "
             "and the earlier motions of its step. Null: no body is there.");
  proof.required("status", &StepCertificate::certified, named(kStatusNames),
                 "not_certified: the motion of a flexible body is not proved.");
  proof.required("after_steps", &StepProof::afterSteps, kCount);
  proof.required("required_m", &StepProof::required, kLengthOrZero);
  proof.required("proved_clearance_m", &StepProof::provedClearance, kClearance);
  proof.required("min_clearance_m", &StepProof::minClearance, kClearance);
  proof.required("nearest", &StepProof::nearest, kIdOrNull);
  proof.check([](const StepCertificate& read, const JsonCursor& at) {
    if (read.certified && read.required <= 0.0) at.at("required_m").fail(GLISSADE_TEXT("is not above zero"));
  });
}

template <class Archive>
void describe(Archive& evidence, Type<evidence::Evidence> /*type*/) {
  using evidence::Evidence;
  evidence.type("evidence", "Evidence for the largest allowance of the pair, metres.");
  evidence.required("overlap_m", &Evidence::overlap, kLengthOrZero, "The overlap as measured.");
  evidence.required("deflection_m", &Evidence::deflection, kLengthOrZero, "The deflections of the files.");
  evidence.required("spacing_m", &Evidence::spacing, kLengthOrZero, "The coordinate spacing of the files.");
  evidence.required("margin_m", &Evidence::margin, kLengthOrZero, "The margin that remains.");
  evidence.optional("by_person_m", &Evidence::byPerson, kLengthOrZero, "The allowance of a person.");
}

template <class Archive>
void describe(Archive& thread, Type<evidence::StatedThread> /*type*/) {
  using evidence::StatedThread;
  thread.type("stated_thread", "A thread in the world frame, where the product is assembled. Metres.");
  thread.required("point_m", &StatedThread::point, kVector, "A point on the axis.");
  thread.required("direction", &StatedThread::direction, kVector);
  thread.required("pitch_m", &StatedThread::pitch, kCoordinate, "Metres a turn; below 0: left-handed.");
  thread.required("radius_moving_m", &StatedThread::radiusMoving, kLength);
  thread.required("radius_other_m", &StatedThread::radiusOther, kLength);
  thread.check([](const StatedThread& read, const JsonCursor& at) {
    if (!(read.direction.norm() > 0.0)) at.at("direction").fail(GLISSADE_TEXT("has no direction"));
  });
}

template <class Archive>
void describe(Archive& allowance, Type<Allowance> /*type*/) {
  allowance.type("allowance");
  allowance.required("body", &Allowance::body, kBodyId);
  allowance.required("kind", &Allowance::kind, named(kContactKindNames));
  allowance.required("overlap_m", &Allowance::overlap, kLengthOrZero);
  allowance.required("allowance_m", &Allowance::allowance, kLengthOrZero);
  allowance.required("text", &Allowance::text, kEnglish);
  allowance.optional("moving", &Allowance::moving, kBodyId,
                     "The body of the motion that has the fit. Absent: the first one.");
  allowance.optional("yields", &Allowance::yields, kBoolean, "The other body is taken thinner, not the moving one.");
  allowance.optional("hollow", &Allowance::hollow, kBoolean,
                     "The volume that the other body of the pair fills is taken away from the thinner one: a clash "
                     "that a person accepts. The allowance is the depth. The pair has a second allowance, by which the "
                     "other body is taken thinner all around.");
  allowance.optional("core", &Allowance::core, kObject<evidence::StatedThread>,
                     "The thread of the thinner body, which is taken away against the other one: the pair comes apart "
                     "by turning only.");
  allowance.optional("evidence", &Allowance::evidence, kObject<evidence::Evidence>, "",
                     [](const Allowance& written) { return written.evidence.sum() > 0.0; });
  allowance.optional("pitch_m", &Allowance::pitch, kCoordinate,
                     "Pitch of a thread, which the body leaves by turning only: metres a turn; below 0: left-handed.");
  allowance.optional("turns", &Allowance::turns, kLengthOrZero, "Full turns of the body in the thread.",
                     [](const Allowance& written) { return written.pitch != 0.0; });
  allowance.check(checkPitch);
}

template <class Archive>
void describe(Archive& tool, Type<StepTool> /*type*/) {
  tool.type(
      "tool",
      "The tool that turns the fastener, and whether it can be brought on when the motion begins. Absent: none is "
      "needed.");
  tool.required("kind", &StepTool::kind, named(kToolNames));
  tool.required("access", &StepTool::access, named(kAccessNames));
  tool.optional("blocked_by", &StepTool::blockedBy, kIds);
  tool.optional("turned", &StepTool::turned, kBodyId,
                "Id of the bolt that the tool turns while the nut is held. Absent: it turns the fastener.");
  tool.optional("held", &StepTool::held, kBodyId,
                "Id of the nut or bolt on the other side of the joint, which is held. Absent: none.");
  tool.optional("held_with", &StepTool::heldWith, named(kToolNames));
}

template <class Archive>
void describe(Archive& violation, Type<StepViolation> /*type*/) {
  violation.type("violation");
  violation.required("rule", &StepViolation::rule, named(kRuleNames),
                     "before: these bodies are demanded to leave before; fastener: these nuts are still on it; "
                     "standing: these bodies fall; place: no other body could leave before it, so it comes at another "
                     "place; joint: these bodies still hold it, as screws hold what they clamp.");
  violation.required("bodies", &StepViolation::bodies, kIds);
}

template <class Archive>
void describe(Archive& joint, Type<StepJoint> /*type*/) {
  joint.type("step_joint");
  joint.required("kind", &StepJoint::kind, named(kJointKindNames));
  joint.required("body", &StepJoint::body, kBodyId, "The screw, the nut, the pin, the flexible body.");
  joint.required("others", &StepJoint::others, kIds,
                 "The bodies that the thread is in or on, that a pin is in, that a flexible body goes around.");
  joint.optional("clamped", &StepJoint::clamped, kIds,
                 "The bodies between head and thread, the nearest to the head first.");
  joint.optional("designation", &StepJoint::designation, kText);
  joint.optional("drive", &StepJoint::drive, named(kDriveNames));
  joint.optional("drive_size_m", &StepJoint::driveSize, kLengthOrZero);
  joint.optional("bend_m", &StepJoint::bend, kLengthOrZero, "Bend of the hook of a snap.");
  joint.optional("diameter_m", &StepJoint::diameter, kLengthOrZero, "", isThreaded);
  joint.optional("pitch_m", &StepJoint::pitch, kCoordinate, "Metres a turn; below 0: left-handed.", isThreaded);
  joint.optional("pitch_stated", &StepJoint::isPitchStated, kBoolean,
                 "The pitch is modelled, or a person states it; else it is the coarse pitch of ISO 261.", isThreaded);
  joint.optional("turns", &StepJoint::turns, kLengthOrZero, "Full turns of the motion.", isThreaded);
}

template <class Archive>
void describe(Archive& motion, Type<StepMotion> /*type*/) {
  motion.type("motion");
  motion.required("bodies", kBodies, listOf(kBodyId, 1), "The bodies that leave, several as one rigid body.");
  motion.required("method", &StepMotion::method, kText,
                  "straight, turned (out of a thread), by hand, flexible (not proved), or auto and the member that "
                  "found the motion.");
  motion.required("certificate", kCertificate, kObject<StepCertificate>);
  motion.required("allowances", &StepMotion::allowances, kObjects<Allowance>);
  motion.optional("falling", &StepMotion::falling, kIds,
                  "Bodies that stand before the motion, and would tip or fall after it. Absent: none, or not asked.");
  motion.optional("fastener", &StepMotion::fastener, named(kFastenerNames), "Kind of the body. Absent: no fastener.");
  motion.optional("tool", &StepMotion::tool, kObject<StepTool>, "",
                  [](const StepMotion& written) { return written.tool.kind != ToolKind::None; });
  motion.required("path", &StepMotion::path, MotionFormat(),
                  "Straight motions of a frame between these configurations. At the first one the product is "
                  "assembled. The frame of a single body is at its reference point. A body of the motion is at "
                  "X(t) X(0)^-1 X_WB, where X_WB is its assembled configuration.");
  motion.optional("joints", &StepMotion::joints, kObjects<StepJoint>,
                  "Joints that come apart by the motion. Absent: none.");
  motion.optional("unit", &StepMotion::unit, kBoolean,
                  "The bodies are one unit: joints hold them together, and the plan does not take them apart.");
}

template <class Archive>
void describe(Archive& step, Type<AssemblyStep> /*type*/) {
  step.type("step");
  step.required("wave", &AssemblyStep::wave, kCount, "Steps of one wave were found together, from 1.");
  step.optional("after", &AssemblyStep::after, listOf(kCountFrom1),
                "Numbers, from 1, of the steps that have to be carried out before. Absent: all earlier ones.",
                Always());
  step.required("motions", &AssemblyStep::motions, listOf(kObject<StepMotion>, 1),
                "Motions that are carried out one after the other. Several: a fastener stack, such as nut, washer and "
                "bolt.");
  step.optional("violates", &AssemblyStep::violates, kObjects<StepViolation>,
                "Rules that a step breaks because a person has put it at its place. Absent: none.");
  step.optional("task", &AssemblyStep::task, kCountFrom1,
                "Steps of one task have the same number, from 1: alike screws that clamp the same bodies. Absent: the "
                "step is a task alone.");
}

template <class Archive>
void describe(Archive& stuck, Type<StuckBody> /*type*/) {
  stuck.type("stuck");
  stuck.required("part", &StuckBody::body, kBodyId);
  stuck.required("blocked_by", &StuckBody::blockedBy, kIds);
  stuck.optional("reason", &StuckBody::reason, kEnglish, "The reason for people, in English.", Always());
  stuck.optional("reason_message", kReasonAsData, MessageFormat(),
                 "The reason in a form that can be shown in other languages. It counts while its English text is the "
                 "reason.",
                 isStoredAsData);
}

template <class Archive>
void describe(Archive& line, Type<SubassemblyLine> /*type*/) {
  line.type("line",
            "The disassembly of a group that has left, in a frame of the group: only its bodies are there, as they "
            "stand in the assembled product.");
  line.required("step", &SubassemblyLine::step, kCountFrom1,
                "The step by which the group has left, number from 1, of the plan or of the line above.");
  line.required("bodies", &SubassemblyLine::bodies, kIds);
  line.required("staying", &SubassemblyLine::staying, kIds, "The bodies that remain as the base.");
  line.optional("up", &SubassemblyLine::up, DirectionFormat(), kAboutUp);
  line.required("steps", &SubassemblyLine::steps, kObjects<AssemblyStep>);
  line.required("stuck", &SubassemblyLine::stuck, kObjects<StuckBody>);
  line.optional("lines", &SubassemblyLine::lines, kObjects<SubassemblyLine>);
}

template <class Archive>
void describe(Archive& refusal, Type<RefusedRemoval> /*type*/) {
  refusal.type("refusal",
               "A search that need not be repeated with this effort (0: straight lines) while all of these bodies are "
               "there.");
  refusal.required("part", &RefusedRemoval::body, kBodyId);
  refusal.required("effort", &RefusedRemoval::effort, kEffort);
  refusal.required("after_steps", &RefusedRemoval::afterSteps, kCount);
  refusal.required("blocked_by", &RefusedRemoval::blockedBy, kIds);
  refusal.optional("with", &RefusedRemoval::with, kIds, "The other bodies of a group.");
}

template <class Archive>
void describe(Archive& clash, Type<AcceptedClash> /*type*/) {
  clash.type("accepted_clash", "A pair that overlaps and leaves, because a person accepts its clash.");
  clash.required("a", &AcceptedClash::a, kBodyId);
  clash.required("b", &AcceptedClash::b, kBodyId);
  clash.required("depth_m", &AcceptedClash::depth, kLengthOrZero);
  clash.required("cut", &AcceptedClash::cut, kIdOrNull,
                 "The body that is taken without what overlaps. Null: both are taken thinner.");
}

template <class Archive>
void describe(Archive& plan, Type<AssemblyPlan> /*type*/) {
  plan.type("plan");
  plan.required("strategy", &AssemblyPlan::strategy, kNonEmptyText);
  plan.required("seed", &AssemblyPlan::seed, kCount);
  plan.optional("deflection_m", &AssemblyPlan::deflection, kLengthOrZero,
                "How far triangles may be off the surfaces of the product's STEP file. 0 or absent: by the size of "
                "each part.",
                Always());
  plan.computed(
      "parts", [](const AssemblyPlan& of) { return of.parts(); }, kCount, "Bodies that are to leave.");
  plan.computed(
      "removed", [](const AssemblyPlan& of) { return of.removed(); }, kCount, "Bodies that leave.");
  plan.computed("apart", bodiesApart, kCount,
                "Bodies that leave alone, as a unit, or with their insert: the rest remains in groups.");
  plan.required("end", &AssemblyPlan::end, named(kPlanEndNames));
  plan.computed(
      "certified", [](const AssemblyPlan& of) { return of.removedWithoutProof() == 0; }, kBoolean,
      "Every step is certified. False: a flexible body leaves without a proof.");
  plan.required("bodies", &AssemblyPlan::bodies, kIds, "All bodies of the product, in its order.");
  plan.required("staying", &AssemblyPlan::staying, kIds);
  plan.optional("up", &AssemblyPlan::up, DirectionFormat(), kAboutUp);
  plan.required("steps", &AssemblyPlan::steps, kObjects<AssemblyStep>);
  plan.required("stuck", &AssemblyPlan::stuck, kObjects<StuckBody>);
  plan.required("refusals", &AssemblyPlan::refusals,
                listOf(kObject<RefusedRemoval>, 0, kMostEffort * limits::kMostBodies));
  plan.optional("sequence", &AssemblyPlan::demands, kObject<SequenceDemands>,
                "The demands and the knowledge, as in the section sequence of scenarios.");
  plan.optional("waiting", &AssemblyPlan::waiting, kObjects<StepMotion>,
                "Motions of a plan that has not ended: they were found and wait, because bodies would fall.");
  plan.optional("lines", &AssemblyPlan::lines, kObjects<SubassemblyLine>,
                "The disassembly of the groups that have left, by step. Absent: none.");
  plan.optional("isolated", &AssemblyPlan::isolated, kIds,
                "Bodies that neither touch another body nor are joined to one: they may lie beside the product. "
                "Absent: none.");
  plan.optional("accepted_clashes", kAcceptedClashes, kObjects<AcceptedClash>,
                "The accepted clashes that the motions need. They follow from the allowances. Absent: none.");
}

namespace {

/// Checks that a plan, or the line of a group, names its own bodies, that no body leaves twice, and that steps name
/// earlier steps. Completes `after` of steps that do not state it.
class PlanCheck {
 public:
  PlanCheck(const std::vector<BodyId>& bodies, const std::vector<BodyId>& staying, const JsonCursor& at) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!known_.insert(bodies[i]).second) at.at("bodies").element(i).fail(GLISSADE_TEXT("is there twice"));
    }
    expectKnown(staying, at.at("staying"));
    for (std::size_t i = 0; i < staying.size(); ++i) {
      if (!gone_.insert(staying[i]).second) at.at("staying").element(i).fail(GLISSADE_TEXT("is there twice"));
    }
  }

  void checkSteps(std::vector<AssemblyStep>& steps, const JsonCursor& at) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      checkStep(steps[i], at.element(i));
      ++steps_;
    }
  }

  void checkWaiting(const std::vector<StepMotion>& motions, const JsonCursor& at) const {
    for (std::size_t i = 0; i < motions.size(); ++i) checkMotion(motions[i], at.element(i));
  }

  void checkStuck(const std::vector<StuckBody>& stuck, const JsonCursor& list) const {
    for (std::size_t i = 0; i < stuck.size(); ++i) {
      const JsonCursor at = list.element(i);
      expectKnown(stuck[i].body, at.at("part"));
      expectKnown(stuck[i].blockedBy, at.at("blocked_by"));
      if (gone_.count(stuck[i].body) != 0) at.at("part").fail(GLISSADE_TEXT("is fixed as base, or was removed"));
    }
  }

  /// All bodies of a line are present at its beginning, and those that stay cannot leave.
  void checkLines(std::vector<SubassemblyLine>& lines, const JsonCursor& list) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      SubassemblyLine& line = lines[i];
      const JsonCursor at = list.element(i);
      if (line.step > steps_) at.at("step").fail(GLISSADE_TEXT("is not a step before it"));
      expectKnown(line.bodies, at.at("bodies"));
      PlanCheck inner(line.bodies, line.staying, at);
      inner.checkSteps(line.steps, at.at("steps"));
      inner.checkStuck(line.stuck, at.at("stuck"));
      if (const auto below = at.find("lines")) inner.checkLines(line.lines, *below);
    }
  }

  void checkRefusals(const std::vector<RefusedRemoval>& refusals, const JsonCursor& list) const {
    for (std::size_t i = 0; i < refusals.size(); ++i) {
      const JsonCursor at = list.element(i);
      expectKnown(refusals[i].body, at.at("part"));
      expectBefore(refusals[i].afterSteps, at.at("after_steps"));
      expectKnown(refusals[i].blockedBy, at.at("blocked_by"));
      if (const auto with = at.find("with")) expectKnown(refusals[i].with, *with);
    }
  }

  void expectKnown(const std::vector<BodyId>& ids, const JsonCursor& at) const {
    for (std::size_t i = 0; i < ids.size(); ++i) expectKnown(ids[i], at.element(i));
  }

 private:
  void expectKnown(const BodyId& id, const JsonCursor& at) const {
    if (known_.count(id) == 0) at.fail(GLISSADE_TEXT("is none of the plan's bodies"));
  }
  /// `after`: a number of preceding steps, at most the number of steps so far.
  void expectBefore(std::size_t after, const JsonCursor& at) const {
    if (after > steps_) at.fail(GLISSADE_TEXT("is more than the steps before it"));
  }

  void checkStep(AssemblyStep& step, const JsonCursor& at) {
    completeAfter(step, at);
    for (std::size_t i = 0; i < step.violates.size(); ++i) {
      expectKnown(step.violates[i].bodies, at.at("violates").element(i).at("bodies"));
    }
    for (std::size_t i = 0; i < step.motions.size(); ++i) {
      checkMotion(step.motions[i], at.at("motions").element(i));
      for (const BodyId& id : step.motions[i].bodies()) gone_.insert(id);
    }
  }

  void checkMotion(const StepMotion& motion, const JsonCursor& at) const {
    checkBodies(motion, at.at("bodies"));
    if (const auto tool = at.find("tool")) {
      if (const auto blockers = tool->find("blocked_by")) expectKnown(motion.tool.blockedBy, *blockers);
      if (const auto turned = tool->find("turned")) expectKnown(motion.tool.turned, *turned);
      if (const auto held = tool->find("held")) expectKnown(motion.tool.held, *held);
    }
    if (const auto falling = at.find("falling")) expectKnown(motion.falling, *falling);
    const JsonCursor certificate = at.at("certificate");
    expectBefore(motion.proof.afterSteps, certificate.at("after_steps"));
    if (!motion.proof.nearest.empty()) expectKnown(motion.proof.nearest, certificate.at("nearest"));
    for (std::size_t i = 0; i < motion.joints.size(); ++i) checkJoint(motion.joints[i], at.at("joints").element(i));
    for (std::size_t i = 0; i < motion.allowances.size(); ++i) {
      const JsonCursor allowance = at.at("allowances").element(i);
      expectKnown(motion.allowances[i].body, allowance.at("body"));
      if (const auto moving = allowance.find("moving")) expectKnown(motion.allowances[i].moving, *moving);
    }
  }

  void checkBodies(const StepMotion& motion, const JsonCursor& at) const {
    const std::vector<BodyId> ids = motion.bodies();
    expectKnown(ids, at);
    std::set<BodyId> gone = gone_;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!gone.insert(ids[i]).second) at.element(i).fail(GLISSADE_TEXT("is fixed as base, or was removed before"));
    }
  }

  void completeAfter(AssemblyStep& step, const JsonCursor& at) const {
    const auto stated = at.find("after");
    for (std::size_t number = 1; !stated && number <= steps_; ++number) step.after.push_back(number);
    for (std::size_t i = 0; stated && i < step.after.size(); ++i) {
      if (step.after[i] > steps_) stated->element(i).fail(GLISSADE_TEXT("is not an earlier step"));
    }
  }

  void checkJoint(const StepJoint& joint, const JsonCursor& at) const {
    expectKnown(joint.body, at.at("body"));
    expectKnown(joint.others, at.at("others"));
    if (const auto clamped = at.find("clamped")) expectKnown(joint.clamped, *clamped);
  }

  std::set<BodyId> known_;
  std::set<BodyId> gone_;
  std::size_t steps_ = 0;  ///< number of steps that are checked
};

void checkPlan(PlanDocument& document, const JsonCursor& at) {
  AssemblyPlan& plan = document.plan;
  PlanCheck check(plan.bodies, plan.staying, at);
  check.checkSteps(plan.steps, at.at("steps"));
  if (const auto waiting = at.find("waiting")) check.checkWaiting(plan.waiting, *waiting);
  check.checkStuck(plan.stuck, at.at("stuck"));
  if (const auto lines = at.find("lines")) check.checkLines(plan.lines, *lines);
  check.checkRefusals(plan.refusals, at.at("refusals"));
  if (const auto isolated = at.find("isolated")) check.expectKnown(plan.isolated, *isolated);
}

}  // namespace

template <class Archive>
void describe(Archive& document, Type<PlanDocument> /*type*/) {
  document.type("plan_document",
                "In which order the bodies of a product leave, each with a certified motion; assembly is the reverse. "
                "Lengths are in metres. Bodies are named by their ids.");
  document.constant("format", kPlanFormat);
  document.constant("version", 2);
  document.optional("program", &PlanDocument::program, kText, "", Always());
  document.optional("product", &PlanDocument::product, kText, "The file that was planned, as it was named.", Always());
  document.embed(&PlanDocument::plan);
  document.check(checkPlan);
}

PlanDocument PlanDocumentFormat::read(const JsonCursor& at) const {
  if (!at.has("version") || at.at("version").json() != 1) return kObject<PlanDocument>.read(at);
  const Json upgraded = upgradedPlan(at.json());
  return kObject<PlanDocument>.read(JsonCursor(upgraded, at.file(), at.pointer()));
}

Json PlanDocumentFormat::write(const PlanDocument& document) const { return kObject<PlanDocument>.write(document); }

Json PlanDocumentFormat::schema(SchemaDefinitions& definitions) const {
  return kObject<PlanDocument>.schema(definitions);
}

PlanDocument planDocument(const AssemblyPlan& plan, const std::string& product) {
  return {std::string("Glissade ") + kVersion, product, plan};
}

Json planSchema() {
  Json schema = describedSchema<PlanDocument>("Glissade assembly plan, version 2");
  addChecksumProperty(schema);
  return schema;
}

Json planJson(const AssemblyPlan& plan, const std::string& product) {
  return kObject<PlanDocument>.write(planDocument(plan, product));
}

}  // namespace glissade
