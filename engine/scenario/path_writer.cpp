#include <glissade/version.h>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/scenario/author_names.h"
#include "engine/scenario/certificate_json.h"
#include "engine/scenario/json_reader.h"
#include "engine/scenario/path_io.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

std::string sevenColumns(const Pose& q, char separator) {
  std::string text;
  const auto& p = q.position;
  const auto& o = q.orientation;
  for (const double value : {p.x(), p.y(), p.z(), o.x(), o.y(), o.z(), o.w()}) {
    if (!text.empty()) text += separator;
    text += toText(value);
  }
  return text;
}

}  // namespace

Outcome writePathCsv(const Path& path, const LoadedScenario& scenario, const std::string& file) {
  const auto query = scenario.problem.world->makeQuery();
  const Se3Metric metric = scenario.problem.metric();
  std::string text = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author\n";
  double s = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const PathPoint& point = path.points[i];
    if (i > 0) s += metric.distance(path.points[i - 1].q, point.q);
    text += std::to_string(i) + "," + toText(s) + "," + sevenColumns(point.q, ',') + "," +
            toText(query->nearestObstacle(point.q).distance) + "," + (point.author == Author::Contact ? "1" : "0") +
            "," + authorName(point.author) + "\n";
  }
  return writeFileAtomically(file, text);
}

Outcome writePathOmpl(const Path& path, const std::string& file) {
  std::string text;
  for (const PathPoint& point : path.points) text += sevenColumns(point.q, ' ') + "\n";
  return writeFileAtomically(file, text);
}

Outcome writePathJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                      const std::string& file) {
  Json json;
  json["format"] = "glissade-path";
  json["version"] = 1;
  json["scenario"] = scenario.scenario.name;
  json["planner"] = provenance.planner;
  json["seed"] = provenance.seed;
  json["program"] = std::string("Glissade ") + kVersion;
  const BodyNames ids = [&](int body) { return scenario.obstacles[static_cast<std::size_t>(body)].id; };
  json["certificate"] = certificateJson(path.certificate, ids);
  json["certificate"]["edges"] = edgesJson(path.certificate, ids);
  json["configurations"] = Json::array();
  for (const PathPoint& point : path.points) {
    Json configuration = toJson(point.q);
    configuration["author"] = authorName(point.author);
    json["configurations"].push_back(configuration);
  }
  return writeFileAtomically(file, json.dump(2) + "\n");
}

}  // namespace glissade
