#include <glissade/mesh.h>

#include "engine/api/values.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/import/importer_process.h"

namespace glissade::api {

Result<Mesh> Mesh::make(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles) {
  return attempt<Mesh>("making a mesh", [&]() -> Result<Mesh> {
    TriangleMesh mesh;
    mesh.vertices.assign(vertices.begin(), vertices.end());
    mesh.triangles.assign(triangles.begin(), triangles.end());
    if (const auto fault = faultOf(mesh)) return wrongArgument("mesh", toString(*fault));
    mesh = welded(mesh);
    if (mesh.triangles.empty()) return wrongArgument("triangles", "hold no triangle with three different corners");
    return valueOf<Mesh>({std::make_shared<const TriangleMesh>(std::move(mesh))});
  });
}

Result<Mesh> Mesh::box(const Vector3& edges) {
  if (!edges.allFinite() || !(edges.minCoeff() > 0.0)) return wrongArgument("edges", "are not all above 0");
  return valueOf<Mesh>({std::make_shared<const TriangleMesh>(makeBox(edges))});
}

std::size_t Mesh::vertexCount() const { return impl().mesh->vertices.size(); }
const double* Mesh::vertexData() const { return impl().mesh->vertices.front().data(); }
std::size_t Mesh::triangleCount() const { return impl().mesh->triangles.size(); }
const std::uint32_t* Mesh::triangleData() const { return impl().mesh->triangles.front().data(); }
Box Mesh::box() const { return publicBox(boundingBox(*impl().mesh)); }
bool Mesh::isClosed() const { return isClosedSurface(*impl().mesh); }

}  // namespace glissade::api
