#include "engine/files/path_text.h"

#include <glissade/version.h>

#include "engine/base/json_reader.h"
#include "engine/base/number_text.h"
#include "engine/files/certificate_json.h"
#include "engine/files/product_name.h"
#include "engine/files/scenario_fits.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"
#include "engine/import/missing_shapes_json.h"

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

BodyNames idsOf(const LoadedScenario& scenario) {
  return [&scenario](int body) { return scenario.obstacles[static_cast<std::size_t>(body)].id.text(); };
}

}  // namespace

Result<std::string> pathAsCsv(const Path& path, const LoadedScenario& scenario, const PathProvenance&) {
  const auto query = scenario.problem.world->makeQuery();
  const Se3Metric metric = scenario.problem.metric();
  std::string text = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author\n";
  double s = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const PathPoint& point = path.points[i];
    if (i > 0) s += metric.distance(path.points[i - 1].q, point.q);
    text += std::to_string(i) + "," + toText(s) + "," + sevenColumns(point.q, ',') + "," +
            toText(query->nearestObstacle(point.q).distance) + "," + (point.author == Author::Contact ? "1" : "0") +
            "," + kAuthorNames.of(point.author) + "\n";
  }
  return text;
}

Result<std::string> pathAsOmpl(const Path& path, const LoadedScenario&, const PathProvenance&) {
  std::string text;
  for (const PathPoint& point : path.points) text += sevenColumns(point.q, ' ') + "\n";
  return text;
}

Result<std::string> pathAsJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance) {
  Json json{{"format", "glissade-path"}, {"version", 1}};
  json.update(provenanceJson(path, scenario, provenance));
  json["certificate"]["edges"] = edgesJson(path.certificate, idsOf(scenario));
  json["configurations"] = Json::array();
  for (const PathPoint& point : path.points) {
    Json configuration = toJson(point.q);
    configuration["author"] = kAuthorNames.of(point.author);
    json["configurations"].push_back(configuration);
  }
  addChecksum(json);
  return jsonText(json, 2) + "\n";
}

Json provenanceJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance) {
  Json json{{"scenario", nameOfProduct(scenario)},
            {"planner", provenance.planner},
            {"seed", provenance.seed},
            {"program", std::string("Glissade ") + kVersion},
            {"certificate", certificateJson(path.certificate, idsOf(scenario))}};
  if (const MissingShapes& missing = scenario.missing; !missing.empty()) {
    json["certificate"]["missing_shapes"] = missingShapesJson(missing);
  }
  if (!scenario.fits.allowed.empty()) json["certificate"]["allowances"] = allowancesJson(scenario, path.points);
  return json;
}

}  // namespace glissade
