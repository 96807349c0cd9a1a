#include "app/cli/run_output.h"

#include <glissade/version.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/cli/report.h"
#include "app/cli/text_cells.h"
#include "engine/base/enum_names.h"
#include "engine/base/file.h"
#include "engine/base/json_reader.h"
#include "engine/base/stop_token.h"
#include "engine/base/whole_percents.h"
#include "engine/collision/thread_rule.h"
#include "engine/files/path_exporter.h"
#include "engine/files/pulled_threads.h"
#include "engine/files/run_record.h"
#include "engine/files/scenario.h"
#include "engine/files/scenario_io.h"
#include "engine/fits/fit_refusals.h"
#include "engine/geometry/pose_json.h"
#include "engine/planning/automatic/straight_ways_out.h"
#include "engine/planning/difficulty/difficulty.h"
#include "engine/planning/screw_motion.h"
#include "engine/session/grown_roadmap.h"
#include "engine/session/session.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string place(const Pose& q) {
  const Vector3& p = q.position;
  return "(" + rounded(p.x()) + ", " + rounded(p.y()) + ", " + rounded(p.z()) + ") m";
}

/// Why the run found no path, from the roadmap that it grew.
Difficulty difficultyOf(const LoadedScenario& scenario, const SessionSnapshot& end, const StopToken& stop) {
  const GrownRoadmap grown = grownRoadmap(end);
  return glissade::difficultyOf(scenario.problem, grown.nodes, grown.edges, end.parameters, end.seed, {}, stop);
}

Json toJson(const Difficulty& difficulty, const CollisionWorld& world) {
  Json json{{"frontier", nullptr}, {"tightest", nullptr}, {"least_penetration", nullptr}};
  if (const auto& frontier = difficulty.frontier) {
    json["frontier"] = {{"distance_m", frontier->distance},
                        {"from_start", glissade::toJson(frontier->fromStart)},
                        {"from_goal", glissade::toJson(frontier->fromGoal)},
                        {"blocked_by", toString(bodyName(world, frontier->body))}};
    if (frontier->body >= 0) json["frontier"]["blocked_at"] = glissade::toJson(frontier->blockedAt);
  }
  if (const auto& tightest = difficulty.tightest) {
    json["tightest"] = {{"clearance_m", tightest->clearance},
                        {"body", toString(bodyName(world, tightest->body))},
                        {"configuration", glissade::toJson(tightest->q)}};
  }
  if (const auto& least = difficulty.leastPenetration) {
    Json way = Json::array();
    for (const Pose& q : least->way) way.push_back(glissade::toJson(q));
    json["least_penetration"] = {{"depth_mm", 1e3 * least->depth},
                                 {"body", toString(bodyName(world, least->body))},
                                 {"configuration", glissade::toJson(least->q)},
                                 {"way", way}};
  }
  return json;
}

void printDifficulty(const Difficulty& difficulty, const CollisionWorld& world, const Console& console) {
  if (const auto& frontier = difficulty.frontier) {
    Message text{GLISSADE_TEXT("the trees came within %1 m of each other, from %2 to %3"),
                 {rounded(frontier->distance), place(frontier->fromStart), place(frontier->fromGoal)}};
    if (frontier->body >= 0) {
      text = {GLISSADE_TEXT("%1; between the object and the goal's tree stands '%2', at %3"),
              {text, bodyName(world, frontier->body), place(frontier->blockedAt)}};
    }
    console.print(text);
  }
  if (const auto& tightest = difficulty.tightest) {
    console.print({GLISSADE_TEXT("tightest passage reached: %1 mm to '%2', at %3"),
                   {rounded(1e3 * tightest->clearance), bodyName(world, tightest->body), place(tightest->q)}});
  }
  if (const auto& least = difficulty.leastPenetration) {
    console.print(
        {GLISSADE_TEXT("with %1 mm more room between the object and '%2', at %3, there is a path of %4 configurations"),
         {rounded(1e3 * least->depth), bodyName(world, least->body), place(least->q), least->way.size()}});
  } else {
    console.print(GLISSADE_TEXT("no erosion of the object that was tried opens a path"));
  }
}

CatalogueText status(const SessionSnapshot& end) {
  if (end.state == SessionState::Solved) return GLISSADE_TEXT("solved");
  if (end.state == SessionState::Stopped) return GLISSADE_TEXT("interrupted");
  switch (end.problem ? end.problem->kind : ErrorKind::Internal) {
    case ErrorKind::LimitReached: return GLISSADE_TEXT("limit-reached");
    case ErrorKind::NoPath:
      return end.counts.rejectedPaths > 0 ? GLISSADE_TEXT("not-certified") : GLISSADE_TEXT("no-path");
    case ErrorKind::InCollision: return GLISSADE_TEXT("in-collision");
    case ErrorKind::Usage:
    case ErrorKind::MalformedInput: return GLISSADE_TEXT("malformed");
    default: return GLISSADE_TEXT("error");
  }
}

constexpr EnumNames<StepResult, 4> kStepResultNames{{GLISSADE_TEXT("pending").english, GLISSADE_TEXT("running").english,
                                                     GLISSADE_TEXT("solved").english, GLISSADE_TEXT("failed").english}};

Json toJson(const CoarsePlan& plan) {
  Json steps = Json::array();
  for (const TopologicalStep& step : plan.steps) {
    steps.push_back({{"place", step.placeName},
                     {"to", step.borderName},
                     {"planner", step.planner},
                     {"geometrical", step.geometrical},
                     {"why", toString(step.why)},
                     {"random_configurations", step.randomConfigurations},
                     {"result", kStepResultNames.of(step.result)}});
  }
  return {{"attempt", plan.attempt},
          {"cost", plan.cost},
          {"coarse_configurations", plan.coarseConfigurations},
          {"fine_configurations", plan.fineConfigurations},
          {"steps", steps}};
}

/// {"computer": ..., "operator": ..., "contact": ...}
template <class T>
Json byAuthor(const PerAuthor<T>& values) {
  Json json;
  for (const Author author : {Author::Computer, Author::Operator, Author::Contact}) {
    json[kAuthorNames.of(author)] = values[static_cast<std::size_t>(author)];
  }
  return json;
}

/// The share of each author in the path's metric length.
PerAuthor<double> pathShares(const Path& path, const CollisionWorld& world) {
  PerAuthor<double> shares = path.lengthByAuthor(Se3Metric(world.objectRadius()));
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share = sum > 0.0 ? share / sum : 0.0;
  return shares;
}

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

/// The settings that a tuner adjusts.
Json toJson(const InteractionSettings& settings, int tuned) {
  Json json;
  for (const ParameterSpec& spec : parameterTable()) {
    if ((tuned & tunedSetting(spec.id)) != 0) json[std::string(spec.key)] = settings[spec.id];
  }
  return json;
}

Json toJson(const HandReport& hand, bool found) {
  Json json{{"shown", hand.shown}, {"in_collision", hand.collided}, {"moved_to_contact", hand.movedToContact}};
  if (found) json.update({{"joined", hand.joined}, {"followed", hand.followed}});
  return json;
}

/// Prints how the configurations that the hand showed were used.
void printHand(const HandReport& hand, bool found, const Console& console) {
  console.print({GLISSADE_TEXT("your hand showed %1 {1|configuration|configurations}; %2 {2|was|were} in collision, %3 "
                               "of these {3|was|were} moved to contact"),
                 {hand.shown, hand.collided, hand.movedToContact}});
  if (!found) return;
  console.print(hand.joined ? GLISSADE_TEXT("your way joined start and goal")
                            : GLISSADE_TEXT("the computer joined start and goal"));
  console.print({GLISSADE_TEXT("the path follows your way for %1 of its length"), {percent(hand.followed)}});
}

Json toJson(const SessionSnapshot& end, const CollisionWorld& world, bool edges) {
  const PlannerCounts& counts = end.counts;
  Json report;
  report["solved"] = end.state == SessionState::Solved;
  report["status"] = status(end).english;
  report["strategy"] = end.plannerId;
  if (!end.member.empty()) report["member"] = end.member;
  report["wall_s"] = end.planningSeconds;
  report["planning_s"] = end.planningSeconds;
  report["planning_cpu_s"] = end.planningCpuSeconds;
  report["virtual_s"] = end.virtualSeconds;
  report["nodes"] = counts.nodes;
  report["nodes_by_author"] = byAuthor(end.nodesByAuthor);
  report["edges"] = counts.edges;
  report["dropped_edges"] = counts.droppedEdges;
  report["rejected_paths"] = counts.rejectedPaths;
  report["iterations"] = counts.iterations;
  report["steps"] = counts.steps;
  report["random_configurations"] = counts.randomConfigurations;
  report["operator_configurations"] = counts.operatorConfigurations;
  report["contact_configurations"] = counts.contactConfigurations;
  report["collision_queries"] = counts.queries.collision;
  report["distance_queries"] = counts.queries.distance;
  report["kernel_pairs"] = counts.queries.pairs;
  if (end.path) {
    report["path"] = {{"configurations", end.path->points.size()},
                      {"length_m", end.path->length()},
                      {"rotation_rad", end.path->rotation()}};
    report["path_share_by_author"] = byAuthor(pathShares(*end.path, world));
    report["certificate"] = cli::toJson(end.path->certificate, world, edges);
  } else {
    report["path"] = nullptr;
    report["path_share_by_author"] = nullptr;
    report["certificate"] = nullptr;
  }
  if (end.coarsePlan) report["coarse_plan"] = toJson(*end.coarsePlan);
  for (const ParameterSpec& spec : parameterTable()) {
    report["parameters"][std::string(spec.key)] = end.parameters[spec.id];
  }
  if (end.tuning) {
    const int tuned = end.parameters.integer(ParameterId::Tuning);
    report["tuning"] = {{"final", toJson(end.tuning->now, tuned)}, {"median", toJson(end.tuning->median, tuned)}};
  }
  if (end.hand) report["hand"] = toJson(*end.hand, end.path != nullptr);
  report["seed"] = end.seed;
  report["version"] = kVersion;
  if (end.problem) report["error"] = cli::toJson(*end.problem);
  return report;
}

void printCoarsePlan(const CoarsePlan& plan, const Console& console) {
  console.print({GLISSADE_TEXT("coarse path %1:"), {plan.attempt}});
  for (const TopologicalStep& step : plan.steps) {
    console.print({GLISSADE_TEXT("  %1 to %2: %3, %4 random {4|configuration|configurations} (%5)"),
                   {step.placeName, step.borderName, CatalogueText{kStepResultNames.of(step.result)},
                    step.randomConfigurations, step.why}});
  }
}

void printText(const SessionSnapshot& end, const CollisionWorld& world, const Console& console) {
  const PlannerCounts& counts = end.counts;
  console.print({GLISSADE_TEXT("%1 by %2 after %3 {3|step|steps} (%4 s virtual, %5 s of planning)"),
                 {status(end), end.plannerId + (end.member.empty() ? "" : " (" + end.member + ")"), counts.steps,
                  rounded(end.virtualSeconds), rounded(end.planningSeconds)}});
  console.print({GLISSADE_TEXT("nodes %1, edges %2, configurations: random %3, operator %4, contact %5"),
                 {counts.nodes, counts.edges, counts.randomConfigurations, counts.operatorConfigurations,
                  counts.contactConfigurations}});
  console.print({GLISSADE_TEXT("nodes by the computer %1, the operator %2, contact %3"),
                 {end.nodesByAuthor[0], end.nodesByAuthor[1], end.nodesByAuthor[2]}});
  if (end.coarsePlan) printCoarsePlan(*end.coarsePlan, console);
  if (end.hand) printHand(*end.hand, end.path != nullptr, console);
  if (!end.path) return;
  console.print({GLISSADE_TEXT("path of %1 {1|configuration|configurations}, %2 m, %3 rad"),
                 {end.path->points.size(), rounded(end.path->length()), rounded(end.path->rotation())}});
  console.print(inWords(end.path->certificate, world));
  const std::array shares = wholePercents(pathShares(*end.path, world));
  const auto percent = [&](std::size_t author) { return std::to_string(shares[author]) + " %"; };
  console.print({GLISSADE_TEXT("of its length by the computer %1, the operator %2, contact %3"),
                 {percent(0), percent(1), percent(2)}});
}

int exitCodeOf(const SessionSnapshot& end, const MissingShapes& missing) {
  if (end.state == SessionState::Solved) return exitCodeWithout(missing);
  if (end.state == SessionState::Stopped) return exitCode(ErrorKind::Interrupted);
  return exitCode(end.problem ? end.problem->kind : ErrorKind::Internal);
}

/// The search ended without a path; a start in collision does not count.
bool foundNone(const SessionSnapshot& end) {
  return end.problem && (end.problem->kind == ErrorKind::NoPath || end.problem->kind == ErrorKind::LimitReached);
}

/// The bodies that have to leave first. If the object is engaged in threads, these are the bodies that keep it there;
/// else they block it on its straight way out. After a limit, ways out of threads are not searched.
std::vector<const RigidBody*> blockingBodies(const LoadedScenario& scenario, const SessionSnapshot& end,
                                             const StopToken& stop) {
  const Problem& problem = scenario.problem;
  const double required = scenario.parameters[ParameterId::RequiredClearance];
  const auto query = problem.world->makeQuery();
  const ScrewSearch screws = problem.world->threads().empty() || end.problem->kind == ErrorKind::LimitReached
                                 ? ScrewSearch{}
                                 : findScrewWays(*problem.world, *query, problem.start, required, stop);
  std::vector<const RigidBody*> bodies;
  for (const int body : screws.engaged ? screws.blockedBy : firstInTheWay(problem, *query, required, stop)) {
    bodies.push_back(&scenario.obstacles[static_cast<std::size_t>(body)]);
  }
  return bodies;
}

Json idsOf(const std::vector<const RigidBody*>& bodies) {
  Json ids = Json::array();
  for (const RigidBody* body : bodies) ids.push_back(body->id);
  return ids;
}

void printBlocking(const std::vector<const RigidBody*>& bodies, const Console& console) {
  if (bodies.empty()) return;
  std::vector<Message> names;
  for (const RigidBody* body : bodies) names.push_back({GLISSADE_TEXT("'%1'"), {body->name}});
  console.print({GLISSADE_TEXT("held at its start by %1"), {glissade::joined(names, ", ")}});
}

/// Accepted clashes of the object with the bodies that hold it.
std::vector<Message> adviceAbout(const std::vector<const RigidBody*>& bodies, const LoadedScenario& scenario) {
  std::vector<Message> advice;
  for (const RigidBody* body : bodies) {
    const std::vector<Fit>& fits = scenario.fits.allowed;
    const auto clash = std::find_if(fits.begin(), fits.end(),
                                    [&](const Fit& fit) { return fit.body == body->id && isByAcceptedClash(fit); });
    if (clash != fits.end()) advice.push_back(adviceToCut(*clash, scenario.object.name, body->name));
  }
  return advice;
}

SaveResult writeRecord(const PlanOptions& options, const LoadedScenario& scenario, const SessionSnapshot& end) {
  const auto record = makeRunRecord(scenario, joined(end.log));
  if (!record) return notSaved(record.error());
  return writeRunRecord(*record, options.record);
}

/// Writes the requested files until one cannot be written.
std::optional<Diagnostic> writeFiles(const PlanOptions& options, const LoadedScenario& scenario,
                                     const SessionSnapshot& end) {
  if (end.path && !options.out.empty()) {
    const SaveResult saved = writePath(*end.path, scenario, {end.plannerId, end.seed}, options.out);
    reportWarnings(saved.warnings, options.console);
    if (!saved) return saved.why;
  }
  if (!options.record.empty()) {
    const SaveResult saved = writeRecord(options, scenario, end);
    reportWarnings(saved.warnings, options.console);
    if (!saved) return saved.why;
  }
  return std::nullopt;
}

/// The end of a run, whose error names the file where it is about a place in the scenario.
SessionSnapshot withFile(SessionSnapshot end, const std::string& file) {
  if (end.problem && !end.problem->location.empty()) end.problem->file = file;
  return end;
}

}  // namespace

int deliver(const PlanOptions& options, const LoadedScenario& scenario, const SessionSnapshot& ended,
            const StopToken& stop) {
  const SessionSnapshot end = withFile(ended, scenario.file);
  const std::optional<Diagnostic> notWritten = writeFiles(options, scenario, end);

  const CollisionWorld& world = *scenario.problem.world;
  std::optional<Difficulty> difficulty;
  std::vector<const RigidBody*> blockedBy;
  if (foundNone(end)) {
    if (options.difficulty) difficulty = difficultyOf(scenario, end, stop);
    blockedBy = blockingBodies(scenario, end, stop);
  }
  std::vector<Message> pulled;
  if (end.path) pulled = pulledThreadsOf(scenario, end.path->points, stop);
  if (options.console.json) {
    Json report = toJson(end, world, options.edges);
    if (end.path) addUncertainties(scenario, end.path->points, report["certificate"]);
    for (const Message& line : pulled) report["pulled_threads"].push_back(toString(line));
    if (foundNone(end)) report["blocked_by"] = idsOf(blockedBy);
    for (const Message& line : adviceAbout(blockedBy, scenario)) report["advice"].push_back(toString(line));
    if (difficulty) report["difficulty"] = toJson(*difficulty, world);
    printJson(report);
  } else {
    printText(end, world, options.console);
    if (end.path) {
      for (const Message& line : uncertaintiesInWords(scenario, end.path->points)) options.console.print(line);
      for (const Message& line : pulled) options.console.print(line);
    }
    if (end.path && options.edges) printEdges(end.path->certificate, world, options.console);
    printBlocking(blockedBy, options.console);
    for (const Message& line : adviceAbout(blockedBy, scenario)) options.console.print(line);
    if (difficulty) printDifficulty(*difficulty, world, options.console);
  }
  if (end.problem) noteError(*end.problem, options.console);
  if (notWritten) {
    noteError(*notWritten, options.console);
    return exitCode(notWritten->kind);
  }
  return exitCodeOf(end, scenario.missing);
}

}  // namespace glissade::cli
