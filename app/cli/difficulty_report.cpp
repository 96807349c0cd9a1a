#include "app/cli/difficulty_report.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/report.h"
#include "engine/base/json_reader.h"
#include "engine/geometry/pose_json.h"
#include "engine/session/grown_roadmap.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string place(const Pose& q) {
  std::ostringstream text;
  text << "(" << q.position.x() << ", " << q.position.y() << ", " << q.position.z() << ") m";
  return text.str();
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
                        {"blocked_by", bodyName(world, frontier->body)}};
    if (frontier->body >= 0) json["frontier"]["blocked_at"] = glissade::toJson(frontier->blockedAt);
  }
  if (const auto& tightest = difficulty.tightest) {
    json["tightest"] = {{"clearance_m", tightest->clearance},
                        {"body", bodyName(world, tightest->body)},
                        {"configuration", glissade::toJson(tightest->q)}};
  }
  if (const auto& least = difficulty.leastPenetration) {
    Json way = Json::array();
    for (const Pose& q : least->way) way.push_back(glissade::toJson(q));
    json["least_penetration"] = {{"depth_mm", 1e3 * least->depth},
                                 {"body", bodyName(world, least->body)},
                                 {"configuration", glissade::toJson(least->q)},
                                 {"way", way}};
  }
  return json;
}

void printDifficulty(const Difficulty& difficulty, const CollisionWorld& world) {
  if (const auto& frontier = difficulty.frontier) {
    std::cout << "the trees came within " << frontier->distance << " m of each other, from "
              << place(frontier->fromStart) << " to " << place(frontier->fromGoal);
    if (frontier->body >= 0) {
      std::cout << "; between the object and the goal's tree stands '" << bodyName(world, frontier->body) << "', at "
                << place(frontier->blockedAt);
    }
    std::cout << "\n";
  }
  if (const auto& tightest = difficulty.tightest) {
    std::cout << "tightest passage reached: " << 1e3 * tightest->clearance << " mm to '"
              << bodyName(world, tightest->body) << "', at " << place(tightest->q) << "\n";
  }
  if (const auto& least = difficulty.leastPenetration) {
    std::cout << "with " << 1e3 * least->depth << " mm given between the object and '" << bodyName(world, least->body)
              << "', at " << place(least->q) << ", there is a way of " << least->way.size() << " configurations\n";
  } else {
    std::cout << "no erosion of the object that was tried opens a way\n";
  }
}

}  // namespace glissade::cli
