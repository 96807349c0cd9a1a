#include "app/cli/report.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/scenario/certificate_json.h"

namespace glissade::cli {
using Json = nlohmann::ordered_json;

std::string bodyName(const CollisionWorld& world, int body) {
  return body < 0 ? std::string() : world.obstacles()[static_cast<std::size_t>(body)].name;
}

int reportError(const Diagnostic& error, Format format) {
  std::cerr << "glissade-cli: " << toString(error) << "\n";
  if (format == Format::Json) std::cout << Json{{"error", toJson(error)}}.dump(2) << "\n";
  return exitCode(error.kind);
}

void reportWarnings(const Warnings& warnings) {
  for (const Diagnostic& warning : warnings) std::cerr << "glissade-cli: warning: " << toString(warning) << "\n";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json toJson(const Diagnostic& error) {
  return {{"file", error.file}, {"place", error.place}, {"reason", error.reason}, {"advice", error.advice}};
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
      text << ")";
      break;
    case CertificateStatus::Violated:
      text << "violated: " << certificate.minClearance * 1e3 << " mm to '" << body << "' on edge " << certificate.edge
           << " at " << certificate.at << " (required " << certificate.tolerance * 1e3 << " mm)";
      break;
    case CertificateStatus::Undecided: text << "undecided on edge " << certificate.edge; break;
  }
  return text.str();
}

std::string deviationInWords(const LoadedScenario& scenario) {
  const double deviation = surfaceDeviation(scenario);
  if (deviation <= 0.0) return {};
  std::ostringstream text;
  text << "the certificate is about triangles: surfaces of the STEP files may be " << deviation * 1e3
       << " mm nearer than they are\n";
  return text.str();
}

void printEdges(const MotionCertificate& certificate, const CollisionWorld& world) {
  for (std::size_t i = 0; i < certificate.edges.size(); ++i) {
    const EdgeCertificate& edge = certificate.edges[i];
    std::cout << "  edge " << i << ": " << statusName(edge.status) << ", clearance " << edge.provedClearance * 1e3
              << " to " << edge.minClearance * 1e3 << " mm";
    if (edge.nearest.body >= 0) std::cout << " to '" << bodyName(world, edge.nearest.body) << "' at " << edge.at;
    std::cout << " (required " << edge.demand.clearance * 1e3 << " mm" << (edge.demand.sliding ? ", sliding" : "")
              << ")\n";
  }
}

}  // namespace glissade::cli
