#include "engine/geometry/solid_interior.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/exact_predicates.h"

namespace glissade {
namespace {

constexpr std::size_t kFinest = 256;
/// Most column entries per triangle. Large triangles lie in many columns, so that coarser columns are taken where there
/// would be more entries.
constexpr std::size_t kEntriesPerTriangle = 16;

/// Turn from a by b to p in the plane of y and z, with p moved by (e, e^2) for an infinitesimal e > 0. It is 0 only
/// where a and b have the same projection.
int movedTurn(const Vector3& a, const Vector3& b, const Vector3& p) {
  const int turn = orientation2d(a, b, p, 0);
  if (turn != 0) return turn;
  if (a.z() != b.z()) return a.z() > b.z() ? 1 : -1;
  return a.y() == b.y() ? 0 : b.y() > a.y() ? 1 : -1;
}

/// True if the ray from p along +x may meet the contents of the box.
bool mayCross(const Box3& box, const Vector3& p) {
  return box.max().x() >= p.x() && box.min().y() <= p.y() && box.max().y() >= p.y() && box.min().z() <= p.z() &&
         box.max().z() >= p.z();
}

/// 1 or -1 where the ray from p along +x passes through the triangle, by the side from which it comes; else 0.
int crossing(const Triangle& t, const Vector3& p) {
  const int turn = movedTurn(t[0], t[1], p);
  if (turn == 0 || turn != movedTurn(t[1], t[2], p) || turn != movedTurn(t[2], t[0], p)) return 0;
  // Seen along +x the corners turn by `turn`; p is before the plane if it lies on that side of it.
  return orientation3d(t[0], t[1], t[2], p) == turn ? turn : 0;
}

}  // namespace

SolidInterior::SolidInterior(const TriangleMesh& mesh, bool consistentlyOriented)
    : oriented_(consistentlyOriented), box_(boundingBox(mesh)) {
  triangles_.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles_.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    boxes_.push_back(Box3(mesh.vertices[a]).extend(mesh.vertices[b]).extend(mesh.vertices[c]));
  }
  const auto fitting = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles_.size())));
  resolution_ = std::clamp(fitting, std::size_t{1}, kFinest);
  while (resolution_ > 1 && entriesAt(resolution_) > kEntriesPerTriangle * triangles_.size()) resolution_ /= 2;
  entriesAt(resolution_);
  fillColumns();
}

std::size_t SolidInterior::columnAlong(int axis, double coordinate) const {
  const double width = box_.sizes()[axis];
  if (width <= 0.0) return 0;
  const double scaled = (coordinate - box_.min()[axis]) / width * static_cast<double>(resolution_);
  return static_cast<std::size_t>(std::clamp(scaled, 0.0, static_cast<double>(resolution_ - 1)));
}

/// Number of entries; stores the end of each column's entries in `begins_`.
std::size_t SolidInterior::entriesAt(std::size_t resolution) {
  resolution_ = resolution;
  begins_.assign(resolution * resolution + 1, 0);
  std::size_t entries = 0;
  for (const Triangle& t : triangles_) {
    const Vector3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    const Vector3 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    for (std::size_t y = columnAlong(1, low.y()); y <= columnAlong(1, high.y()); ++y) {
      for (std::size_t z = columnAlong(2, low.z()); z <= columnAlong(2, high.z()); ++z) {
        ++begins_[y * resolution + z + 1];
        ++entries;
      }
    }
  }
  return entries;
}

void SolidInterior::fillColumns() {
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  entries_.resize(begins_.back());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& t = triangles_[i];
    const Vector3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    const Vector3 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    for (std::size_t y = columnAlong(1, low.y()); y <= columnAlong(1, high.y()); ++y) {
      for (std::size_t z = columnAlong(2, low.z()); z <= columnAlong(2, high.z()); ++z) {
        entries_[next[y * resolution_ + z]++] = i;
      }
    }
  }
}

bool SolidInterior::contains(const Vector3& p) const {
  if (!box_.contains(p)) return false;
  const std::size_t column = columnAlong(1, p.y()) * resolution_ + columnAlong(2, p.z());
  int winding = 0;
  int crossings = 0;
  for (std::uint32_t i = begins_[column]; i < begins_[column + 1]; ++i) {
    if (!mayCross(boxes_[entries_[i]], p)) continue;
    const int sign = crossing(triangles_[entries_[i]], p);
    winding += sign;
    crossings += sign != 0 ? 1 : 0;
  }
  return oriented_ ? winding != 0 : crossings % 2 != 0;
}

}  // namespace glissade
