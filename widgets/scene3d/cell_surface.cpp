#include "widgets/scene3d/cell_surface.h"

#include <algorithm>
#include <map>
#include <set>

namespace glissade {
namespace {

/// The faces of one plane, by their two in-plane coordinates.
using Mask = std::set<std::pair<int, int>>;

/// Takes rectangles out of a mask. Each is as long as possible along v, and has as many rows as possible along u.
template <class Emit>
void mergeRectangles(Mask& mask, Emit&& emit) {
  while (!mask.empty()) {
    const int u = mask.begin()->first;
    const int v = mask.begin()->second;
    int vEnd = v + 1;
    while (mask.count({u, vEnd}) != 0) ++vEnd;
    int uEnd = u + 1;
    const auto rowIsFull = [&] {
      for (int k = v; k < vEnd; ++k) {
        if (mask.count({uEnd, k}) == 0) return false;
      }
      return true;
    };
    while (rowIsFull()) ++uEnd;
    for (int i = u; i < uEnd; ++i) mask.erase(mask.find({i, v}), std::next(mask.find({i, vEnd - 1})));
    emit(u, uEnd, v, vEnd);
  }
}

}  // namespace

std::vector<CellFace> surfaceOf(
    const CellGrid& grid, const std::vector<std::size_t>& cells,
    const std::function<bool(std::size_t cell, std::optional<std::size_t> beyond)>& across) {
  std::vector<CellFace> faces;
  const double size = grid.cellSize();
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const std::size_t u = (a + 1) % 3;
    const std::size_t v = (a + 2) % 3;
    for (const int side : {0, 1}) {
      std::map<int, Mask> planes;
      for (const std::size_t cell : cells) {
        const auto c = grid.coordinates(cell);
        const bool rim = side == 0 ? c[a] == 0 : c[a] + 1 == grid.counts[a];
        std::optional<std::size_t> beyond;
        if (!rim) beyond = side == 0 ? cell - grid.stride(axis) : cell + grid.stride(axis);
        if (across(cell, beyond)) planes[c[a] + side].insert({c[u], c[v]});
      }
      for (auto& [plane, mask] : planes) {
        mergeRectangles(mask, [&, p = plane](int u0, int u1, int v0, int v1) {
          const auto corner = [&](int cu, int cv) {
            Vector3 index;
            index[axis] = p;
            index[static_cast<Eigen::Index>(u)] = cu;
            index[static_cast<Eigen::Index>(v)] = cv;
            return Vector3(grid.frame.origin + size * index);
          };
          faces.push_back({{corner(u0, v0), corner(u1, v0), corner(u1, v1), corner(u0, v1)},
                           (side == 0 ? -1.0 : 1.0) * Vector3::Unit(axis)});
        });
      }
    }
  }
  return faces;
}

std::vector<CellFace> outerSurface(const CellGrid& grid, const std::vector<std::size_t>& cells) {
  std::vector<char> in(grid.size(), 0);
  for (const std::size_t cell : cells) in[cell] = 1;
  return surfaceOf(grid, cells,
                   [&](std::size_t, std::optional<std::size_t> beyond) { return !beyond || in[*beyond] == 0; });
}

}  // namespace glissade
