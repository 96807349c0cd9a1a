#include "engine/sweep/level_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

#include "engine/sweep/kuhn_division.h"

namespace glissade {
namespace {

/// The even permutations of four corners.
constexpr std::array<TetrahedronCorners, 12> kEven{{{0, 1, 2, 3},
                                                    {0, 2, 3, 1},
                                                    {0, 3, 1, 2},
                                                    {1, 0, 3, 2},
                                                    {1, 3, 2, 0},
                                                    {1, 2, 0, 3},
                                                    {2, 0, 1, 3},
                                                    {2, 1, 3, 0},
                                                    {2, 3, 0, 1},
                                                    {3, 0, 2, 1},
                                                    {3, 2, 1, 0},
                                                    {3, 1, 0, 2}}};

/// Vertices nearer to the inner end of their edge than this share of it would make triangles without area.
constexpr double kLeastShare = 1e-3;

class SurfaceBuilder {
 public:
  SurfaceBuilder(const Lattice& lattice, const std::vector<float>& values, float level)
      : lattice_(lattice), values_(values), level_(level) {}

  TriangleMesh build() {
    for (int x = 0; x + 1 < lattice_.counts[0]; ++x) {
      for (int y = 0; y + 1 < lattice_.counts[1]; ++y) {
        for (int z = 0; z + 1 < lattice_.counts[2]; ++z) addCell(x, y, z);
      }
    }
    return std::move(mesh_);
  }

 private:
  bool inside(std::size_t point) const { return values_[point] <= level_; }

  void addCell(int x, int y, int z) {
    int within = 0;
    for (int corner = 0; corner < 8; ++corner) within += inside(lattice_.cornerAt({x, y, z}, corner)) ? 1 : 0;
    if (within == 0 || within == 8) return;
    for (const TetrahedronCorners& tetrahedron : kKuhnTetrahedra) addTetrahedron(x, y, z, tetrahedron);
  }

  void addTetrahedron(int x, int y, int z, const TetrahedronCorners& tetrahedron) {
    std::array<std::size_t, 4> points{};
    int within = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      points[i] = lattice_.cornerAt({x, y, z}, tetrahedron[i]);
      within += inside(points[i]) ? 1 : 0;
    }
    if (within == 0 || within == 4) return;
    // The inner corners first; where there are three, the outer one first.
    const int ahead = within == 3 ? 1 : within;
    for (const TetrahedronCorners& order : kEven) {
      const auto point = [&](std::size_t i) { return points[static_cast<std::size_t>(order[i])]; };
      bool fits = true;
      for (int i = 0; i < 4; ++i)
        fits = fits && inside(point(static_cast<std::size_t>(i))) == ((i < ahead) != (within == 3));
      if (!fits) continue;
      const std::size_t a = point(0);
      const std::size_t b = point(1);
      const std::size_t c = point(2);
      const std::size_t d = point(3);
      if (within == 1) addTriangle(vertex(a, b), vertex(a, c), vertex(a, d));
      if (within == 3) addTriangle(vertex(a, b), vertex(a, d), vertex(a, c));
      if (within == 2) {
        addTriangle(vertex(a, c), vertex(a, d), vertex(b, d));
        addTriangle(vertex(a, c), vertex(b, d), vertex(b, c));
      }
      return;
    }
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.push_back({a, b, c}); }

  /// The vertex on the edge between two points, one of them inside; made once.
  std::uint32_t vertex(std::size_t p, std::size_t q) {
    const std::size_t in = inside(p) ? p : q;
    const std::size_t out = inside(p) ? q : p;
    // An edge leads from its lesser point to one of the seven other corners of the cell at that point.
    const std::uint64_t key =
        static_cast<std::uint64_t>(std::min(p, q)) * 8 + direction(std::min(p, q), std::max(p, q));
    const auto [known, isNew] = vertexOf_.emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (isNew) {
      const double t = (level_ - values_[in]) / (static_cast<double>(values_[out]) - values_[in]);
      const Vector3 from = position(in);
      mesh_.vertices.push_back(from + std::max(t, kLeastShare) * (position(out) - from));
    }
    return known->second;
  }

  /// The corner of the cell at the lesser point that is the larger point.
  std::uint64_t direction(std::size_t lesser, std::size_t larger) const {
    std::uint64_t corner = 0;
    const auto a = lattice_.coordinates(lesser);
    const auto b = lattice_.coordinates(larger);
    for (std::size_t axis = 0; axis < 3; ++axis) corner = 2 * corner + (b[axis] != a[axis] ? 1 : 0);
    return corner;
  }

  Vector3 position(std::size_t point) const {
    const auto [x, y, z] = lattice_.coordinates(point);
    return lattice_.point(x, y, z);
  }

  const Lattice& lattice_;
  const std::vector<float>& values_;
  float level_;
  TriangleMesh mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertexOf_;
};

}  // namespace

TriangleMesh levelSurface(const Lattice& lattice, const std::vector<float>& values, float level) {
  return SurfaceBuilder(lattice, values, level).build();
}

}  // namespace glissade
