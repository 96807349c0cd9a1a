#include "engine/check/verdict_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/quantity_text.h"
#include "engine/check/verdict_words.h"
#include "engine/import/json_reader.h"

namespace glissade::check {
namespace {

using Report = nlohmann::ordered_json;

Report finite(double value) { return std::isfinite(value) ? Report(value) : Report(nullptr); }

const char* nameOf(Status status) {
  switch (status) {
    case Status::Certified: return "certified";
    case Status::Violated: return "violated";
    case Status::Undecided: return "undecided";
  }
  return "";
}

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

/// What a thread asks of a path that does not turn in it.
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
  Report json{{"status", nameOf(edge.status)},
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

void addEdges(const MotionVerdict& verdict, const Product& product, std::ostringstream& text) {
  for (std::size_t i = 0; i < verdict.edges.size(); ++i) {
    const EdgeVerdict& edge = verdict.edges[i];
    text << "  edge " << i << ": " << nameOf(edge.status) << ", clearance " << edge.provedClearance * 1e3 << " to "
         << edge.minClearance * 1e3 << " mm";
    if (edge.nearest.body >= 0) text << " to '" << bodyName(edge.nearest, product) << "'";
    text << (edge.demand.sliding ? ", slides\n" : "\n");
  }
}

/// Of a path or a plan.
template <class Verdict>
const char* headlineOf(const Verdict& verdict) {
  if (verdict.valid()) return "valid: ";
  return verdict.refused() ? "invalid: " : "undecided: ";
}

}  // namespace

std::string reportText(const PathVerdict& verdict, const Question& question, bool edges) {
  const Product& product = question.product;
  const MotionVerdict& motion = verdict.motion.verdict;
  std::ostringstream text;
  const std::string thread = threadInWords(verdict, question);
  text << headlineOf(verdict) << verdict.configurations << " configurations, " << motionInWords(motion, product);
  for (const std::string& why : {verdict.motion.why, thread}) text << (why.empty() ? "" : ": ") << why;
  text << "\n";
  for (const AppliedAllowance& each : verdict.allowances) text << "allowance: " << inWords(each) << "\n";
  for (const std::string& refusal : verdict.refusals) text << "refused: " << refusal << "\n";
  if (verdict.forbidden) {
    text << "edge " << verdict.forbidden->edge << " enters the place '" << verdict.forbidden->place
         << "', which a person forbids\n";
  }
  text << triangleWords(verdict.deviation);
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
  Report certificate{{"status", nameOf(motion.status)},
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
  Report report{{"valid", verdict.valid()},
                {"configurations", verdict.configurations},
                {"begins_at_start", verdict.beginsAtStart},
                {"ends_at_goal", verdict.endsAtGoal},
                {"outside_workspace", verdict.outside ? Report(*verdict.outside) : Report(nullptr)}};
  if (verdict.forbidden) {
    report["forbidden"] = {{"edge", verdict.forbidden->edge}, {"place", verdict.forbidden->place}};
  }
  report["refusals"] = verdict.refusals;
  report["certificate"] = std::move(certificate);
  return report;
}

std::string whyInvalid(const StepVerdict& step, const Product& product) {
  if (step.valid()) return {};
  std::ostringstream text;
  const MotionVerdict& motion = step.motion.verdict;
  if (!step.certified() && !step.isFlexible) {
    const std::string body = bodyName(motion.nearest, product);
    text << " its motion is " << nameOf(motion.status) << " on edge " << motion.edge;
    if (motion.againstThread) text << ", because it is no turn in the thread it has with";
    if (!body.empty()) text << (motion.againstThread ? " '" : " by '") << body << "'";
    text << (step.motion.why.empty() ? "" : ": ") << step.motion.why << ";";
  }
  if (!step.endsOutside) text << " it does not end outside of the others' bounding box;";
  if (!step.againstDemand.empty()) text << " " << step.againstDemand << ";";
  for (const std::string& refusal : step.refusals) text << " " << refusal << ";";
  return text.str();
}

/// `name`: of the step, as "step 3".
void addStep(const StepVerdict& step, const std::string& name, const Product& product, std::ostream& text) {
  const std::string body = step.bodies.empty() ? "" : step.bodies.front();
  for (const AppliedAllowance& each : step.allowances) text << name << ": allowance: " << inWords(each) << "\n";
  for (const std::string& each : step.pulls) text << name << ": note: " << each << "\n";
  if (step.isFlexible) text << name << " (" << body << "): nothing is proved of its motion, it is flexible\n";
  if (!step.valid()) {
    text << name << " (" << body << ") is " << (step.refused() ? "invalid:" : "undecided:") << whyInvalid(step, product)
         << "\n";
  }
}

/// "step 3, then step 1": steps of lines follow the step by which their group has left.
std::string nameOf(const std::vector<std::size_t>& line) {
  std::string name;
  for (const std::size_t step : line) name += "step " + std::to_string(step) + ", then ";
  return name;
}

std::string reportText(const PlanVerdict& verdict, const Product& product) {
  std::ostringstream text;
  for (std::size_t i = 0; i < verdict.steps.size(); ++i) {
    addStep(verdict.steps[i], "step " + std::to_string(i + 1), product, text);
  }
  for (const LineVerdict& line : verdict.lines) {
    const std::string name = nameOf(line.line);
    for (std::size_t i = 0; i < line.steps.size(); ++i) {
      addStep(line.steps[i], name + "step " + std::to_string(i + 1), product, text);
    }
    for (const std::string& refusal : line.refusals) {
      text << "refused: the line of " << name.substr(0, name.rfind(',')) << ": " << refusal << "\n";
    }
  }
  for (const std::string& refusal : verdict.refusals) text << "refused: " << refusal << "\n";
  text << headlineOf(verdict) << verdict.validSteps() << " of " << verdict.steps.size() << " steps are "
       << (verdict.stepsWithoutProof() == 0 ? "certified" : "as stated") << ", " << verdict.remaining << " of "
       << verdict.parts << " parts have no step\n";
  if (verdict.stepsWithoutProof() > 0) {
    text << verdict.stepsWithoutProof() << " steps of flexible bodies have no proof\n";
  }
  if (verdict.deviation > 0.0) {
    text << "the certificates are about triangles, which are within +/- " << inMillimetres(verdict.deviation)
         << " of the CAD surfaces\n";
  }
  return text.str();
}

Report stepsJson(const std::vector<StepVerdict>& steps, const Product& product) {
  Report report = Report::array();
  for (const StepVerdict& step : steps) {
    const MotionVerdict& motion = step.motion.verdict;
    const int nearest = motion.nearest.body;
    report.push_back(
        {{"body", step.bodies.empty() ? "" : step.bodies.front()},
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
  }
  return report;
}

Report reportJson(const PlanVerdict& verdict, const Product& product) {
  Report report{{"valid", verdict.valid()},
                {"complete", verdict.remaining == 0 && verdict.parts > 0},
                {"parts", verdict.parts},
                {"steps_valid", verdict.validSteps()},
                {"steps_without_proof", verdict.stepsWithoutProof()},
                {"refusals", verdict.refusals},
                {"steps", stepsJson(verdict.steps, product)}};
  for (const LineVerdict& line : verdict.lines) {
    report["lines"].push_back({{"line", line.line},
                               {"valid", line.valid()},
                               {"refusals", line.refusals},
                               {"steps", stepsJson(line.steps, product)}});
  }
  report["surface_deviation_m"] = verdict.deviation;
  return report;
}

}  // namespace glissade::check
