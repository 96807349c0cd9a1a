#include "engine/api/values.h"

#include <set>

#include "engine/collision/motion_certificate.h"

namespace glissade::api {
namespace {

ProofStatus publicStatus(CertificateStatus status) {
  switch (status) {
    case CertificateStatus::Certified: return ProofStatus::Certified;
    case CertificateStatus::Violated: return ProofStatus::Violated;
    case CertificateStatus::Undecided: break;
  }
  return ProofStatus::Undecided;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string all;
  for (const std::string& part : {file, place, reason}) {
    if (!part.empty()) all += (all.empty() ? "" : ": ") + part;
  }
  return advice.empty() ? all : all + ". " + advice;
}

Pose publicPose(const glissade::Pose& pose) { return {pose.position, Quaternion(pose.orientation)}; }

std::vector<Pose> publicPoses(const std::vector<glissade::Pose>& poses) {
  std::vector<Pose> all;
  all.reserve(poses.size());
  for (const glissade::Pose& pose : poses) all.push_back(publicPose(pose));
  return all;
}

glissade::Pose enginePose(const Pose& pose) { return {pose.position, glissade::Quaternion(pose.orientation)}; }

Box publicBox(const Box3& box) { return {box.min(), box.max()}; }

Diagnostic publicDiagnostic(const glissade::Diagnostic& diagnostic) {
  return {diagnostic.kind, diagnostic.file, toString(diagnostic.location), toString(diagnostic.reason),
          toString(diagnostic.advice)};
}

Warnings publicWarnings(const glissade::Warnings& warnings) {
  Warnings all;
  for (const glissade::Diagnostic& warning : warnings) all.push_back(publicDiagnostic(warning));
  return all;
}

Nearest publicNearest(const NearestObstacle& nearest, const CollisionWorld& world) {
  const bool isBody = nearest.body >= 0;
  return {nearest.distance,
          isBody ? world.obstacles()[static_cast<std::size_t>(nearest.body)].id.text() : std::string(), nearest.p_WPo,
          nearest.p_WPn};
}

Certificate publicCertificate(const MotionCertificate& certificate, const CollisionWorld& world) {
  return {publicStatus(certificate.status),
          certificate.tolerance,
          certificate.provedClearance,
          certificate.minClearance,
          certificate.edge,
          certificate.at,
          publicNearest(certificate.nearest, world)};
}

std::vector<Body> publicBodies(const std::vector<RigidBody>& bodies) {
  std::vector<Body> all;
  all.reserve(bodies.size());
  for (const RigidBody& body : bodies) {
    all.push_back({body.id.text(), body.shown(), valueOf<Mesh>({body.mesh}), publicPose(body.X_WB)});
  }
  return all;
}

Path publicPath(glissade::Path path, PathProvenance provenance, const CollisionWorld* world) {
  std::vector<Pose> configurations = publicPoses(path.configurations());
  const Certificate certificate = world == nullptr ? Certificate() : publicCertificate(path.certificate, *world);
  return valueOf<Path>({std::move(path), std::move(provenance), std::move(configurations), certificate});
}

Diagnostic wrongArgument(std::string argument, std::string reason) {
  return {ErrorKind::Usage, "", std::move(argument), std::move(reason), ""};
}

std::optional<Diagnostic> faultOfPose(const Pose& pose, const std::string& argument) {
  if (isValid(enginePose(pose))) return std::nullopt;
  return wrongArgument(argument, "is not finite, or its quaternion is not a unit quaternion");
}

std::optional<Diagnostic> faultOfPoses(const std::vector<Pose>& poses, const std::string& argument) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (auto fault = faultOfPose(poses[i], argument + "[" + std::to_string(i) + "]")) return fault;
  }
  return poses.empty() ? std::optional(wrongArgument(argument, "is empty")) : std::nullopt;
}

Result<std::vector<RigidBody>> engineBodies(const std::vector<Body>& bodies, Mobility mobility,
                                            const std::string& argument) {
  std::vector<RigidBody> all;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    const std::string here = argument + "[" + std::to_string(i) + "]";
    if (body.id.empty()) return wrongArgument(here + ".id", "is empty");
    if (!ids.insert(body.id).second) return wrongArgument(here + ".id", "is the id of another body: " + body.id);
    if (const auto fault = faultOfPose(body.X_WB, here + ".X_WB")) return *fault;
    const std::string& name = body.name.empty() ? body.id : body.name;
    all.push_back({BodyId(body.id), name, mobility, body.mesh.impl().mesh, enginePose(body.X_WB)});
  }
  return all;
}

}  // namespace glissade::api
