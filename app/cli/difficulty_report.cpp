#include "app/cli/difficulty_report.h"

#include <nlohmann/json.hpp>

#include "app/cli/text_cells.h"
#include "engine/base/json_reader.h"
#include "engine/geometry/pose_json.h"
#include "engine/session/grown_roadmap.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string place(const Pose& q) {
  const Vector3& p = q.position;
  return "(" + rounded(p.x()) + ", " + rounded(p.y()) + ", " + rounded(p.z()) + ") m";
}

}  // namespace

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
    console.print({GLISSADE_TEXT("with %1 mm given between the object and '%2', at %3, there is a way of %4 "
                                 "configurations"),
                   {rounded(1e3 * least->depth), bodyName(world, least->body), place(least->q), least->way.size()}});
  } else {
    console.print(GLISSADE_TEXT("no erosion of the object that was tried opens a way"));
  }
}

}  // namespace glissade::cli
