#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// What the importing process hands back: plain arrays, or why there are none.
struct MeshReply {
  std::string error;                   ///< empty on success
  std::vector<float> coordinates;      ///< x y z of each vertex as assimp has them, duplicates included
  std::vector<std::uint32_t> corners;  ///< three vertex indices per triangle
};

/// The reply as bytes: magic, three counts, then the arrays (this machine's byte order: both
/// processes run on it).
std::string encode(const MeshReply& reply);

/// Reads the bytes of a process that is not trusted: counts must fit the bytes exactly, numbers must
/// be finite and at most kLargestCoordinate, indices in range, and there must be a triangle. The
/// diagnostic has no file.
Result<MeshReply> decodeMeshReply(std::string_view bytes);

/// Coordinates beyond this are not lengths of parts but damage (in the file's own unit).
inline constexpr double kLargestCoordinate = 1e9;

}  // namespace glissade
