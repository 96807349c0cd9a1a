#include "engine/check/verdict_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/enum_names.h"
#include "engine/base/quantity_text.h"
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

std::string motionInWords(const MotionVerdict& verdict, const Product& product) {
  std::ostringstream text;
  const std::string body = bodyName(verdict.nearest, product);
  switch (verdict.status) {
    case Status::Certified:
      text << "certified: ";
      if (body.empty()) {
        text << "nothing near";
      } else {
        text << "clearance " << verdict.minClearance * 1e3 << " mm to '" << body << "'";
      }
      text << " (required " << verdict.demanded * 1e3 << " mm";
      if (const std::size_t sliding = slidingEdges(verdict); sliding > 0) {
        text << ", " << sliding << " of " << verdict.edges.size() << " edges slide";
      }
      text << ")";
      break;
    case Status::Violated:
      if (verdict.againstThread) {
        text << "violated: on edge " << verdict.edge << " the object is in the thread of '" << body
             << "', and the edge is no turn about their axis by the pitch";
        break;
      }
      text << "violated: " << verdict.minClearance * 1e3 << " mm to '" << body << "' on edge " << verdict.edge << " at "
           << verdict.at << " (required " << verdict.demanded * 1e3 << " mm)";
      break;
    case Status::Undecided: text << "undecided on edge " << verdict.edge; break;
  }
  return text.str();
}

/// The motion that a thread needs, for a path that does not turn in it.
std::string threadInWords(const PathVerdict& verdict, const Question& question) {
  const Nearest& nearest = verdict.motion.verdict.nearest;
  if (!verdict.motion.verdict.againstThread || nearest.body < 0) return {};
  const Body& other = question.product.bodies[static_cast<std::size_t>(nearest.body)];
  std::string words =
      pairInWords(question.object().name, other.name) + " are a thread, which comes apart by turning only";
  for (const AppliedAllowance& each : verdict.allowances) {
    if (!each.thread || each.other != other.id) continue;
    return words + (each.thread->mayTurn ? ": each turn about its axis advances by " + inMillimetres(each.thread->pitch)
                                         : ": '" + other.name + "' is turned, and has to leave first");
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
    Report json{{"moving", each.moving},         {"body", each.other},
                {"yields", each.yields},         {"stated_m", each.stated ? Report(*each.stated) : Report(nullptr)},
                {"allowance_m", each.applied},   {"at_most_m", each.most},
                {"overlap_m", evidence.overlap}, {"deflection_m", evidence.deflection},
                {"spacing_m", evidence.spacing}, {"margin_m", evidence.margin},
                {"text", inWords(each)}};
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

std::string triangleWords(double deviation) {
  if (deviation <= 0.0) return {};
  std::ostringstream text;
  text << "the certificate is about triangles, which are within +/- " << inMillimetres(deviation)
       << " of the CAD surfaces\n";
  return text.str();
}

std::string missingWords(const MissingShapes& missing) {
  return missing.empty() ? std::string() : statementOf(missing) + "\n";
}

void addEdges(const MotionVerdict& verdict, const Product& product, std::ostringstream& text) {
  for (std::size_t i = 0; i < verdict.edges.size(); ++i) {
    const EdgeVerdict& edge = verdict.edges[i];
    text << "  edge " << i << ": " << kStatusNames.of(edge.status) << ", clearance " << edge.provedClearance * 1e3
         << " to " << edge.minClearance * 1e3 << " mm";
    if (edge.nearest.body >= 0) text << " to '" << bodyName(edge.nearest, product) << "'";
    text << (edge.demand.sliding ? ", slides\n" : "\n");
  }
}

/// The name for people of the body with the id.
std::string shownName(const std::string& id, const Product& product) {
  for (const Body& body : product.bodies) {
    if (body.id == id) return body.name;
  }
  return id;
}

std::string placesInWords(const std::vector<ForbiddenRegion>& regions) {
  std::string words;
  for (const ForbiddenRegion& region : regions) words += (words.empty() ? "'" : ", '") + region.place + "'";
  return words;
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

const char* validWords(const Product& product) {
  return product.missing.empty() ? "valid: " : "valid without shapes that the files state: ";
}

std::string headlineOf(const PathVerdict& verdict, const Product& product) {
  if (verdict.valid()) return validWords(product);
  return verdict.refused() ? "invalid: " : "undecided: ";
}

}  // namespace

std::string reportText(const PathVerdict& verdict, const Question& question, bool edges) {
  const Product& product = question.product;
  const MotionVerdict& motion = verdict.motion.verdict;
  std::ostringstream text;
  const std::string thread = threadInWords(verdict, question);
  text << headlineOf(verdict, product) << verdict.configurations << " configurations, "
       << motionInWords(motion, product);
  for (const std::string& why : {verdict.motion.why, thread}) text << (why.empty() ? "" : ": ") << why;
  text << "\n";
  for (const AppliedAllowance& each : verdict.allowances) text << "allowance: " << inWords(each) << "\n";
  for (const std::string& refusal : verdict.refusals) text << "refused: " << refusal << "\n";
  std::vector<PlainOverlap> overlaps;
  addPlainOverlaps(verdict.allowances, overlaps);
  if (!overlaps.empty()) text << inWords(overlaps) << "\n";
  if (verdict.forbidden) {
    text << "edge " << verdict.forbidden->edge << " meets the place '" << verdict.forbidden->place
         << "', which a person forbids, or its margin of " << inMillimetres(verdict.forbiddenMargin) << "\n";
  } else if (verdict.forbiddenMargin > 0.0) {
    text << "forbidden places: the path keeps " << inMillimetres(verdict.forbiddenMargin) << " from "
         << placesInWords(question.forbidden) << "\n";
  }
  text << missingWords(product.missing) << triangleWords(verdict.deviation);
  if (verdict.spacing > 0.0) {
    text << "coordinate spacing: mesh files hold 32-bit numbers or were closed at T-junctions, so that bodies may be "
         << verdict.spacing * 1e3 << " mm nearer\n";
  }
  if (edges) addEdges(motion, product, text);
  if (!verdict.beginsAtStart) text << "the path does not begin at the scenario's start\n";
  if (!verdict.endsAtGoal) text << "the path does not end at the scenario's goal\n";
  return text.str();
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
  if (!verdict.motion.why.empty()) certificate["why_undecided"] = verdict.motion.why;
  if (const std::string why = threadInWords(verdict, question); !why.empty()) certificate["why_refused"] = why;
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
  report["refusals"] = verdict.refusals;
  report["missing_shapes"] = missingShapesJson(product.missing);
  report["certificate"] = std::move(certificate);
  return report;
}

std::string whyInvalid(const StepVerdict& step, const Product& product) {
  if (step.valid()) return {};
  std::ostringstream text;
  const MotionVerdict& motion = step.motion.verdict;
  if (!step.certified() && !step.isFlexible) {
    const std::string body = bodyName(motion.nearest, product);
    text << " its motion is " << kStatusNames.of(motion.status) << " on edge " << motion.edge;
    if (motion.againstThread) text << ", because it is no turn in the thread it has with";
    if (!body.empty()) text << (motion.againstThread ? " '" : " by '") << body << "'";
    text << (step.motion.why.empty() ? "" : ": ") << step.motion.why << ";";
  }
  if (!step.endsOutside) text << " it does not end outside of the others' bounding box;";
  if (!step.againstDemand.empty()) text << " " << step.againstDemand << ";";
  for (const std::string& refusal : step.refusals) text << " " << refusal << ";";
  return text.str();
}

/// `name`: name of the step, as "step 3".
void addStep(const StepVerdict& step, const std::string& name, bool isTrusted, const Product& product,
             std::ostream& text) {
  const std::string body = step.bodies.empty() ? "" : shownName(step.bodies.front(), product);
  for (const AppliedAllowance& each : step.allowances) text << name << ": allowance: " << inWords(each) << "\n";
  for (const std::string& each : step.pulls) text << name << ": note: " << each << "\n";
  for (const std::string& each : step.notes) text << name << ": note: " << each << "\n";
  for (const Condition& each : step.conditions) {
    text << name << " (" << body << ")" << (isTrusted ? ": as the plan says: " : ": only if ") << each.text << "\n";
  }
  if (step.isFlexible) text << name << " (" << body << "): nothing is proved of its motion, it is flexible\n";
  if (!step.valid()) {
    text << name << " (" << body << ") is " << (step.refused() ? "invalid:" : "undecided:") << whyInvalid(step, product)
         << "\n";
  }
}

/// How many parts leave, in which way, and how many have no step.
std::string partsInWords(const PlanVerdict& verdict) {
  std::ostringstream text;
  text << verdict.remaining << " of " << verdict.parts << " parts have no step, " << verdict.alone << " leave alone, "
       << verdict.asUnits << " as units, " << verdict.inGroups << " in groups that are not taken apart";
  return text.str();
}

std::string headlineOf(const PlanVerdict& verdict, const Product& product) {
  const PlanOutcome outcome = verdict.outcome();
  if (outcome == PlanOutcome::Valid) return validWords(product);
  if (outcome != PlanOutcome::Conditional) return std::string(kOutcomeNames.of(outcome)) + ": ";
  const std::vector<Condition> conditions = verdict.allConditions();
  if (conditions.size() == 1) return "valid only if " + conditions.front().text + ": ";
  return "valid only under " + std::to_string(conditions.size()) + " conditions that the plan states itself: ";
}

/// Writes the conditions that a person has to confirm, each once.
void addConditions(const PlanVerdict& verdict, std::ostream& text) {
  const std::vector<Condition> conditions = verdict.allConditions();
  if (conditions.empty() || verdict.planIsTrusted) return;
  for (const Condition& each : conditions) text << "condition: " << each.text << "\n";
  text << "Nobody but the plan says so. State the conditions in the scenario, or trust the plan (--trust-plan).\n";
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

std::string reportText(const PlanVerdict& verdict, const Product& product) {
  std::ostringstream text;
  const bool isTrusted = verdict.planIsTrusted;
  for (std::size_t i = 0; i < verdict.steps.size(); ++i) {
    addStep(verdict.steps[i], "step " + stepNumber(i, verdict.steps.size()), isTrusted, product, text);
  }
  for (const LineVerdict& line : verdict.lines) {
    for (std::size_t i = 0; i < line.steps.size(); ++i) {
      addStep(line.steps[i], "step " + stepNumber(i, line.steps.size(), line.group), isTrusted, product, text);
    }
    for (const std::string& refusal : line.refusals) {
      text << "refused: the line of step " << line.group << ": " << refusal << "\n";
    }
  }
  for (const std::string& refusal : verdict.refusals) text << "refused: " << refusal << "\n";
  text << headlineOf(verdict, product) << verdict.validSteps() << " of " << verdict.steps.size() << " steps are "
       << (verdict.stepsWithoutProof() == 0 ? "certified" : "as stated") << ", " << partsInWords(verdict) << "\n";
  addConditions(verdict, text);
  if (verdict.stepsWithoutProof() > 0) {
    text << verdict.stepsWithoutProof() << " steps of flexible bodies have no proof\n";
  }
  text << missingWords(product.missing);
  if (const std::size_t holes = screwHoles(verdict); holes > 0) {
    text << "screws in bodies without a hole in the file, each of which makes its own: " << holes << "\n";
  }
  if (const auto overlaps = plainOverlapsOf(verdict); !overlaps.empty()) text << inWords(overlaps) << "\n";
  if (verdict.deviation > 0.0) {
    text << "the certificates are about triangles, which are within +/- " << inMillimetres(verdict.deviation)
         << " of the CAD surfaces\n";
  }
  return text.str();
}

Report conditionsJson(const std::vector<Condition>& conditions) {
  Report list = Report::array();
  for (const Condition& each : conditions) {
    list.push_back({{"text", each.text}});
    if (each.acceptedClash > 0.0) list.back()["accept_clashes_m"] = each.acceptedClash;
  }
  return list;
}

Report stepsJson(const std::vector<StepVerdict>& steps, const std::string& group, const Product& product) {
  Report report = Report::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepVerdict& step = steps[i];
    const MotionVerdict& motion = step.motion.verdict;
    const int nearest = motion.nearest.body;
    report.push_back(
        {{"number", stepNumber(i, steps.size(), group)},
         {"body", step.bodies.empty() ? "" : step.bodies.front()},
         {"valid", step.valid()},
         {"certified", step.certified()},
         {"against_thread", motion.againstThread},
         {"ends_outside", step.endsOutside},
         {"against_demand", step.againstDemand},
         {"refusals", step.refusals},
         {"min_clearance_m", finite(motion.minClearance)},
         {"proved_clearance_m", finite(motion.provedClearance)},
         {"nearest", nearest < 0 ? Report(nullptr) : Report(product.bodies[static_cast<std::size_t>(nearest)].id)},
         {"allowances", allowancesJson(step.allowances)}});
    if (step.isFlexible) report.back()["flexible"] = true;
    if (!step.pulls.empty()) report.back()["pulls"] = step.pulls;
    if (!step.notes.empty()) report.back()["notes"] = step.notes;
    if (!step.conditions.empty()) report.back()["conditions"] = conditionsJson(step.conditions);
  }
  return report;
}

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
                {"refusals", verdict.refusals},
                {"steps", stepsJson(verdict.steps, "", product)}};
  for (const LineVerdict& line : verdict.lines) {
    report["lines"].push_back({{"line", line.line},
                               {"valid", line.valid()},
                               {"refusals", line.refusals},
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
