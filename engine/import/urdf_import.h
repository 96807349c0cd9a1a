#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/environment/rigid_body.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

struct UrdfLink {
  std::string name;
  TriangleMesh mesh;  ///< in the link's frame, metres
  Pose X_RootLink;
  std::optional<Colour> colour;  ///< of the first visual with a material
};

struct UrdfModel {
  std::string name;
  std::vector<UrdfLink> links;  ///< those with geometry, in the order of the file
  std::string sha256;           ///< of the file's content
};

/// Reads a URDF file with urdfdom: boxes, cylinders, spheres (as meshes that contain them) and mesh
/// files; collision geometry where a link has any, else its visual geometry; fixed joints only.
/// Mesh files are looked for beside the URDF file, `package://NAME/PATH` in `folder`/NAME/PATH or
/// else `folder`/PATH, and never outside `folder`. Errors are MalformedInput and name the file and
/// the link, joint or line. Calls are serialised: urdfdom reports through process-wide state.
Result<UrdfModel> importUrdf(const std::string& file, const std::string& folder);

}  // namespace glissade
