#pragma once

#include "engine/files/path_exporter.h"

namespace glissade {

/// An animation for any viewer of glTF 2.0: one binary file with all bodies. Each body is a node with its name, mesh
/// (flat normals) and colour; obstacles are transparent as in the window. The object's node moves along the path for
/// ten seconds, at constant speed in the metric. See keyFramesOf for the accuracy.
///
/// Metres. A root node turns the world's z to glTF's y, so that nodes and key frames below it are X_WB. Single
/// precision: coordinates beyond it are an error. The scene's "extras" hold the provenance.
Result<std::string> pathAsGlb(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance);

}  // namespace glissade
