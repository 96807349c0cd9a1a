#include "engine/import/step_measures.h"

#include <algorithm>

namespace glissade {
namespace {

gp_XYZ vertexOf(const StepTriangles& triangles, std::uint32_t index) {
  const double* at = &triangles.vertices[std::size_t{3} * index];
  return {at[0], at[1], at[2]};
}

}  // namespace

TriangleMeasures measuresOf(const StepTriangles& triangles) {
  TriangleMeasures measures;
  for (const import_protocol::Face& face : triangles.faces) {
    measures.deflection = std::max(measures.deflection, face.deflection);
  }
  if (triangles.vertices.empty()) return measures;
  measures.origin = vertexOf(triangles, 0);
  for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
    const gp_XYZ a = vertexOf(triangles, triangles.indices[i]) - measures.origin;
    const gp_XYZ b = vertexOf(triangles, triangles.indices[i + 1]) - measures.origin;
    const gp_XYZ c = vertexOf(triangles, triangles.indices[i + 2]) - measures.origin;
    const double volume = a.Dot(b.Crossed(c)) / 6.0;
    measures.volume += volume;
    measures.area += (b - a).Crossed(c - a).Modulus() / 2.0;
    measures.moment += (a + b + c) * (volume / 4.0);
    measures.size = std::max({measures.size, a.Modulus(), b.Modulus(), c.Modulus()});
  }
  return measures;
}

}  // namespace glissade
