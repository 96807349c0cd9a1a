#include "engine/scenario/extent_check.h"

#include <algorithm>

#include "engine/base/limits.h"
#include "engine/base/number_text.h"

namespace glissade {
namespace {

Diagnostic refused(const std::string& file, const std::string& location, const std::string& reason) {
  return {ErrorKind::MalformedInput, file, location, reason, "Check its pose, its size and the unit of its file."};
}

Outcome checkReach(const RigidBody& body, const std::string& file) {
  const Box3 box = boundingBox(*body.mesh, body.X_WB);
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (limits::isCoordinate(reach)) return Done{};
  return refused(file, "body '" + body.name + "'",
                 "reaches " + toText(reach) + " m from the world's origin, beyond 1e9 m");
}

}  // namespace

Outcome checkNumberOfBodies(const LoadedScenario& loaded, const std::string& file) {
  if (loaded.obstacles.size() <= limits::kMostBodies) return Done{};
  return Diagnostic{ErrorKind::MalformedInput, file, "/bodies",
                    "expand to more than " + std::to_string(limits::kMostBodies) + " rigid bodies",
                    "Give the parts that matter, or fewer bodies made of the same file."};
}

Outcome checkExtents(const LoadedScenario& loaded, const Box3& workspace, const std::string& file) {
  for (const RigidBody& body : loaded.obstacles) {
    if (const Outcome near = checkReach(body, file); !near) return near;
  }
  if (const Outcome near = checkReach(loaded.object, file); !near) return near;
  const double radius = radiusAboutOrigin(*loaded.object.mesh);
  if (!limits::isSize(radius)) {
    return refused(file, "body '" + loaded.object.name + "'",
                   "has a radius of " + toText(radius) + " m, which is not from 1e-12 m to 1e9 m");
  }
  if (workspace.diagonal().norm() > limits::kLargestRatio * radius) {
    return Diagnostic{ErrorKind::MalformedInput, file, "/workspace", "is more than 1e10 times as large as the object",
                      "Check the units of both, or give a smaller workspace."};
  }
  return Done{};
}

}  // namespace glissade
