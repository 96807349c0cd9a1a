#include <array>

#include "engine/scenario/atomic_file.h"
#include "engine/scenario/json_text.h"
#include "engine/scenario/number_text.h"
#include "engine/scenario/path_format.h"
#include "engine/scenario/path_io.h"
#include "glissade/version.h"

namespace glissade {
namespace {

std::array<double, 7> coordinates(const Pose& pose) {
  const Vector3& p = pose.position;
  const Quaternion& q = pose.orientation;
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

std::string row(const Pose& pose, char separator) {
  std::string text;
  for (const double value : coordinates(pose)) {
    if (!text.empty()) text += separator;
    text += toText(value);
  }
  return text;
}

Json toJson(const MotionCertificate& certificate) {
  constexpr std::array<const char*, 3> kStatus{"certified", "violated", "undecided"};
  return {{"status", kStatus[static_cast<std::size_t>(certificate.status)]},
          {"min_clearance_m", certificate.minClearance},
          {"proved_clearance_m", certificate.provedClearance},
          {"tolerance_m", certificate.tolerance},
          {"edge", certificate.edge},
          {"at", certificate.at}};
}

}  // namespace

Outcome writePathCsv(const Path& path, const LoadedScenario& scenario, const std::string& file) {
  const std::unique_ptr<CollisionQuery> query = scenario.problem.world->makeQuery();
  const Se3Metric metric = scenario.problem.metric();
  const double contactDistance = scenario.parameters[ParameterId::ContactDistance];
  std::string text = std::string(path_format::kCsvHeader) + "\n";
  double s = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const auto& [q, author] = path.points[i];
    if (i > 0) s += metric.distance(path.points[i - 1].q, q);
    const double clearance = query->nearestObstacle(q).distance;
    text += std::to_string(i) + "," + toText(s) + "," + row(q, ',') + "," + toText(clearance) + "," +
            (clearance < contactDistance ? "1" : "0") + "," + std::string(path_format::nameOf(author)) + "\n";
  }
  return writeFileAtomically(file, text);
}

Outcome writePathOmpl(const Path& path, const std::string& file) {
  std::string text;
  for (const PathPoint& point : path.points) text += row(point.q, ' ') + "\n";
  return writeFileAtomically(file, text);
}

Outcome writePathJson(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                      const std::string& file) {
  Json json{{"format", path_format::kName},
            {"version", path_format::kVersion},
            {"program", std::string("glissade ") + kVersion},
            {"scenario", scenario.scenario.name},
            {"scenario_file", scenario.file},
            {"planner", provenance.planner},
            {"seed", provenance.seed},
            {"length_m", path.length()},
            {"rotation_rad", path.rotation()},
            {"certificate", toJson(path.certificate)},
            {"points", Json::array()}};
  for (const auto& [q, author] : path.points) {
    json["points"].push_back({{"q", toRow(q)}, {"author", path_format::nameOf(author)}});
  }
  return writeFileAtomically(file, canonicalText(json));
}

}  // namespace glissade
