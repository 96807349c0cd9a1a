#include "app/cli/report.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string bodyName(const CollisionWorld& world, int body) {
  return body < 0 ? std::string() : world.obstacles()[static_cast<std::size_t>(body)].name;
}

}  // namespace

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

Json toJson(const MotionCertificate& certificate, const CollisionWorld& world) {
  return {{"status", name(certificate.status)},
          {"min_clearance_m", number(certificate.minClearance)},
          {"proved_clearance_m", number(certificate.provedClearance)},
          {"tolerance_m", certificate.tolerance},
          {"edge", certificate.edge},
          {"at", certificate.at},
          {"body", bodyName(world, certificate.nearest.body)},
          {"distance_queries", certificate.distanceQueries}};
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
      text << " (required " << certificate.tolerance * 1e3 << " mm)";
      break;
    case CertificateStatus::Violated:
      text << "violated: " << certificate.minClearance * 1e3 << " mm to '" << body << "' on edge " << certificate.edge
           << " at " << certificate.at << " (required " << certificate.tolerance * 1e3 << " mm)";
      break;
    case CertificateStatus::Undecided: text << "undecided on edge " << certificate.edge; break;
  }
  return text.str();
}

const char* name(CertificateStatus status) {
  switch (status) {
    case CertificateStatus::Certified: return "certified";
    case CertificateStatus::Violated: return "violated";
    case CertificateStatus::Undecided: return "undecided";
  }
  return "";
}

}  // namespace glissade::cli
