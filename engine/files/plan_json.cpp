#include "engine/files/plan_json.h"

#include <glissade/version.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <variant>

#include "engine/base/limits.h"
#include "engine/base/message_json.h"
#include "engine/check/stated_json.h"
#include "engine/files/plan_file.h"
#include "engine/files/scenario_fits.h"
#include "engine/files/sequence_json.h"
#include "engine/fits/contact_report.h"
#include "engine/sequence/subassembly_lines.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr std::size_t kMostEffort = 64;
/// Deepest nesting of the lines of groups.
constexpr std::size_t kMostLines = 32;
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Status of a certificate. A flexible body leaves without a proof.
constexpr const char* kCertified = "certified";
constexpr const char* kNotCertified = "not_certified";

Json toJson(const StepProof& proof, bool certified) {
  return {{"status", certified ? kCertified : kNotCertified},
          {"after_steps", proof.afterSteps},
          {"required_m", proof.required},
          {"proved_clearance_m", number(proof.provedClearance)},
          {"min_clearance_m", number(proof.minClearance)},
          {"nearest", proof.nearest.empty() ? Json(nullptr) : Json(proof.nearest)}};
}

Json toJson(const evidence::Evidence& evidence) {
  Json json{{"overlap_m", evidence.overlap},
            {"deflection_m", evidence.deflection},
            {"spacing_m", evidence.spacing},
            {"margin_m", evidence.margin}};
  if (evidence.byPerson > 0.0) json["by_person_m"] = evidence.byPerson;
  return json;
}

Json toJson(const Allowance& allowance) {
  Json json{{"body", allowance.body},
            {"kind", kContactKindNames.of(allowance.kind)},
            {"overlap_m", allowance.overlap},
            {"allowance_m", allowance.allowance},
            {"text", toString(allowance.text)}};
  if (!allowance.moving.empty()) json["moving"] = allowance.moving;
  if (allowance.yields) json["yields"] = true;
  if (allowance.hollow) json["hollow"] = true;
  if (allowance.core) json["core"] = threadJson(*allowance.core);
  if (allowance.evidence.sum() > 0.0) json["evidence"] = toJson(allowance.evidence);
  if (allowance.pitch == 0.0) return json;
  json["pitch_m"] = allowance.pitch;
  json["turns"] = allowance.turns;
  return json;
}

constexpr EnumNames<ToolAccess, 3> kAccessNames{{"not_asked", "free", "blocked"}};

Json toJson(const StepTool& tool) {
  Json json{{"kind", kToolNames.of(tool.kind)}, {"access", kAccessNames.of(tool.access)}};
  if (!tool.blockedBy.empty()) json["blocked_by"] = tool.blockedBy;
  if (!tool.turned.empty()) json["turned"] = tool.turned;
  return json;
}

Json toJson(const StepJoint& joint) {
  Json json{{"kind", kJointKindNames.of(joint.kind)}, {"body", joint.body}, {"others", joint.others}};
  if (!joint.clamped.empty()) json["clamped"] = joint.clamped;
  if (!joint.designation.empty()) json["designation"] = joint.designation;
  if (joint.drive != DriveKind::None) json["drive"] = kDriveNames.of(joint.drive);
  if (joint.driveSize > 0.0) json["drive_size_m"] = joint.driveSize;
  if (joint.bend > 0.0) json["bend_m"] = joint.bend;
  if (joint.pitch == 0.0) return json;
  json["diameter_m"] = joint.diameter;
  json["pitch_m"] = joint.pitch;
  json["pitch_stated"] = joint.isPitchStated;
  json["turns"] = joint.turns;
  return json;
}

Json toJson(const AssemblyStep& step) {
  Json json{{"bodies", step.bodies()},
            {"method", step.method},
            {"wave", step.wave},
            {"after", step.after},
            {"certificate", toJson(step.proof, step.certified)},
            {"allowances", Json::array()}};
  if (!step.falling.empty()) json["falling"] = step.falling;
  if (step.fastener != FastenerKind::None) json["fastener"] = kFastenerNames.of(step.fastener);
  if (step.tool.kind != ToolKind::None) json["tool"] = toJson(step.tool);
  for (const Allowance& allowance : step.allowances) json["allowances"].push_back(toJson(allowance));
  json["path"] = motionJson(step.path);
  for (const StepViolation& violation : step.violates) {
    json["violates"].push_back({{"rule", kRuleNames.of(violation.rule)}, {"bodies", violation.bodies}});
  }
  for (const StepJoint& joint : step.joints) json["joints"].push_back(toJson(joint));
  if (step.task != 0) json["task"] = step.task;
  if (step.unit) json["unit"] = true;
  return json;
}

/// Deepest nesting of a reason that is stored as data, because the JSON reader refuses files that nest deeper than 32.
constexpr int kDeepestReason = 4;

bool isNestedWithin(int levels, const Message& message) {
  return levels > 0 &&
         std::all_of(message.arguments.begin(), message.arguments.end(), [&](const MessageArgument& each) {
           const auto* nested = std::get_if<Message>(&each.value);
           return nested == nullptr || isNestedWithin(levels - 1, *nested);
         });
}

Json toJson(const StuckBody& stuck) {
  Json json{{"part", stuck.body}, {"blocked_by", stuck.blockedBy}, {"reason", toString(stuck.reason)}};
  if (!stuck.reason.empty() && isNestedWithin(kDeepestReason, stuck.reason)) {
    json["reason_message"] = glissade::toJson(stuck.reason);
  }
  return json;
}

Json toJson(const SubassemblyLine& line) {
  Json json{{"step", line.step},
            {"bodies", line.bodies},
            {"staying", line.staying},
            {"steps", Json::array()},
            {"stuck", Json::array()}};
  for (const AssemblyStep& step : line.steps) json["steps"].push_back(toJson(step));
  for (const StuckBody& stuck : line.stuck) json["stuck"].push_back(toJson(stuck));
  for (const SubassemblyLine& each : line.lines) json["lines"].push_back(toJson(each));
  return json;
}

/// Reads one plan. Throws JsonError.
class PlanReader {
 public:
  AssemblyPlan read(const JsonCursor& at) {
    at.allowOnly({"format", "version", "program",  "product", "strategy",  "seed",   "deflection_m",
                  "parts",  "removed", "apart",    "end",     "certified", "bodies", "staying",
                  "steps",  "stuck",   "refusals", "waiting", "sequence",  "lines"});
    if (at.at("format").text() != kPlanFormat) at.at("format").fail({GLISSADE_TEXT("is not \"%1\""), {kPlanFormat}});
    if (at.at("version").wholeNumber() != 1)
      at.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
    plan_.strategy = at.at("strategy").nonEmptyText();
    plan_.seed = at.at("seed").wholeNumber();
    if (const auto demands = at.find("sequence")) plan_.demands = readSequence(*demands);
    if (const auto deflection = at.find("deflection_m")) plan_.deflection = readLength(*deflection);
    plan_.end = at.at("end").named(kPlanEndNames);
    readBodies(at.at("bodies"));
    plan_.staying = readIds(at.at("staying"));
    for (std::size_t i = 0; i < plan_.staying.size(); ++i) {
      if (!gone_.insert(plan_.staying[i]).second) at.at("staying").element(i).fail(GLISSADE_TEXT("is there twice"));
    }
    const JsonCursor steps = at.at("steps");
    for (std::size_t i = 0; i < steps.sizeUpTo(limits::kMostBodies); ++i) {
      plan_.steps.push_back(readStep(steps.element(i)));
      for (const std::string& id : plan_.steps.back().bodies()) gone_.insert(id);
    }
    const auto waiting = at.find("waiting");
    for (std::size_t i = 0; waiting && i < waiting->sizeUpTo(limits::kMostBodies); ++i) {
      plan_.waiting.push_back(readStep(waiting->element(i)));
    }
    const JsonCursor stuck = at.at("stuck");
    for (std::size_t i = 0; i < stuck.sizeUpTo(limits::kMostBodies); ++i) {
      plan_.stuck.push_back(readStuck(stuck.element(i)));
    }
    const auto lines = at.find("lines");
    for (std::size_t i = 0; lines && i < lines->sizeUpTo(limits::kMostBodies); ++i) {
      plan_.lines.push_back(readLine(lines->element(i), plan_.steps.size(), 0));
    }
    const JsonCursor refusals = at.at("refusals");
    for (std::size_t i = 0; i < refusals.sizeUpTo(kMostEffort * limits::kMostBodies); ++i) {
      readRefusal(refusals.element(i));
    }
    return std::move(plan_);
  }

 private:
  void readBodies(const JsonCursor& at) {
    for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) {
      plan_.bodies.push_back(at.element(i).nonEmptyText());
      if (!known_.insert(plan_.bodies.back()).second) at.element(i).fail(GLISSADE_TEXT("is there twice"));
    }
  }

  std::string readId(const JsonCursor& at) const {
    std::string id = at.text();
    if (known_.count(id) == 0) at.fail(GLISSADE_TEXT("is none of the plan's bodies"));
    return id;
  }

  std::vector<std::string> readIds(const JsonCursor& at) const {
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) ids.push_back(readId(at.element(i)));
    return ids;
  }

  /// Reads a number of preceding steps, at most the number of steps read so far.
  std::size_t readAfter(const JsonCursor& at) const {
    const std::uint64_t after = at.wholeNumber();
    if (after > plan_.steps.size()) at.fail(GLISSADE_TEXT("is more than the steps before it"));
    return static_cast<std::size_t>(after);
  }

  static double readLength(const JsonCursor& at) {
    if (at.json().is_null()) return std::numeric_limits<double>::infinity();
    const double value = at.coordinate();
    if (value < 0.0) at.fail(GLISSADE_TEXT("is below zero"));
    return value;
  }

  AssemblyStep readStep(const JsonCursor& at) const {
    at.allowOnly({"bodies", "method", "wave", "after", "fastener", "tool", "falling", "certificate", "allowances",
                  "path", "violates", "joints", "task", "unit"});
    AssemblyStep step;
    const JsonCursor bodies = at.at("bodies");
    std::vector<std::string> ids = readIds(bodies);
    if (ids.empty()) bodies.fail(GLISSADE_TEXT("is empty"), GLISSADE_TEXT("Name the bodies that are removed."));
    std::set<std::string> gone = gone_;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!gone.insert(ids[i]).second) bodies.element(i).fail(GLISSADE_TEXT("is fixed as base, or was removed before"));
    }
    step.body = ids.front();
    step.with.assign(ids.begin() + 1, ids.end());
    step.after = readPredecessors(at);
    if (const auto fastener = at.find("fastener")) step.fastener = fastener->named(kFastenerNames);
    if (const auto tool = at.find("tool")) step.tool = readTool(*tool);
    step.method = at.at("method").text();
    if (const auto falling = at.find("falling")) step.falling = readIds(*falling);
    const auto violates = at.find("violates");
    for (std::size_t i = 0; violates && i < violates->sizeUpTo(kRuleNames.names.size()); ++i) {
      step.violates.push_back(readViolation(violates->element(i)));
    }
    step.wave = static_cast<std::size_t>(at.at("wave").wholeNumber());
    step.certified = readCertified(at.at("certificate").at("status"));
    step.proof = readProof(at.at("certificate"), step.certified);
    const auto joints = at.find("joints");
    for (std::size_t i = 0; joints && i < joints->sizeUpTo(limits::kMostBodies); ++i) {
      step.joints.push_back(readJoint(joints->element(i)));
    }
    if (const auto task = at.find("task")) step.task = static_cast<std::size_t>(task->wholeNumber());
    if (const auto unit = at.find("unit")) step.unit = unit->boolean();
    const JsonCursor allowances = at.at("allowances");
    for (std::size_t i = 0; i < allowances.sizeUpTo(limits::kMostBodies); ++i) {
      step.allowances.push_back(readAllowance(allowances.element(i)));
    }
    step.path = readMotion(at.at("path"));
    return step;
  }

  StepViolation readViolation(const JsonCursor& at) const {
    at.allowOnly({"rule", "bodies"});
    return {at.at("rule").named(kRuleNames), readIds(at.at("bodies"))};
  }

  StepTool readTool(const JsonCursor& at) const {
    at.allowOnly({"kind", "access", "blocked_by", "turned"});
    StepTool tool{at.at("kind").named(kToolNames), at.at("access").named(kAccessNames)};
    if (const auto blockers = at.find("blocked_by")) tool.blockedBy = readIds(*blockers);
    if (const auto turned = at.find("turned")) tool.turned = readId(*turned);
    return tool;
  }

  /// Reads the predecessors; all earlier steps where the file does not state them.
  std::vector<std::size_t> readPredecessors(const JsonCursor& step) const {
    std::vector<std::size_t> after;
    const auto at = step.find("after");
    for (std::size_t number = 1; !at && number <= plan_.steps.size(); ++number) after.push_back(number);
    for (std::size_t i = 0; at && i < at->sizeUpTo(limits::kMostBodies); ++i) {
      const std::uint64_t number = at->element(i).wholeNumber();
      if (number == 0 || number > plan_.steps.size()) at->element(i).fail(GLISSADE_TEXT("is not an earlier step"));
      after.push_back(static_cast<std::size_t>(number));
    }
    return after;
  }

  static bool readCertified(const JsonCursor& at) {
    const std::string status = at.text();
    if (status != kCertified && status != kNotCertified) at.fail(GLISSADE_TEXT("is not certified or not_certified"));
    return status == kCertified;
  }

  StepJoint readJoint(const JsonCursor& at) const {
    at.allowOnly({"kind", "body", "others", "clamped", "designation", "drive", "drive_size_m", "bend_m", "diameter_m",
                  "pitch_m", "pitch_stated", "turns"});
    StepJoint joint{at.at("kind").named(kJointKindNames), readId(at.at("body")), readIds(at.at("others"))};
    if (const auto clamped = at.find("clamped")) joint.clamped = readIds(*clamped);
    if (const auto designation = at.find("designation")) joint.designation = designation->text();
    if (const auto drive = at.find("drive")) joint.drive = drive->named(kDriveNames);
    if (const auto size = at.find("drive_size_m")) joint.driveSize = readLength(*size);
    if (const auto bend = at.find("bend_m")) joint.bend = readLength(*bend);
    if (const auto diameter = at.find("diameter_m")) joint.diameter = readLength(*diameter);
    if (const auto pitch = at.find("pitch_m")) joint.pitch = pitch->coordinate();
    if (const auto stated = at.find("pitch_stated")) joint.isPitchStated = stated->boolean();
    if (const auto turns = at.find("turns")) joint.turns = readLength(*turns);
    return joint;
  }

  StepProof readProof(const JsonCursor& at, bool certified) const {
    at.allowOnly({"status", "after_steps", "required_m", "proved_clearance_m", "min_clearance_m", "nearest"});
    StepProof proof;
    proof.afterSteps = readAfter(at.at("after_steps"));
    if (!certified) return proof;
    proof.required = at.at("required_m").positiveNumber();
    proof.provedClearance = readLength(at.at("proved_clearance_m"));
    proof.minClearance = readLength(at.at("min_clearance_m"));
    if (!at.at("nearest").json().is_null()) proof.nearest = readId(at.at("nearest"));
    return proof;
  }

  static evidence::Evidence readEvidence(const JsonCursor& at) {
    at.allowOnly({"overlap_m", "deflection_m", "spacing_m", "margin_m", "by_person_m"});
    evidence::Evidence evidence{readLength(at.at("overlap_m")), readLength(at.at("deflection_m")),
                                readLength(at.at("spacing_m")), readLength(at.at("margin_m"))};
    if (const auto person = at.find("by_person_m")) evidence.byPerson = readLength(*person);
    return evidence;
  }

  Allowance readAllowance(const JsonCursor& at) const {
    at.allowOnly({"body", "kind", "overlap_m", "allowance_m", "text", "moving", "yields", "hollow", "core", "evidence",
                  "pitch_m", "turns"});
    Allowance allowance{readId(at.at("body")), at.at("kind").named(kContactKindNames), readLength(at.at("overlap_m")),
                        readLength(at.at("allowance_m")), Message(at.at("text").text())};
    if (const auto moving = at.find("moving")) allowance.moving = readId(*moving);
    if (const auto yields = at.find("yields")) allowance.yields = yields->boolean();
    if (const auto hollow = at.find("hollow")) allowance.hollow = hollow->boolean();
    if (const auto core = at.find("core")) allowance.core = check::readThread(*core);
    if (const auto evidence = at.find("evidence")) allowance.evidence = readEvidence(*evidence);
    if (const auto pitch = at.find("pitch_m")) {
      allowance.pitch = pitch->coordinate();
      if (allowance.pitch == 0.0) pitch->fail(GLISSADE_TEXT("is not a pitch"));
    }
    if (const auto turns = at.find("turns")) {
      allowance.turns = readLength(*turns);
      if (allowance.pitch == 0.0) turns->fail(GLISSADE_TEXT("is without a pitch"));
    }
    return allowance;
  }

  /// The reason as data, unless its English text differs from the plain one, which a person may have edited.
  static Message readReason(const JsonCursor& at) {
    const auto reason = at.find("reason");
    if (!reason) return {};
    const auto data = at.find("reason_message");
    const auto message = data ? messageFrom(nlohmann::json(data->json())) : std::nullopt;
    return message && toString(*message) == reason->text() ? *message : Message(reason->text());
  }

  StuckBody readStuck(const JsonCursor& at) const {
    at.allowOnly({"part", "blocked_by", "reason", "reason_message"});
    StuckBody stuck{readId(at.at("part")), readIds(at.at("blocked_by"))};
    stuck.reason = readReason(at);
    if (gone_.count(stuck.body) != 0) at.at("part").fail(GLISSADE_TEXT("is fixed as base, or was removed"));
    return stuck;
  }

  /// Reads the line of a group. All its bodies are present at its beginning, and those that stay cannot leave. `steps`:
  /// number of steps of the plan that contains it.
  SubassemblyLine readLine(const JsonCursor& at, std::size_t steps, std::size_t depth) const {
    at.allowOnly({"step", "bodies", "staying", "steps", "stuck", "lines"});
    if (depth == kMostLines) at.fail({GLISSADE_TEXT("is deeper than %1 lines"), {kMostLines}});
    SubassemblyLine line;
    line.step = static_cast<std::size_t>(at.at("step").wholeNumber());
    if (line.step == 0 || line.step > steps) at.at("step").fail(GLISSADE_TEXT("is not a step before it"));
    line.bodies = readIds(at.at("bodies"));
    line.staying = readIds(at.at("staying"));
    PlanReader inner;
    inner.known_ = {line.bodies.begin(), line.bodies.end()};
    inner.gone_ = {line.staying.begin(), line.staying.end()};
    const JsonCursor own = at.at("steps");
    for (std::size_t i = 0; i < own.sizeUpTo(limits::kMostBodies); ++i) {
      inner.plan_.steps.push_back(inner.readStep(own.element(i)));
      for (const std::string& id : inner.plan_.steps.back().bodies()) inner.gone_.insert(id);
    }
    const JsonCursor stuck = at.at("stuck");
    for (std::size_t i = 0; i < stuck.sizeUpTo(limits::kMostBodies); ++i) {
      line.stuck.push_back(inner.readStuck(stuck.element(i)));
    }
    line.steps = std::move(inner.plan_.steps);
    const auto lines = at.find("lines");
    for (std::size_t i = 0; lines && i < lines->sizeUpTo(limits::kMostBodies); ++i) {
      line.lines.push_back(inner.readLine(lines->element(i), line.steps.size(), depth + 1));
    }
    return line;
  }

  void readRefusal(const JsonCursor& at) {
    at.allowOnly({"part", "with", "effort", "after_steps", "blocked_by"});
    const std::uint64_t effort = at.at("effort").wholeNumber();
    if (effort >= kMostEffort) at.at("effort").fail(GLISSADE_TEXT("is too large"));
    plan_.refusals.push_back({readId(at.at("part")), static_cast<int>(effort), readAfter(at.at("after_steps")),
                              readIds(at.at("blocked_by"))});
    if (const auto with = at.find("with")) plan_.refusals.back().with = readIds(*with);
  }

  std::set<std::string> known_;
  std::set<std::string> gone_;
  AssemblyPlan plan_;
};

}  // namespace

Json planJson(const AssemblyPlan& plan, const std::string& product) {
  Json json{{"format", kPlanFormat},
            {"version", 1},
            {"program", std::string("Glissade ") + kVersion},
            {"product", product},
            {"strategy", plan.strategy},
            {"seed", plan.seed},
            {"deflection_m", plan.deflection},
            {"parts", plan.parts()},
            {"removed", plan.removed()},
            {"apart", bodiesApart(plan)},
            {"end", kPlanEndNames.of(plan.end)},
            {"certified", plan.removedWithoutProof() == 0},
            {"bodies", plan.bodies},
            {"staying", plan.staying},
            {"steps", Json::array()},
            {"stuck", Json::array()},
            {"refusals", Json::array()}};
  addSequence(plan.demands, json);
  for (const AssemblyStep& step : plan.steps) json["steps"].push_back(toJson(step));
  for (const AssemblyStep& step : plan.waiting) json["waiting"].push_back(toJson(step));
  for (const StuckBody& stuck : plan.stuck) json["stuck"].push_back(toJson(stuck));
  for (const SubassemblyLine& line : plan.lines) json["lines"].push_back(toJson(line));
  for (const RefusedRemoval& refused : plan.refusals) {
    json["refusals"].push_back({{"part", refused.body},
                                {"effort", refused.effort},
                                {"after_steps", refused.afterSteps},
                                {"blocked_by", refused.blockedBy}});
    if (!refused.with.empty()) json["refusals"].back()["with"] = refused.with;
  }
  return json;
}

AssemblyPlan readPlanJson(const JsonCursor& at) { return PlanReader().read(at); }

}  // namespace glissade
