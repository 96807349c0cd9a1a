#include <algorithm>
#include <array>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/check/read_path.h"
#include "engine/check/stated_json.h"
#include "engine/import/json_checksum.h"

namespace glissade::check {
namespace {

constexpr const char* kPlanFormatName = "glissade-plan";

std::vector<std::string> textsOf(const JsonCursor& at) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) texts.push_back(at.element(i).text());
  return texts;
}

/// The step is of one body, and takes a joint of it apart that is flexible.
bool saysFlexible(const JsonCursor& at, const std::vector<std::string>& bodies) {
  const auto joints = at.find("joints");
  for (std::size_t i = 0; joints && i < joints->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor joint = joints->element(i);
    const bool isFlexible = joint.at("kind").text() == "flexible";
    if (isFlexible && bodies.size() == 1 && joint.at("body").text() == bodies.front()) return true;
  }
  return false;
}

/// The pairs of bodies of those joints of the step that are threads, ids.
std::vector<std::pair<std::string, std::string>> turnedPairs(const JsonCursor& at) {
  std::vector<std::pair<std::string, std::string>> pairs;
  const auto joints = at.find("joints");
  for (std::size_t i = 0; joints && i < joints->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor joint = joints->element(i);
    const std::string kind = joint.at("kind").text();
    const auto others = joint.find("others");
    if (!others || (kind != "screw" && kind != "nut" && kind != "thread")) continue;
    for (const std::string& other : textsOf(*others)) pairs.emplace_back(joint.at("body").text(), other);
  }
  return pairs;
}

Step readStep(const JsonCursor& at, std::size_t earlier) {
  Step step;
  step.bodies = textsOf(at.at("bodies"));
  step.path = readPoints(at.at("path"));
  step.allowances = readAllowances(at.at("allowances"));
  step.certified = at.at("certificate").at("status").text() == "certified";
  step.flexible = saysFlexible(at, step.bodies);
  step.turned = turnedPairs(at);
  const auto after = at.find("after");
  for (std::size_t number = 1; !after && number <= earlier; ++number) step.after.push_back(number);
  for (std::size_t i = 0; after && i < after->sizeUpTo(limits::kMostBodies); ++i) {
    step.after.push_back(static_cast<std::size_t>(after->element(i).wholeNumber()));
  }
  const auto violates = at.find("violates");
  for (std::size_t i = 0; violates && i < violates->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor each = violates->element(i);
    step.violates.push_back({each.at("rule").text(), textsOf(each.at("bodies"))});
  }
  return step;
}

std::vector<Step> readSteps(const JsonCursor& at) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) steps.push_back(readStep(at.element(i), i));
  return steps;
}

/// Files are not nested deeper than 32 values.
std::vector<Line> linesIn(const JsonCursor& at) {
  std::vector<Line> lines;
  const auto list = at.find("lines");
  for (std::size_t i = 0; list && i < list->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor line = list->element(i);
    lines.push_back({static_cast<std::size_t>(line.at("step").wholeNumber()), textsOf(line.at("bodies")),
                     textsOf(line.at("staying")), readSteps(line.at("steps")), linesIn(line)});
  }
  return lines;
}

Plan planIn(const JsonCursor& at) {
  if (at.at("format").text() != kPlanFormatName) at.at("format").fail("is not \"glissade-plan\"");
  if (at.at("version").wholeNumber() != 1) at.at("version").fail("is not 1", "Use a newer Glissade.");
  Plan plan;
  plan.bodies = textsOf(at.at("bodies"));
  plan.staying = textsOf(at.at("staying"));
  plan.end = at.at("end").text();
  constexpr std::array<const char*, 4> kEnds{"complete", "stuck", "time_limit", "interrupted"};
  if (std::find(kEnds.begin(), kEnds.end(), plan.end) == kEnds.end()) {
    at.at("end").fail("is not complete, stuck, time_limit or interrupted");
  }
  if (const auto demands = at.find("sequence")) {
    plan.demands = readDemands(*demands);
    if (const auto joints = demands->find("joints")) plan.snaps = readSnaps(*joints);
    plan.partings = readPartingsOfSequence(*demands, {});
  }
  if (const auto deflection = at.find("deflection_m")) plan.deflection = deflection->number();
  if (plan.deflection != 0.0 && !limits::isSize(plan.deflection)) {
    at.at("deflection_m").fail("is neither 0 nor a size from 1e-12 to 1e9 m");
  }
  if (const auto parts = at.find("parts")) plan.parts = parts->wholeNumber();
  if (const auto removed = at.find("removed")) plan.removed = removed->wholeNumber();
  if (const auto certified = at.find("certified")) plan.certified = certified->boolean();
  plan.steps = readSteps(at.at("steps"));
  plan.lines = linesIn(at);
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
      return wrongChecksum(file, "Plan again. To use an edited plan, remove its checksum.");
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
