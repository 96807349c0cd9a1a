#include "engine/check/verdict_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/enum_names.h"
#include "engine/base/number_text.h"
#include "engine/check/plain_overlaps.h"
#include "engine/check/verdict_words.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/missing_shapes_json.h"

namespace glissade::check {
namespace {

using Report = nlohmann::ordered_json;

Report finite(double value) { return std::isfinite(value) ? Report(value) : Report(nullptr); }

constexpr EnumNames<Status, 3> kStatusNames{{"certified", "violated", "undecided"}};
constexpr EnumNames<PlanOutcome, 5> kOutcomeNames{{"valid", "conditional", "incomplete", "undecided", "invalid"}};

std::string bodyName(const Nearest& nearest, const Product& product) {
  return nearest.body < 0 ? std::string() : product.bodies[static_cast<std::size_t>(nearest.body)].name;
}

std::size_t slidingEdges(const MotionVerdict& verdict) {
  return static_cast<std::size_t>(std::count_if(verdict.edges.begin(), verdict.edges.end(),
                                                [](const EdgeVerdict& edge) { return edge.demand.sliding; }));
}

Message certifiedInWords(const MotionVerdict& verdict, const std::string& body) {
  Message near = GLISSADE_TEXT("nothing near");
  if (!body.empty()) {
    near = {GLISSADE_TEXT("clearance %1 mm to '%2'"), {shortText(verdict.minClearance * 1e3), body}};
  }
  const std::string demanded = shortText(verdict.demanded * 1e3);
  const std::size_t sliding = slidingEdges(verdict);
  if (sliding == 0) return {GLISSADE_TEXT("certified: %1 (required %2 mm)"), {near, demanded}};
  return {GLISSADE_TEXT("certified: %1 (required %2 mm, %3 of %4 {4|edge|edges} {3|slides|slide})"),
          {near, demanded, sliding, verdict.edges.size()}};
}

Message violatedInWords(const MotionVerdict& verdict, const std::string& body) {
  if (verdict.againstThread) {
    return {GLISSADE_TEXT("violated: on edge %1 the object is in the thread of '%2', and the edge is no turn about "
                          "their axis by the pitch"),
            {verdict.edge, body}};
  }
  return {GLISSADE_TEXT("violated: %1 mm to '%2' on edge %3 at %4 (required %5 mm)"),
          {shortText(verdict.minClearance * 1e3), body, verdict.edge, shortText(verdict.at),
           shortText(verdict.demanded * 1e3)}};
}

Message motionInWords(const MotionVerdict& verdict, const Product& product) {
  const std::string body = bodyName(verdict.nearest, product);
  switch (verdict.status) {
    case Status::Certified: return certifiedInWords(verdict, body);
    case Status::Violated: return violatedInWords(verdict, body);
    case Status::Undecided: return {GLISSADE_TEXT("undecided on edge %1"), {verdict.edge}};
  }
  return {};
}

/// The motion that a thread needs, for a path that does not turn in it.
Message threadInWords(const PathVerdict& verdict, const Question& question) {
  const Nearest& nearest = verdict.motion.verdict.nearest;
  if (!verdict.motion.verdict.againstThread || nearest.body < 0) return {};
  const Body& other = question.product.bodies[static_cast<std::size_t>(nearest.body)];
  const Message words{GLISSADE_TEXT("'%1' and '%2' are a thread, which can only be unscrewed"),
                      {question.object().name, other.name}};
  for (const AppliedAllowance& each : verdict.allowances) {
    if (!each.thread || each.other != other.id) continue;
    if (!each.thread->mayTurn) {
      return {GLISSADE_TEXT("%1: '%2' is unscrewed, and has to be removed first"), {words, other.name}};
    }
    return {GLISSADE_TEXT("%1: each turn about its axis advances by %2"), {words, Length{each.thread->pitch}}};
  }
  return words;
}

Report edgeJson(const EdgeVerdict& edge, const Product& product) {
  Report json{{"status", kStatusNames.of(edge.status)},
              {"required_m", edge.demand.clearance},
              {"sliding", edge.demand.sliding},
              {"proved_clearance_m", finite(edge.provedClearance)},
              {"min_clearance_m", finite(edge.minClearance)},
              {"at", edge.at},
              {"body", bodyName(edge.nearest, product)}};
  if (edge.nearest.body >= 0 && edge.nearest.distance > 0.0) {
    json["on_body"] = toJson(edge.nearest.onBody);
    json["on_object"] = toJson(edge.nearest.onMoving);
  }
  return json;
}

Report allowancesJson(const std::vector<AppliedAllowance>& allowances) {
  Report list = Report::array();
  for (const AppliedAllowance& each : allowances) {
    const Evidence& evidence = each.evidence;
    Report json{{"moving", each.moving.text()},   {"body", each.other.text()},
                {"yields", each.yields},          {"stated_m", each.stated ? Report(*each.stated) : Report(nullptr)},
                {"allowance_m", each.applied},    {"at_most_m", each.most},
                {"overlap_m", evidence.overlap},  {"deflection_m", evidence.deflection},
                {"spacing_m", evidence.spacing},  {"margin_m", evidence.margin},
                {"text", toString(inWords(each))}};
    if (evidence.byPerson > 0.0) json["by_person_m"] = evidence.byPerson;
    if (each.core) json["core"] = true;
    if (each.hollow) json["hollow"] = true;
    if (each.screwHole) json["screw_hole"] = true;
    if (each.thread) {
      json["thread"] = {{"point_m", toJson(each.thread->point)},
                        {"direction", toJson(each.thread->axis)},
                        {"pitch_m", each.thread->pitch},
                        {"radius_moving_m", each.thread->radiusMoving},
                        {"radius_other_m", each.thread->radiusOther}};
    }
    list.push_back(std::move(json));
  }
  return list;
}

Message edgeInWords(std::size_t number, const EdgeVerdict& edge, const Product& product) {
  const std::string body = bodyName(edge.nearest, product);
  const Message clearance{
      body.empty() ? GLISSADE_TEXT("clearance %1 to %2 mm") : GLISSADE_TEXT("clearance %1 to %2 mm to '%3'"),
      {shortText(edge.provedClearance * 1e3), shortText(edge.minClearance * 1e3), body}};
  switch (edge.status) {
    case Status::Certified: return {GLISSADE_TEXT("  edge %1: certified, %2"), {number, clearance}};
    case Status::Violated: return {GLISSADE_TEXT("  edge %1: violated, %2"), {number, clearance}};
    case Status::Undecided: return {GLISSADE_TEXT("  edge %1: undecided, %2"), {number, clearance}};
  }
  return {};
}

void addEdges(const MotionVerdict& verdict, const Product& product, std::vector<Message>& lines) {
  for (std::size_t i = 0; i < verdict.edges.size(); ++i) {
    const Message line = edgeInWords(i, verdict.edges[i], product);
    lines.push_back(verdict.edges[i].demand.sliding ? Message{GLISSADE_TEXT("%1, slides"), {line}} : line);
  }
}

Message placesInWords(const std::vector<ForbiddenRegion>& regions) {
  std::vector<std::string> places;
  for (const ForbiddenRegion& region : regions) places.push_back(region.place);
  return namesInWords(places);
}

Report textsOf(const std::vector<Message>& messages) {
  Report texts = Report::array();
  for (const Message& each : messages) texts.push_back(toString(each));
  return texts;
}

/// Each message on a line.
std::string textOf(const std::vector<Message>& lines, const MessageStyle& style) {
  std::string text;
  for (const Message& line : lines) text += toString(line, style) + "\n";
  return text;
}

Report overlapsJson(const std::vector<PlainOverlap>& overlaps) {
  Report list = Report::array();
  for (const PlainOverlap& each : overlaps)
    list.push_back({{"a", each.one}, {"b", each.other}, {"overlap_m", each.depth}});
  return list;
}

std::vector<PlainOverlap> plainOverlapsOf(const PlanVerdict& verdict) {
  std::vector<PlainOverlap> overlaps;
  for (const StepVerdict& step : verdict.steps) addPlainOverlaps(step.allowances, overlaps);
  for (const LineVerdict& line : verdict.lines) {
    for (const StepVerdict& step : line.steps) addPlainOverlaps(step.allowances, overlaps);
  }
  return overlaps;
}

/// `body`: the text after the outcome.
Message validInWords(const Product& product, const Message& body) {
  return {product.missing.empty() ? GLISSADE_TEXT("valid: %1")
                                  : GLISSADE_TEXT("valid without shapes that the files state: %1"),
          {body}};
}

Message headlineOf(const PathVerdict& verdict, const Product& product, const Message& body) {
  if (verdict.valid()) return validInWords(product, body);
  if (verdict.refused()) return {GLISSADE_TEXT("invalid: %1"), {body}};
  return {GLISSADE_TEXT("undecided: %1"), {body}};
}

/// The first line of the report.
Message headlineOf(const PathVerdict& verdict, const Question& question) {
  Message body{GLISSADE_TEXT("%1 {1|configuration|configurations}, %2"),
               {verdict.configurations, motionInWords(verdict.motion.verdict, question.product)}};
  for (const Message& why : {verdict.motion.why, threadInWords(verdict, question)}) {
    if (!why.empty()) body = {GLISSADE_TEXT("%1: %2"), {body, why}};
  }
  return headlineOf(verdict, question.product, body);
}

void addForbidden(const PathVerdict& verdict, const Question& question, std::vector<Message>& lines) {
  const Length margin{verdict.forbiddenMargin};
  if (verdict.forbidden) {
    lines.push_back({GLISSADE_TEXT("edge %1 meets the forbidden place '%2', or its margin of %3"),
                     {verdict.forbidden->edge, verdict.forbidden->place, margin}});
  } else if (verdict.forbiddenMargin > 0.0) {
    lines.push_back(
        {GLISSADE_TEXT("forbidden places: the path keeps %1 from %2"), {margin, placesInWords(question.forbidden)}});
  }
}

}  // namespace

std::string reportText(const PathVerdict& verdict, const Question& question, bool edges, const MessageStyle& style) {
  const Product& product = question.product;
  std::vector<Message> lines{headlineOf(verdict, question)};
  for (const AppliedAllowance& each : verdict.allowances) {
    lines.push_back({GLISSADE_TEXT("allowance: %1"), {inWords(each)}});
  }
  for (const Message& refusal : verdict.refusals) lines.push_back({GLISSADE_TEXT("refused: %1"), {refusal}});
  lines.insert(lines.end(), verdict.pulls.begin(), verdict.pulls.end());
  std::vector<PlainOverlap> overlaps;
  addPlainOverlaps(verdict.allowances, overlaps);
  if (!overlaps.empty()) lines.push_back(inWords(overlaps));
  addForbidden(verdict, question, lines);
  if (!product.missing.empty()) lines.push_back(statementOf(product.missing));
  if (verdict.deviation > 0.0) {
    lines.push_back({GLISSADE_TEXT("CAD accuracy of the certificate: +/- %1"), {Length{verdict.deviation}}});
  }
  if (verdict.spacing > 0.0) {
    lines.push_back({GLISSADE_TEXT("coordinate spacing: mesh files hold 32-bit numbers or were closed at T-junctions, "
                                   "so that bodies may be %1 mm nearer"),
                     {shortText(verdict.spacing * 1e3)}});
  }
  if (edges) addEdges(verdict.motion.verdict, product, lines);
  if (!verdict.beginsAtStart) lines.push_back(GLISSADE_TEXT("the path does not begin at the scenario's start"));
  if (!verdict.endsAtGoal) lines.push_back(GLISSADE_TEXT("the path does not end at the scenario's goal"));
  return textOf(lines, style);
}

Report reportJson(const PathVerdict& verdict, const Question& question, bool edges) {
  const Product& product = question.product;
  const MotionVerdict& motion = verdict.motion.verdict;
  Report certificate{{"status", kStatusNames.of(motion.status)},
                     {"min_clearance_m", finite(motion.minClearance)},
                     {"proved_clearance_m", finite(motion.provedClearance)},
                     {"tolerance_m", motion.demanded},
                     {"edge", motion.edge},
                     {"at", motion.at},
                     {"body", bodyName(motion.nearest, product)},
                     {"sliding_edges", slidingEdges(motion)},
                     {"distance_queries", motion.distances}};
  if (motion.againstThread) certificate["against_thread"] = true;
  if (edges) certificate["edges"] = Report::array();
  for (std::size_t i = 0; edges && i < motion.edges.size(); ++i) {
    certificate["edges"].push_back(edgeJson(motion.edges[i], product));
  }
  if (!verdict.motion.why.empty()) certificate["why_undecided"] = toString(verdict.motion.why);
  if (const Message why = threadInWords(verdict, question); !why.empty()) certificate["why_refused"] = toString(why);
  certificate["surface_deviation_m"] = verdict.deviation;
  certificate["coordinate_spacing_m"] = verdict.spacing;
  if (!verdict.allowances.empty()) certificate["allowances"] = allowancesJson(verdict.allowances);
  std::vector<PlainOverlap> overlaps;
  addPlainOverlaps(verdict.allowances, overlaps);
  if (!overlaps.empty()) certificate["plain_overlaps"] = overlapsJson(overlaps);
  Report report{{"valid", verdict.valid()},
                {"configurations", verdict.configurations},
                {"begins_at_start", verdict.beginsAtStart},
                {"ends_at_goal", verdict.endsAtGoal},
                {"outside_workspace", verdict.outside ? Report(*verdict.outside) : Report(nullptr)}};
  if (verdict.forbiddenMargin > 0.0) report["forbidden_margin_m"] = verdict.forbiddenMargin;
  if (verdict.forbidden) {
    report["forbidden"] = {{"edge", verdict.forbidden->edge}, {"place", verdict.forbidden->place}};
  }
  report["refusals"] = textsOf(verdict.refusals);
  if (!verdict.pulls.empty()) report["pulled_threads"] = textsOf(verdict.pulls);
  report["missing_shapes"] = missingShapesJson(product.missing);
  report["certificate"] = std::move(certificate);
  return report;
}

namespace {

/// How the motion of a step fails. `body`: the nearest other body; empty: there is none.
Message failureInWords(const MotionVerdict& motion, const std::string& body) {
  if (motion.againstThread) {
    return {GLISSADE_TEXT("does not turn on edge %1 in the thread it has with '%2'"), {motion.edge, body}};
  }
  const bool isViolated = motion.status == Status::Violated;
  if (body.empty()) {
    return {isViolated ? GLISSADE_TEXT("does not keep its clearance on edge %1")
                       : GLISSADE_TEXT("its motion is undecided on edge %1"),
            {motion.edge}};
  }
  if (!isViolated) return {GLISSADE_TEXT("its motion is undecided on edge %1 by '%2'"), {motion.edge, body}};
  if (motion.minClearance <= 0.0) return {GLISSADE_TEXT("penetrates '%2' on edge %1"), {motion.edge, body}};
  return {GLISSADE_TEXT("comes within %3 of '%2' on edge %1; the required clearance is %4"),
          {motion.edge, body, Length{motion.minClearance}, Length{motion.demanded}}};
}

}  // namespace

Message whyInvalid(const StepVerdict& step, const Product& product) {
  if (step.valid()) return {};
  std::vector<Message> reasons;
  if (!step.certified() && !step.isFlexible) {
    const Message& why = step.motion.why;
    const Message failure = failureInWords(step.motion.verdict, bodyName(step.motion.verdict.nearest, product));
    reasons.push_back(why.empty() ? failure : Message{GLISSADE_TEXT("%1: %2"), {failure, why}});
  }
  if (!step.endsOutside) reasons.push_back(GLISSADE_TEXT("it does not end outside of the others' bounding box"));
  if (!step.againstDemand.empty()) reasons.push_back(step.againstDemand);
  reasons.insert(reasons.end(), step.refusals.begin(), step.refusals.end());
  return joined(reasons, "; ");
}

Message whyInvalid(const PlanVerdict& verdict, std::size_t step, const Product& product) {
  std::vector<Message> reasons;
  for (const StepVerdict& each : verdict.steps) {
    if (each.number == step && !each.valid()) reasons.push_back(whyInvalid(each, product));
  }
  return reasons.empty() ? Message() : joined(reasons, "; ");
}

namespace {

/// How the steps of a plan or of a line are reported.
struct StepsReport {
  const Product& product;
  bool isTrusted = false;
  std::set<BodyId> left{};  ///< ids of the bodies of earlier steps
};

/// `number`: see numberOf(). Allowances against bodies that have left count in other orders only.
void addStep(const StepVerdict& step, const Message& number, StepsReport& report, std::vector<Message>& lines) {
  const auto& [product, isTrusted, left] = report;
  const std::string body = step.bodies.empty() ? "" : product.nameOf(step.bodies.front());
  for (const AppliedAllowance& each : step.allowances) {
    if (left.count(each.other) != 0) continue;
    lines.push_back({GLISSADE_TEXT("step %1: allowance: %2"), {number, inWords(each)}});
  }
  for (const auto* notes : {&step.pulls, &step.notes}) {
    for (const Message& each : *notes) lines.push_back({GLISSADE_TEXT("step %1: note: %2"), {number, each}});
  }
  for (const Condition& each : step.conditions) {
    lines.push_back(
        {isTrusted ? GLISSADE_TEXT("step %1 (%2): as the plan says: %3") : GLISSADE_TEXT("step %1 (%2): only if %3"),
         {number, body, each.text}});
  }
  if (step.isFlexible) {
    lines.push_back({GLISSADE_TEXT("step %1 (%2): its motion has no certificate, it is flexible"), {number, body}});
  }
  if (!step.valid()) {
    lines.push_back({step.refused() ? GLISSADE_TEXT("step %1 (%2) is invalid: %3;")
                                    : GLISSADE_TEXT("step %1 (%2) is undecided: %3;"),
                     {number, body, whyInvalid(step, product)}});
  }
}

/// "3.1", or "3.1, motion 2" in a step of several motions. `steps`: number of steps of the list; `group`: see
/// stepNumber().
Message numberOf(const StepVerdict& step, std::size_t steps, const std::string& group) {
  const std::string number = stepNumber(step.number - 1, steps, group);
  if (step.motionNumber == 0) return Message(number);
  return {GLISSADE_TEXT("%1, motion %2"), {number, step.motionNumber}};
}

/// How many steps are proved; how many parts leave, in which way, and how many have no step.
Message countsInWords(const PlanVerdict& verdict) {
  const Message parts{GLISSADE_TEXT("%1 of %2 {2|part|parts} {1|has|have} no step, %3 {3|is|are} removed alone, %4 as "
                                    "units, %5 in groups that are not disassembled"),
                      {verdict.remaining, verdict.parts, verdict.alone, verdict.asUnits, verdict.inGroups}};
  return {verdict.stepsWithoutProof() == 0 ? GLISSADE_TEXT("%1 of %2 {2|step|steps} {1|is|are} certified, %3")
                                           : GLISSADE_TEXT("%1 of %2 {2|step|steps} {1|is|are} as stated, %3"),
          {verdict.validSteps(), stepsIn(verdict.steps), parts}};
}

Message headlineOf(const PlanVerdict& verdict, const Product& product) {
  const Message counts = countsInWords(verdict);
  switch (verdict.outcome()) {
    case PlanOutcome::Valid: return validInWords(product, counts);
    case PlanOutcome::Incomplete: return {GLISSADE_TEXT("incomplete: %1"), {counts}};
    case PlanOutcome::Undecided: return {GLISSADE_TEXT("undecided: %1"), {counts}};
    case PlanOutcome::Invalid: return {GLISSADE_TEXT("invalid: %1"), {counts}};
    case PlanOutcome::Conditional: break;
  }
  const std::vector<Condition> conditions = verdict.allConditions();
  if (conditions.size() == 1) {
    return {GLISSADE_TEXT("valid only if %1: %2"), {conditions.front().text, counts}};
  }
  return {GLISSADE_TEXT("valid only under %1 {1|condition|conditions} that the plan states itself: %2"),
          {conditions.size(), counts}};
}

/// Adds the conditions that a person has to confirm, each once.
void addConditions(const PlanVerdict& verdict, std::vector<Message>& lines) {
  const std::vector<Condition> conditions = verdict.allConditions();
  if (conditions.empty() || verdict.planIsTrusted) return;
  for (const Condition& each : conditions) lines.push_back({GLISSADE_TEXT("condition: %1"), {each.text}});
  lines.push_back(GLISSADE_TEXT(
      "Only the plan states this. State the conditions in the scenario, or trust the plan (--trust-plan)."));
}

/// Number of screws that leave holes which the file does not have.
std::size_t screwHoles(const PlanVerdict& verdict) {
  std::size_t holes = 0;
  const auto count = [&](const std::vector<StepVerdict>& steps) {
    for (const StepVerdict& step : steps) {
      holes += static_cast<std::size_t>(std::count_if(step.allowances.begin(), step.allowances.end(),
                                                      [](const AppliedAllowance& each) { return each.screwHole; }));
    }
  };
  count(verdict.steps);
  for (const LineVerdict& line : verdict.lines) count(line.steps);
  return holes;
}

void addSteps(const std::vector<StepVerdict>& steps, const std::string& group, StepsReport report,
              std::vector<Message>& lines) {
  for (const StepVerdict& step : steps) {
    addStep(step, numberOf(step, stepsIn(steps), group), report, lines);
    report.left.insert(step.bodies.begin(), step.bodies.end());
  }
}

void addSteps(const PlanVerdict& verdict, const Product& product, std::vector<Message>& lines) {
  addSteps(verdict.steps, "", {product, verdict.planIsTrusted}, lines);
  for (const LineVerdict& line : verdict.lines) {
    addSteps(line.steps, line.group, {product, verdict.planIsTrusted}, lines);
    for (const Message& refusal : line.refusals) {
      lines.push_back({GLISSADE_TEXT("refused: the line of step %1: %2"), {line.group, refusal}});
    }
  }
}

}  // namespace

std::string reportText(const PlanVerdict& verdict, const Product& product, const MessageStyle& style) {
  std::vector<Message> lines;
  addSteps(verdict, product, lines);
  for (const Message& refusal : verdict.refusals) lines.push_back({GLISSADE_TEXT("refused: %1"), {refusal}});
  lines.push_back(headlineOf(verdict, product));
  addConditions(verdict, lines);
  if (verdict.stepsWithoutProof() > 0) {
    lines.push_back({GLISSADE_TEXT("%1 {1|step of a flexible body has|steps of flexible bodies have} no certificate"),
                     {verdict.stepsWithoutProof()}});
  }
  if (!product.missing.empty()) lines.push_back(statementOf(product.missing));
  if (const std::size_t holes = screwHoles(verdict); holes > 0) {
    lines.push_back(
        {GLISSADE_TEXT("screws in bodies without a tapped hole in the file, each of which makes its own: %1"),
         {holes}});
  }
  if (const auto overlaps = plainOverlapsOf(verdict); !overlaps.empty()) lines.push_back(inWords(overlaps));
  if (verdict.deviation > 0.0) {
    lines.push_back({GLISSADE_TEXT("CAD accuracy of the certificates: +/- %1"), {Length{verdict.deviation}}});
  }
  return textOf(lines, style);
}

namespace {

Report conditionsJson(const std::vector<Condition>& conditions) {
  Report list = Report::array();
  for (const Condition& each : conditions) {
    list.push_back({{"text", toString(each.text)}});
    if (each.acceptedClash > 0.0) list.back()["accept_clashes_m"] = each.acceptedClash;
    if (!each.cut.empty()) list.back()["cut"] = each.cut;
  }
  return list;
}

Report stepsJson(const std::vector<StepVerdict>& steps, const std::string& group, const Product& product) {
  Report report = Report::array();
  for (const StepVerdict& step : steps) {
    const MotionVerdict& motion = step.motion.verdict;
    const int nearest = motion.nearest.body;
    report.push_back({{"number", stepNumber(step.number - 1, stepsIn(steps), group)},
                      {"body", step.bodies.empty() ? "" : step.bodies.front().text()},
                      {"valid", step.valid()},
                      {"certified", step.certified()},
                      {"against_thread", motion.againstThread},
                      {"ends_outside", step.endsOutside},
                      {"against_demand", toString(step.againstDemand)},
                      {"refusals", textsOf(step.refusals)},
                      {"min_clearance_m", finite(motion.minClearance)},
                      {"proved_clearance_m", finite(motion.provedClearance)},
                      {"nearest", nearest < 0 ? Report(nullptr)
                                              : Report(product.bodies[static_cast<std::size_t>(nearest)].id.text())},
                      {"allowances", allowancesJson(step.allowances)}});
    if (step.motionNumber > 0) report.back()["motion"] = step.motionNumber;
    if (step.isFlexible) report.back()["flexible"] = true;
    if (!step.pulls.empty()) report.back()["pulls"] = textsOf(step.pulls);
    if (!step.notes.empty()) report.back()["notes"] = textsOf(step.notes);
    if (!step.conditions.empty()) report.back()["conditions"] = conditionsJson(step.conditions);
  }
  return report;
}

}  // namespace

Report reportJson(const PlanVerdict& verdict, const Product& product) {
  const PlanOutcome outcome = verdict.outcome();
  Report report{{"valid", outcome == PlanOutcome::Valid},
                {"verdict", kOutcomeNames.of(outcome)},
                {"complete", verdict.remaining == 0 && verdict.inGroups == 0 && verdict.parts > 0},
                {"parts", verdict.parts},
                {"parts_without_step", verdict.remaining},
                {"parts_alone", verdict.alone},
                {"parts_as_units", verdict.asUnits},
                {"parts_in_groups", verdict.inGroups},
                {"steps_valid", verdict.validSteps()},
                {"steps_without_proof", verdict.stepsWithoutProof()},
                {"conditions", conditionsJson(verdict.allConditions())},
                {"plan_is_trusted", verdict.planIsTrusted},
                {"screw_holes", screwHoles(verdict)},
                {"refusals", textsOf(verdict.refusals)},
                {"steps", stepsJson(verdict.steps, "", product)}};
  for (const LineVerdict& line : verdict.lines) {
    report["lines"].push_back({{"line", line.line},
                               {"valid", line.valid()},
                               {"refusals", textsOf(line.refusals)},
                               {"steps", stepsJson(line.steps, line.group, product)}});
  }
  if (const auto overlaps = plainOverlapsOf(verdict); !overlaps.empty()) {
    report["plain_overlaps"] = overlapsJson(overlaps);
  }
  report["surface_deviation_m"] = verdict.deviation;
  report["missing_shapes"] = missingShapesJson(product.missing);
  return report;
}

}  // namespace glissade::check
