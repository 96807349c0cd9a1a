#include "engine/files/certificate_json.h"

#include <cmath>

#include "engine/base/json_reader.h"
#include "engine/geometry/pose_json.h"

namespace glissade {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string nameOf(const NearestObstacle& nearest, const BodyNames& names) {
  return nearest.body < 0 ? std::string() : names(nearest.body);
}

Json edgeJson(const EdgeCertificate& edge, const BodyNames& names) {
  Json json{{"status", kCertificateStatusNames.of(edge.status)},
            {"required_m", edge.demand.clearance},
            {"sliding", edge.demand.sliding},
            {"proved_clearance_m", number(edge.provedClearance)},
            {"min_clearance_m", number(edge.minClearance)},
            {"at", edge.at},
            {"body", nameOf(edge.nearest, names)}};
  if (edge.nearest.body >= 0 && edge.nearest.distance > 0.0) {
    json["on_body"] = toJson(edge.nearest.p_WPo);
    json["on_object"] = toJson(edge.nearest.p_WPn);
  }
  return json;
}

}  // namespace

Json certificateJson(const MotionCertificate& certificate, const BodyNames& names) {
  Json json{{"status", kCertificateStatusNames.of(certificate.status)},
            {"min_clearance_m", number(certificate.minClearance)},
            {"proved_clearance_m", number(certificate.provedClearance)},
            {"tolerance_m", certificate.tolerance},
            {"edge", certificate.edge},
            {"at", certificate.at},
            {"body", nameOf(certificate.nearest, names)},
            {"sliding_edges", certificate.slidingEdges()},
            {"distance_queries", certificate.distanceQueries}};
  if (certificate.againstThread) json["against_thread"] = true;
  if (certificate.forbiddenMargin > 0.0) json["forbidden_margin_m"] = certificate.forbiddenMargin;
  return json;
}

Json edgesJson(const MotionCertificate& certificate, const BodyNames& names) {
  Json edges = Json::array();
  for (const EdgeCertificate& edge : certificate.edges) edges.push_back(edgeJson(edge, names));
  return edges;
}

}  // namespace glissade
