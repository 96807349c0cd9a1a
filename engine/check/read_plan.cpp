#include <algorithm>
#include <array>
#include <limits>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/check/read_path.h"
#include "engine/check/stated_json.h"
#include "engine/import/json_checksum.h"

namespace glissade::check {
namespace {

constexpr const char* kPlanFormatName = "glissade-plan";

std::vector<BodyId> idsOf(const JsonCursor& at) {
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) ids.emplace_back(at.element(i).text());
  return ids;
}

/// A length in metres, at least 0.
double lengthAt(const JsonCursor& at) {
  const double value = at.coordinate();
  if (value < 0.0) at.fail(GLISSADE_TEXT("is below zero"));
  return value;
}

StatedJoint readJoint(const JsonCursor& at) {
  at.allowOnly({"kind", "body", "others", "clamped", "designation", "drive", "drive_size_m", "bend_m", "diameter_m",
                "pitch_m", "pitch_stated", "turns"});
  StatedJoint joint{at.at("kind").text(), BodyId(at.at("body").text()), {}};
  if (const auto others = at.find("others")) joint.others = idsOf(*others);
  if (const auto drive = at.find("drive")) joint.drive = drive->text();
  if (const auto name = at.find("designation")) joint.isNamed = !name->text().empty();
  if (const auto diameter = at.find("diameter_m")) joint.diameter = lengthAt(*diameter);
  if (const auto pitch = at.find("pitch_m")) joint.pitch = pitch->coordinate();
  if (const auto turns = at.find("turns")) joint.turns = lengthAt(*turns);
  if (const auto bend = at.find("bend_m")) joint.bend = lengthAt(*bend);
  if (const auto size = at.find("drive_size_m")) joint.driveSize = lengthAt(*size);
  return joint;
}

/// Null means that no body is near.
std::optional<double> clearanceAt(const std::optional<JsonCursor>& at) {
  if (!at) return std::nullopt;
  return at->json().is_null() ? std::numeric_limits<double>::infinity() : lengthAt(*at);
}

StatedProof readProof(const JsonCursor& at) {
  at.allowOnly({"status", "after_steps", "required_m", "proved_clearance_m", "min_clearance_m", "nearest"});
  StatedProof proof;
  if (const auto after = at.find("after_steps")) proof.afterSteps = static_cast<std::size_t>(after->wholeNumber());
  if (const auto required = at.find("required_m")) proof.required = lengthAt(*required);
  proof.provedClearance = clearanceAt(at.find("proved_clearance_m"));
  proof.minClearance = clearanceAt(at.find("min_clearance_m"));
  const auto nearest = at.find("nearest");
  if (nearest && !nearest->json().is_null()) proof.nearest = BodyId(nearest->text());
  return proof;
}

void readStatements(const JsonCursor& at, Step& step) {
  if (const auto unit = at.find("unit")) step.unit = unit->boolean();
  if (const auto tool = at.find("tool"))
    tool->allowOnly({"kind", "access", "blocked_by", "turned", "held", "held_with"});
  step.proof = readProof(at.at("certificate"));
  const auto joints = at.find("joints");
  for (std::size_t i = 0; joints && i < joints->sizeUpTo(limits::kMostBodies); ++i) {
    step.joints.push_back(readJoint(joints->element(i)));
  }
}

using Keys = std::vector<std::string>;

Keys keysOfMotion() {
  return {"bodies", "method", "fastener", "tool", "falling", "certificate", "allowances", "path", "joints", "unit"};
}

/// Keys of a step with its `others`.
Keys keysOfStep(Keys others) {
  others.insert(others.end(), {"wave", "after", "violates", "task"});
  return others;
}

/// Adds the keys of a motion to `step`, which holds those of its step.
Step readMotion(const JsonCursor& at, Step step) {
  step.bodies = idsOf(at.at("bodies"));
  step.path = readPoints(at.at("path"));
  const JsonCursor allowances = at.at("allowances");
  for (std::size_t i = 0; i < allowances.sizeUpTo(limits::kMostBodies); ++i) {
    allowances.element(i).allowOnly({"body", "kind", "overlap_m", "allowance_m", "text", "moving", "yields", "hollow",
                                     "core", "evidence", "pitch_m", "turns"});
  }
  step.allowances = readAllowances(allowances);
  step.certified = at.at("certificate").at("status").text() == "certified";
  readStatements(at, step);
  step.flexible =
      step.bodies.size() == 1 && std::any_of(step.joints.begin(), step.joints.end(), [&](const auto& joint) {
        return joint.kind == "flexible" && joint.body == step.bodies.front();
      });
  return step;
}

/// Reads the keys that count for all motions of the step. `number`: number of the step, from 1.
Step readWhole(const JsonCursor& at, std::size_t number) {
  Step step;
  step.number = number;
  if (const auto wave = at.find("wave")) step.wave = wave->wholeNumber();
  if (const auto task = at.find("task")) step.task = task->wholeNumber();
  const auto after = at.find("after");
  for (std::size_t each = 1; !after && each < number; ++each) step.after.push_back(each);
  for (std::size_t i = 0; after && i < after->sizeUpTo(limits::kMostBodies); ++i) {
    step.after.push_back(static_cast<std::size_t>(after->element(i).wholeNumber()));
  }
  const auto violates = at.find("violates");
  for (std::size_t i = 0; violates && i < violates->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor each = violates->element(i);
    step.violates.push_back({each.at("rule").text(), idsOf(each.at("bodies"))});
  }
  return step;
}

/// Reads the motions of all steps. A step of version 1 is its one motion.
std::vector<Step> readSteps(const JsonCursor& list, std::uint64_t version) {
  std::vector<Step> motions;
  for (std::size_t i = 0; i < list.sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor at = list.element(i);
    Step step = readWhole(at, i + 1);
    if (version == 1) {
      at.allowOnly(keysOfStep(keysOfMotion()));
      motions.push_back(readMotion(at, std::move(step)));
      continue;
    }
    at.allowOnly(keysOfStep({"motions"}));
    const JsonCursor own = at.at("motions");
    const std::size_t count = own.sizeUpTo(limits::kMostBodies);
    if (count == 0) own.fail(GLISSADE_TEXT("is empty"));
    for (std::size_t motion = 0; motion < count; ++motion) {
      step.motion = count == 1 ? 0 : motion + 1;
      own.element(motion).allowOnly(keysOfMotion());
      motions.push_back(readMotion(own.element(motion), step));
    }
  }
  return motions;
}

/// The recursion ends because the JSON reader refuses nesting deeper than 32.
std::vector<Line> linesIn(const JsonCursor& at, std::uint64_t version) {
  std::vector<Line> lines;
  const auto list = at.find("lines");
  for (std::size_t i = 0; list && i < list->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor line = list->element(i);
    line.allowOnly({"step", "bodies", "staying", "up", "steps", "stuck", "lines"});
    lines.push_back({static_cast<std::size_t>(line.at("step").wholeNumber()), idsOf(line.at("bodies")),
                     idsOf(line.at("staying")), readSteps(line.at("steps"), version), linesIn(line, version)});
  }
  return lines;
}

Plan planIn(const JsonCursor& at) {
  at.allowOnly({"format",   "version", "program",  "product",   "strategy", "seed",    "deflection_m",    "parts",
                "removed",  "apart",   "end",      "certified", "bodies",   "staying", "steps",           "stuck",
                "refusals", "waiting", "sequence", "lines",     "isolated", "up",      "accepted_clashes"});
  if (at.at("format").text() != kPlanFormatName) at.at("format").fail(GLISSADE_TEXT("is not \"glissade-plan\""));
  const std::uint64_t version = at.at("version").wholeNumber();
  if (version != 1 && version != 2)
    at.at("version").fail(GLISSADE_TEXT("is neither 1 nor 2"), GLISSADE_TEXT("Use a newer Glissade."));
  Plan plan;
  plan.bodies = idsOf(at.at("bodies"));
  plan.staying = idsOf(at.at("staying"));
  plan.end = at.at("end").text();
  constexpr std::array<const char*, 4> kEnds{"complete", "stuck", "time_limit", "interrupted"};
  if (std::find(kEnds.begin(), kEnds.end(), plan.end) == kEnds.end()) {
    at.at("end").fail(GLISSADE_TEXT("is not complete, stuck, time_limit or interrupted"));
  }
  if (const auto demands = at.find("sequence")) {
    plan.demands = readDemands(*demands);
    if (const auto joints = demands->find("joints")) {
      plan.snaps = readSnaps(*joints);
      plan.joints = readJointWords(*joints, {});
    }
    plan.partings = readPartingsOfSequence(*demands, {});
  }
  if (const auto deflection = at.find("deflection_m")) plan.deflection = deflection->number();
  if (plan.deflection != 0.0 && !limits::isSize(plan.deflection)) {
    at.at("deflection_m").fail(GLISSADE_TEXT("is neither 0 nor a size from 1e-12 to 1e9 m"));
  }
  if (const auto parts = at.find("parts")) plan.parts = parts->wholeNumber();
  if (const auto removed = at.find("removed")) plan.removed = removed->wholeNumber();
  if (const auto apart = at.find("apart")) plan.apart = apart->wholeNumber();
  if (const auto certified = at.find("certified")) plan.certified = certified->boolean();
  plan.steps = readSteps(at.at("steps"), version);
  plan.lines = linesIn(at, version);
  return plan;
}

}  // namespace

Result<Plan> readPlan(const std::string& file) {
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return text.error();
  auto document = parseJson(*text, file);
  if (!document) return document.error();
  const ChecksumState checksum = takeChecksum(*document);
  try {
    Plan plan = planIn(JsonCursor(*document, file, ""));
    if (checksum == ChecksumState::Wrong) {
      return wrongChecksum(file, GLISSADE_TEXT("Plan again. To use an edited plan, remove its checksum."));
    }
    return plan;
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

bool isPlan(const std::string& file) {
  const auto text = readFile(file, limits::kMostScenarioBytes);
  if (!text) return false;
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  if (first == std::string::npos || (*text)[first] != '{') return false;
  const auto document = parseJson(*text, file);
  return document && document->is_object() && document->value("format", JsonCursor::Json()) == kPlanFormatName;
}

}  // namespace glissade::check
