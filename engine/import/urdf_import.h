#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"

namespace glissade {

/// One link of a URDF file: all of its shapes as one mesh.
struct UrdfLink {
  std::string name;
  TriangleMesh mesh;                            ///< in the link's frame L
  Pose X_RL;                                    ///< in the frame R of the root link
  std::optional<std::array<double, 3>> colour;  ///< sRGB of its material
  double coordinateSpacing = 0.0;               ///< the largest of its meshes, as of ImportedMesh, metres
};

/// Imports a URDF file as rigid bodies: boxes, cylinders, spheres and meshes; collision shapes where a
/// link has any, its visual shapes otherwise; fixed joints only. Round shapes are circumscribed.
/// `package://` names and relative names are looked up below `packageFolder` and may not leave it.
///
/// Errors are MalformedInput with link or joint as location: whatever urdfdom would drop in silence (a
/// bad number, an unknown shape) is an error here.
Result<std::vector<UrdfLink>> importUrdf(const FileContent& content, const std::string& packageFolder,
                                         const StopToken& stop = {});
Result<std::vector<UrdfLink>> importUrdf(const std::string& file, const std::string& packageFolder);

}  // namespace glissade
