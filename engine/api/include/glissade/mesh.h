#pragma once

#include <glissade/export.h>
#include <glissade/pose.h>
#include <glissade/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace glissade::api {

/// Three indices of vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle mesh in its body's frame, metres. Immutable; copies share the triangles; any thread may read it.
class GLISSADE_EXPORT Mesh {
 public:
  /// The mesh of these vertices and triangles. Vertices with equal positions become one, and triangles with two equal
  /// corners are dropped. Errors (Usage): no triangle, a coordinate that is not finite or above 1e9 m, an index of no
  /// vertex.
  static Result<Mesh> make(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles);
  /// A box about the origin with these edges, metres. Error (Usage): an edge that is not above 0.
  static Result<Mesh> box(const Vector3& edges);

  /// Number of vertices.
  std::size_t vertexCount() const;
  /// The coordinates x, y, z of all vertices, 3 vertexCount() numbers. They live as long as a copy of the mesh.
  const double* vertexData() const;
  /// Number of triangles.
  std::size_t triangleCount() const;
  /// The indices of all triangles, 3 triangleCount() numbers. They live as long as a copy of the mesh.
  const std::uint32_t* triangleData() const;
  /// Bounding box in the frame of the mesh.
  Box box() const;
  /// True if the surface is closed. Only then it bounds a solid, in which other bodies collide.
  bool isClosed() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Mesh(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Mesh(const Mesh&) = default;             ///< shares the triangles
  Mesh& operator=(const Mesh&) = default;  ///< shares the triangles
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
