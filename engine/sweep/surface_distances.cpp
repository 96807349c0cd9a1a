#include "engine/sweep/surface_distances.h"

#include <algorithm>

#include "engine/environment/point_clearance.h"

namespace glissade {
namespace {

/// Lowers the squared distances of the points near one triangle.
void lowerNear(const std::array<Vector3, 3>& triangle, const Lattice& lattice, double reach,
               std::vector<float>& squared) {
  Box3 box;
  for (const Vector3& corner : triangle) box.extend(corner);
  box.min().array() -= reach;
  box.max().array() += reach;
  const LatticeRange range = rangeWithin(lattice, box);
  const Vector3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const Vector3 normal = across.norm() > 0.0 ? across.normalized() : Vector3::Zero();
  for (int x = range.first[0]; x <= range.last[0]; ++x) {
    for (int y = range.first[1]; y <= range.last[1]; ++y) {
      for (int z = range.first[2]; z <= range.last[2]; ++z) {
        const Vector3 p = lattice.point(x, y, z);
        float& known = squared[lattice.at(x, y, z)];
        const double height = normal.dot(p - triangle[0]);
        if (height * height >= known) continue;
        const double distance = (nearestOnTriangle(p, triangle[0], triangle[1], triangle[2]) - p).squaredNorm();
        known = std::min(known, static_cast<float>(distance));
      }
    }
  }
}

}  // namespace

SurfaceDistances::SurfaceDistances(const TriangleMesh& mesh, double spacing, double reach, const StopToken& stop)
    : spacing_(spacing) {
  Box3 box = boundingBox(mesh);
  box.min().array() -= reach;
  box.max().array() += reach + blockSize();
  const Lattice lattice = Lattice::over(box, spacing);
  std::vector<float> squared(lattice.size(), static_cast<float>(reach * reach));
  for (const auto& [a, b, c] : mesh.triangles) {
    if (stop.stopRequested()) return;
    lowerNear({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, lattice, reach, squared);
  }
  const auto far = static_cast<float>(reach * reach);
  for (int x = 0; x + kCells < lattice.counts[0]; x += kCells) {
    for (int y = 0; y + kCells < lattice.counts[1]; y += kCells) {
      for (int z = 0; z + kCells < lattice.counts[2]; z += kCells) {
        Block block{lattice.point(x, y, z), {}};
        bool near = false;
        std::size_t corner = 0;
        for (int i = 0; i <= kCells; ++i) {
          for (int j = 0; j <= kCells; ++j) {
            for (int k = 0; k <= kCells; ++k, ++corner) {
              const float value = squared[lattice.at(x + i, y + j, z + k)];
              near = near || value < far;
              block.distances[corner] = std::sqrt(value);
            }
          }
        }
        if (near) blocks_.push_back(block);
      }
    }
  }
}

float SurfaceDistances::interpolated(const Block& block, const Vector3& at_block) {
  std::array<std::size_t, 3> cell{};
  std::array<float, 3> t{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = at_block[static_cast<int>(axis)];
    const int first = std::clamp(static_cast<int>(value), 0, kCells - 1);
    cell[axis] = static_cast<std::size_t>(first);
    t[axis] = static_cast<float>(value - first);
  }
  const float* const least = &block.distances[(cell[0] * kPoints + cell[1]) * kPoints + cell[2]];
  const auto alongZ = [&](std::size_t offset) { return least[offset] + t[2] * (least[offset + 1] - least[offset]); };
  const auto alongY = [&](std::size_t offset) {
    const float first = alongZ(offset);
    return first + t[1] * (alongZ(offset + kPoints) - first);
  };
  const float first = alongY(0);
  return first + t[0] * (alongY(kPoints * kPoints) - first);
}

}  // namespace glissade
