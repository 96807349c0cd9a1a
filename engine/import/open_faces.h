#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "engine/import/import_protocol.h"

namespace glissade {

/// Triangles of the faces of a solid. Each face has its vertices.
struct FaceTriangles {
  const std::vector<double>& vertices;  ///< x y z
  const std::vector<std::uint32_t>& indices;
  const std::vector<import_protocol::Face>& faces;  ///< faces in the order of the triangles
  const std::vector<std::string>& entities;         ///< names of the faces' entities, in the order of `faces`
};

/// The entities of the faces at which the triangles are open.
std::set<std::string> openFaces(const FaceTriangles& triangles);

}  // namespace glissade
