#include "app/cli/report.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/printable_text.h"
#include "engine/base/quantity_text.h"
#include "engine/import/missing_shapes_json.h"
#include "engine/scenario/certificate_json.h"
#include "engine/scenario/scenario_fits.h"

namespace glissade::cli {
using Json = nlohmann::ordered_json;

std::string bodyName(const CollisionWorld& world, int body) {
  if (body == kForbiddenPlace) return "a forbidden place";
  return body < 0 ? std::string() : world.obstacles()[static_cast<std::size_t>(body)].shown();
}

void printJson(const Json& json) { std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n"; }

int reportError(const Diagnostic& error, Format format) {
  std::cerr << "glissade-cli: " << toString(error) << "\n";
  if (format == Format::Json) printJson({{"error", toJson(error)}});
  return exitCode(error.kind);
}

Diagnostic placesHoldForPathsOnly(const std::string& file) {
  return {ErrorKind::MalformedInput, file, "",
          "forbids places to the path of its object; the steps of an assembly plan may cross them",
          "Forbid directions of parts instead (--forbid)."};
}

void reportWarnings(const Warnings& warnings) {
  for (const Diagnostic& warning : warnings) std::cerr << "glissade-cli: warning: " << toString(warning) << "\n";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json vectorJson(const Vector3& v) { return Json::array({number(v.x()), number(v.y()), number(v.z())}); }

Json poseJson(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return {{"position", vectorJson(pose.position)}, {"orientation", Json::array({q.x(), q.y(), q.z(), q.w()})}};
}

Json toJson(const Diagnostic& error) {
  return {{"file", printableLine(error.file)},
          {"place", printableLine(error.location)},
          {"reason", printableText(error.reason)},
          {"advice", printableText(error.advice)}};
}

Json toJson(const MotionCertificate& certificate, const CollisionWorld& world, bool edges) {
  const BodyNames names = [&](int body) { return bodyName(world, body); };
  Json json = certificateJson(certificate, names);
  if (edges) json["edges"] = edgesJson(certificate, names);
  return json;
}

std::string inWords(const MotionCertificate& certificate, const CollisionWorld& world) {
  std::ostringstream text;
  const std::string body = bodyName(world, certificate.nearest.body);
  switch (certificate.status) {
    case CertificateStatus::Certified:
      text << "certified: ";
      if (body.empty()) {
        text << "nothing near";
      } else {
        text << "clearance " << certificate.minClearance * 1e3 << " mm to '" << body << "'";
      }
      text << " (required " << certificate.tolerance * 1e3 << " mm";
      if (const std::size_t sliding = certificate.slidingEdges(); sliding > 0) {
        text << ", " << sliding << " of " << certificate.edges.size() << " edges slide";
      }
      if (certificate.forbiddenMargin > 0.0) {
        text << "; " << inMillimetres(certificate.forbiddenMargin) << " from forbidden places";
      }
      text << ")";
      break;
    case CertificateStatus::Violated:
      if (certificate.againstThread) {
        text << "violated: on edge " << certificate.edge << " the object is in the thread of '" << body
             << "', and the edge is no turn about their axis by the pitch";
        break;
      }
      text << "violated: " << certificate.minClearance * 1e3 << " mm to '" << body << "' on edge " << certificate.edge
           << " at " << certificate.at << " (required " << certificate.tolerance * 1e3 << " mm)";
      break;
    case CertificateStatus::Undecided: text << "undecided on edge " << certificate.edge; break;
  }
  return text.str();
}

void addUncertainties(const LoadedScenario& scenario, const std::vector<PathPoint>& path, Json& certificate) {
  certificate["surface_deviation_m"] = surfaceDeviation(scenario);
  certificate["coordinate_spacing_m"] = coordinateSpacing(scenario);
  certificate["missing_shapes"] = missingShapesJson(scenario.missing);
  if (!scenario.fits.allowed.empty()) certificate["allowances"] = allowancesJson(scenario, path);
}

std::string deviationInWords(const LoadedScenario& scenario, const std::vector<PathPoint>& path) {
  std::ostringstream text;
  for (const std::string& allowance : allowancesInWords(scenario, path)) text << "allowance: " << allowance << "\n";
  if (const MissingShapes& missing = scenario.missing; !missing.empty()) text << statementOf(missing) << "\n";
  if (const double deviation = surfaceDeviation(scenario); deviation > 0.0) {
    text << "the certificate is about triangles, which are within +/- " << inMillimetres(deviation)
         << " of the CAD surfaces\n";
  }
  if (const double spacing = coordinateSpacing(scenario); spacing > 0.0) {
    text << "coordinate spacing: mesh files hold 32-bit numbers or were closed at T-junctions, so that bodies may be "
         << spacing * 1e3 << " mm nearer\n";
  }
  return text.str();
}

void printEdges(const MotionCertificate& certificate, const CollisionWorld& world) {
  for (std::size_t i = 0; i < certificate.edges.size(); ++i) {
    const EdgeCertificate& edge = certificate.edges[i];
    std::cout << "  edge " << i << ": " << kCertificateStatusNames.of(edge.status) << ", clearance "
              << edge.provedClearance * 1e3 << " to " << edge.minClearance * 1e3 << " mm";
    if (edge.nearest.body >= 0) std::cout << " to '" << bodyName(world, edge.nearest.body) << "' at " << edge.at;
    std::cout << " (required " << edge.demand.clearance * 1e3 << " mm" << (edge.demand.sliding ? ", sliding" : "")
              << ")\n";
  }
}

}  // namespace glissade::cli
