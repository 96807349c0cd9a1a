#include "engine/places/inside_columns.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// The point of a cell through which its ray goes. It is off the centre, so that the ray hardly ever meets an edge of a
/// body that is aligned with the cells.
constexpr std::array<double, 3> kRay{0.5003173, 0.4991271, 0.5};

/// The side of the line through a and b on which (x, y) lies: the same answer for both triangles
/// of an edge, whatever the rounding, because the ends are taken in one order.
bool leftOf(const Vector3& a, const Vector3& b, double x, double y) {
  const bool swapped = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
  const Vector3& p = swapped ? b : a;
  const Vector3& q = swapped ? a : b;
  const bool left = (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x()) >= 0.0;
  return left != swapped;
}

}  // namespace

InsideColumns::InsideColumns(const TriangleMesh& mesh_W, const CellFrame& frame, int depth,
                             const std::vector<Box3>& boxes)
    : frame_(frame), size_(frame.cellSize(depth)) {
  const Box3 body = boundingBox(mesh_W);
  const std::uint32_t all = 1U << static_cast<unsigned>(depth);
  counts_ = {all, all};  // of the whole root until the body's are known
  const auto [xs, ys] = rangeOf(body);
  first_ = {xs[0], ys[0]};
  counts_ = {xs[1] - xs[0] + 1, ys[1] - ys[0] + 1};
  last_.assign(static_cast<std::size_t>(counts_[0]) * counts_[1], kNotAskedFor);
  for (const Box3& box : boxes) askFor(box.intersection(body));
  for (const auto& [a, b, c] : mesh_W.triangles) {
    addTriangle({mesh_W.vertices[a], mesh_W.vertices[b], mesh_W.vertices[c]});
  }
}

void InsideColumns::askFor(const Box3& box) {
  if (box.isEmpty()) return;
  const Vector3 margin = Vector3::Constant(size_);
  const auto [xs, ys] = rangeOf({box.min() - margin, box.max() + margin});
  for (std::uint32_t x = xs[0]; x <= xs[1]; ++x) {
    std::fill_n(last_.begin() + static_cast<std::ptrdiff_t>(column(x, ys[0])), ys[1] - ys[0] + 1, kNone);
  }
}

InsideColumns::ColumnRange InsideColumns::rangeOf(const Box3& box) const {
  ColumnRange range{};
  for (int axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const auto at = [&](double value) {
      const double offset = std::floor((value - frame_.origin[axis]) / size_) - first_[i];
      return static_cast<std::uint32_t>(std::clamp(offset, 0.0, counts_[i] - 1.0)) + first_[i];
    };
    range[i] = {at(box.min()[axis]), at(box.max()[axis])};
  }
  return range;
}

double InsideColumns::coordinate(std::uint32_t index, int axis) const {
  return frame_.origin[axis] + (index + kRay[static_cast<std::size_t>(axis)]) * size_;
}

void InsideColumns::addTriangle(const std::array<Vector3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3 normal = (b - a).cross(c - a);
  if (normal.z() == 0.0) return;
  const auto [xs, ys] = rangeOf(Box3(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)));
  for (std::uint32_t ix = xs[0]; ix <= xs[1]; ++ix) {
    const double x = coordinate(ix, 0);
    for (std::uint32_t iy = ys[0]; iy <= ys[1]; ++iy) {
      std::int32_t& last = last_[column(ix, iy)];
      if (last == kNotAskedFor) continue;
      const double y = coordinate(iy, 1);
      const bool left = leftOf(a, b, x, y);
      if (leftOf(b, c, x, y) != left || leftOf(c, a, x, y) != left) continue;
      const double z = a.z() - (normal.x() * (x - a.x()) + normal.y() * (y - a.y())) / normal.z();
      crossings_.push_back({z, left ? 1 : -1, last});
      last = static_cast<std::int32_t>(crossings_.size() - 1);
    }
  }
}

bool InsideColumns::inside(const std::array<std::uint32_t, 3>& index) const {
  if (index[0] < first_[0] || index[0] - first_[0] >= counts_[0] || index[1] < first_[1] ||
      index[1] - first_[1] >= counts_[1]) {
    return false;
  }
  const double z = coordinate(index[2], 2);
  int winding = 0;
  for (std::int32_t i = last_[column(index[0], index[1])]; i >= 0;) {
    const Crossing& crossing = crossings_[static_cast<std::size_t>(i)];
    if (crossing.z > z) winding += crossing.turns;
    i = crossing.next;
  }
  return winding != 0;
}

}  // namespace glissade
