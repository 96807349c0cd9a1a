#include "engine/files/kept_path_json.h"

#include <set>

#include "engine/geometry/pose_json.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr std::size_t kMostKeptPaths = 1000;

PathPoint readPoint(const JsonCursor& at) {
  at.allowOnly({"position", "orientation", "author", "segment_author"});
  const Json pose{{"position", at.at("position").json()}, {"orientation", at.at("orientation").json()}};
  PathPoint point;
  point.q = readPose(JsonCursor(pose, at.file(), at.pointer()));
  if (const auto author = at.find("author")) point.author = author->named(kAuthorNames);
  point.segmentAuthor = point.author;
  if (const auto author = at.find("segment_author")) point.segmentAuthor = author->named(kAuthorNames);
  return point;
}

Allowance readKeptAllowance(const JsonCursor& at) {
  at.allowOnly({"body", "allowance", "yields", "hollow"});
  Allowance allowance{at.at("body").nonEmptyText()};
  allowance.allowance = at.at("allowance").length();
  if (const auto yields = at.find("yields")) allowance.yields = yields->boolean();
  if (const auto hollow = at.find("hollow")) allowance.hollow = hollow->boolean();
  return allowance;
}

/// Reads a clearance of a path: 0 or more.
double readKeptClearance(const JsonCursor& at) {
  const double value = at.coordinate();
  if (value < 0.0) at.fail(GLISSADE_TEXT("is below zero"), GLISSADE_TEXT("Give metres, 0 or more."));
  return value;
}

KeptPath readKeptPath(const JsonCursor& at) {
  at.allowOnly({"name", "pinned", "object", "planner", "seed", "smoothed", "required_clearance", "clearance",
                "proved_clearance", "allowances", "problem_sha256", "configurations"});
  KeptPath path;
  path.name = at.at("name").nonEmptyText();
  if (const auto pinned = at.find("pinned")) path.pinned = pinned->boolean();
  path.object = at.at("object").nonEmptyText();
  if (const auto planner = at.find("planner")) path.provenance.planner = planner->text();
  if (const auto seed = at.find("seed")) path.provenance.seed = seed->wholeNumber();
  if (const auto smoothed = at.find("smoothed")) path.smoothed = smoothed->boolean();
  path.requiredClearance = at.at("required_clearance").length();
  if (const auto clearance = at.find("clearance")) path.clearance = readKeptClearance(*clearance);
  if (const auto proved = at.find("proved_clearance")) path.provedClearance = readKeptClearance(*proved);
  const auto allowances = at.find("allowances");
  for (std::size_t i = 0; allowances && i < allowances->size(); ++i) {
    path.allowances.push_back(readKeptAllowance(allowances->element(i)));
  }
  if (const auto problem = at.find("problem_sha256")) path.problemSha256 = problem->text();
  const JsonCursor points = at.at("configurations");
  for (std::size_t i = 0; i < points.size(); ++i) path.points.push_back(readPoint(points.element(i)));
  if (path.points.empty()) points.fail(GLISSADE_TEXT("is empty"), GLISSADE_TEXT("Give a path, or remove it."));
  return path;
}

Json toJson(const PathPoint& point) {
  Json json = glissade::toJson(point.q);
  json["author"] = kAuthorNames.of(point.author);
  if (point.segmentAuthor != point.author) json["segment_author"] = kAuthorNames.of(point.segmentAuthor);
  return json;
}

Json toJson(const KeptPath& path) {
  Json json{{"name", path.name}};
  if (path.pinned) json["pinned"] = true;
  json["object"] = path.object;
  if (!path.provenance.planner.empty()) {
    json["planner"] = path.provenance.planner;
    json["seed"] = path.provenance.seed;
  }
  if (path.smoothed) json["smoothed"] = true;
  json["required_clearance"] = path.requiredClearance;
  if (path.clearance >= 0.0) json["clearance"] = path.clearance;
  json["proved_clearance"] = path.provedClearance;
  for (const Allowance& given : path.allowances) {
    Json& allowance = json["allowances"].emplace_back(Json{{"body", given.body}, {"allowance", given.allowance}});
    if (given.yields) allowance["yields"] = true;
    if (given.hollow) allowance["hollow"] = true;
  }
  if (!path.problemSha256.empty()) json["problem_sha256"] = path.problemSha256;
  json["configurations"] = Json::array();
  for (const PathPoint& point : path.points) json["configurations"].push_back(toJson(point));
  return json;
}

}  // namespace

KeptPaths readKeptPaths(const JsonCursor& at) {
  KeptPaths paths;
  std::set<std::string> names;
  for (std::size_t i = 0; i < at.sizeUpTo(kMostKeptPaths); ++i) {
    const JsonCursor element = at.element(i);
    auto path = std::make_shared<const KeptPath>(readKeptPath(element));
    if (!names.insert(path->name).second) {
      element.at("name").fail(GLISSADE_TEXT("is the name of a path before it"),
                              GLISSADE_TEXT("Give every path a name of its own."));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

void addKeptPaths(const KeptPaths& paths, Json& json) {
  if (paths.empty()) return;
  json["paths"] = Json::array();
  for (const KeptPathPtr& path : paths) json["paths"].push_back(toJson(*path));
}

}  // namespace glissade
