#include "app/cli/report.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/text_cells.h"
#include "engine/base/printable_text.h"
#include "engine/files/certificate_json.h"
#include "engine/files/scenario_fits.h"
#include "engine/import/missing_shapes_json.h"

namespace glissade::cli {
using Json = nlohmann::ordered_json;

Message bodyName(const CollisionWorld& world, int body) {
  if (body == kForbiddenPlace) return GLISSADE_TEXT("a forbidden place");
  return body < 0 ? Message() : Message(world.obstacles()[static_cast<std::size_t>(body)].shown());
}

void printJson(const Json& json) { std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n"; }

void Console::print(const Message& line) const { std::cout << text(line) << "\n"; }

void Console::note(const Message& line) const { std::cerr << "glissade-cli: " << text(line) << "\n"; }

void noteError(const Diagnostic& error, const Console& console) {
  std::cerr << "glissade-cli: " << toString(error, console.language) << "\n";
}

int reportError(const Diagnostic& error, const Console& console) {
  noteError(error, console);
  if (console.json) printJson({{"error", toJson(error)}});
  return exitCode(error.kind);
}

Diagnostic placesHoldForPathsOnly(const std::string& file) {
  return {ErrorKind::MalformedInput, file, "",
          GLISSADE_TEXT("forbids places to the path of its object; the steps of an assembly plan may cross them"),
          GLISSADE_TEXT("Forbid directions of parts instead (--forbid).")};
}

void reportWarnings(const Warnings& warnings, const Console& console) {
  for (const Diagnostic& warning : warnings) {
    console.note({GLISSADE_TEXT("warning: %1"), {toString(warning, console.language)}});
  }
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json vectorJson(const Vector3& v) { return Json::array({number(v.x()), number(v.y()), number(v.z())}); }

Json poseJson(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return {{"position", vectorJson(pose.position)}, {"orientation", Json::array({q.x(), q.y(), q.z(), q.w()})}};
}

Json toJson(const Diagnostic& error) {
  return {{"file", printableLine(error.file)},
          {"place", printableLine(toString(error.location))},
          {"reason", printableText(toString(error.reason))},
          {"advice", printableText(toString(error.advice))}};
}

Json toJson(const MotionCertificate& certificate, const CollisionWorld& world, bool edges) {
  const BodyNames names = [&](int body) { return toString(bodyName(world, body)); };
  Json json = certificateJson(certificate, names);
  if (edges) json["edges"] = edgesJson(certificate, names);
  return json;
}

namespace {

std::string millimetres(double metres) { return rounded(metres * 1e3); }

Message certifiedInWords(const MotionCertificate& certificate, const Message& body) {
  Message near = GLISSADE_TEXT("nothing near");
  if (!body.empty()) {
    near = {GLISSADE_TEXT("clearance %1 mm to '%2'"), {millimetres(certificate.minClearance), body}};
  }
  Message demand{GLISSADE_TEXT("required %1 mm"), {millimetres(certificate.tolerance)}};
  if (const std::size_t sliding = certificate.slidingEdges(); sliding > 0) {
    demand = {GLISSADE_TEXT("%1, %2 of %3 {3|edge|edges} {2|slides|slide}"),
              {demand, sliding, certificate.edges.size()}};
  }
  if (certificate.forbiddenMargin > 0.0) {
    demand = {GLISSADE_TEXT("%1; %2 from forbidden places"), {demand, Length{certificate.forbiddenMargin}}};
  }
  return {GLISSADE_TEXT("certified: %1 (%2)"), {near, demand}};
}

Message violatedInWords(const MotionCertificate& certificate, const Message& body) {
  if (certificate.againstThread) {
    return {GLISSADE_TEXT("violated: on edge %1 the object is in the thread of '%2', and the edge is no turn about "
                          "their axis by the pitch"),
            {certificate.edge, body}};
  }
  return {GLISSADE_TEXT("violated: %1 mm to '%2' on edge %3 at %4 (required %5 mm)"),
          {millimetres(certificate.minClearance), body, certificate.edge, rounded(certificate.at),
           millimetres(certificate.tolerance)}};
}

/// The text of an edge: %1 its number, %2 its clearance.
CatalogueText edgeText(CertificateStatus status) {
  switch (status) {
    case CertificateStatus::Certified: return GLISSADE_TEXT("  edge %1: certified, %2");
    case CertificateStatus::Violated: return GLISSADE_TEXT("  edge %1: violated, %2");
    case CertificateStatus::Undecided: break;
  }
  return GLISSADE_TEXT("  edge %1: undecided, %2");
}

Message clearanceInWords(const EdgeCertificate& edge, const CollisionWorld& world) {
  Message clearance{GLISSADE_TEXT("clearance %1 to %2 mm"),
                    {millimetres(edge.provedClearance), millimetres(edge.minClearance)}};
  if (edge.nearest.body >= 0) {
    clearance = {GLISSADE_TEXT("%1 to '%2' at %3"), {clearance, bodyName(world, edge.nearest.body), rounded(edge.at)}};
  }
  return {edge.demand.sliding ? GLISSADE_TEXT("%1 (required %2 mm, sliding)") : GLISSADE_TEXT("%1 (required %2 mm)"),
          {clearance, millimetres(edge.demand.clearance)}};
}

}  // namespace

Message inWords(const MotionCertificate& certificate, const CollisionWorld& world) {
  const Message body = bodyName(world, certificate.nearest.body);
  switch (certificate.status) {
    case CertificateStatus::Certified: return certifiedInWords(certificate, body);
    case CertificateStatus::Violated: return violatedInWords(certificate, body);
    case CertificateStatus::Undecided: break;
  }
  return {GLISSADE_TEXT("undecided on edge %1"), {certificate.edge}};
}

void addUncertainties(const LoadedScenario& scenario, const std::vector<PathPoint>& path, Json& certificate) {
  certificate["surface_deviation_m"] = surfaceDeviation(scenario);
  certificate["coordinate_spacing_m"] = coordinateSpacing(scenario);
  certificate["missing_shapes"] = missingShapesJson(scenario.missing);
  if (!scenario.fits.allowed.empty()) certificate["allowances"] = allowancesJson(scenario, path);
}

std::vector<Message> uncertaintiesInWords(const LoadedScenario& scenario, const std::vector<PathPoint>& path) {
  std::vector<Message> lines;
  for (const Message& allowance : allowancesInWords(scenario, path)) {
    lines.push_back({GLISSADE_TEXT("allowance: %1"), {allowance}});
  }
  if (const MissingShapes& missing = scenario.missing; !missing.empty()) lines.push_back(statementOf(missing));
  if (const double deviation = surfaceDeviation(scenario); deviation > 0.0) {
    lines.push_back({GLISSADE_TEXT("CAD accuracy of the certificate: +/- %1"), {Length{deviation}}});
  }
  if (const double spacing = coordinateSpacing(scenario); spacing > 0.0) {
    lines.push_back({GLISSADE_TEXT("coordinate spacing: mesh files hold 32-bit numbers or were closed at T-junctions, "
                                   "so that bodies may be %1 mm nearer"),
                     {millimetres(spacing)}});
  }
  return lines;
}

void printEdges(const MotionCertificate& certificate, const CollisionWorld& world, const Console& console) {
  for (std::size_t i = 0; i < certificate.edges.size(); ++i) {
    const EdgeCertificate& edge = certificate.edges[i];
    console.print({edgeText(edge.status), {i, clearanceInWords(edge, world)}});
  }
}

}  // namespace glissade::cli
