#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"
#include "engine/model/occurrence.h"

namespace glissade {

/// Imports a URDF file as rigid bodies, one for each link, in the frame of the root link: boxes, cylinders, spheres and
/// meshes; collision shapes if a link has any, else its visual shapes; fixed joints only. Round shapes are
/// circumscribed. `package://` names and relative names are searched below `packageFolder` and may not leave it.
///
/// Errors are MalformedInput with link or joint as location: everything that urdfdom would silently drop (a bad number,
/// an unknown shape) is an error here.
Result<std::vector<Occurrence>> importUrdf(const FileContent& content, const std::string& packageFolder,
                                           const StopToken& stop = {});
Result<std::vector<Occurrence>> importUrdf(const std::string& file, const std::string& packageFolder);

}  // namespace glissade
