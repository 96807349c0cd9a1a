#include "engine/evidence/surface_cut.h"

#include <algorithm>

namespace glissade::evidence {
namespace {

constexpr double kOnPlane = 1e-9;    ///< metres: corners within this distance are on the plane
constexpr double kOnSurface = 1e-8;  ///< metres: points within this distance are on the surface
constexpr std::size_t kMostPieces = 4'000'000;

/// The box around a polygon or a triangle.
template <class Corners>
Box3 boxOf(const Corners& corners) {
  Box3 box;
  for (const Vector3& corner : corners) box.extend(corner);
  return box;
}

struct CuttingPlane {
  Vector3 point;
  Vector3 normal;

  double distanceTo(const Vector3& p) const { return normal.dot(p - point); }
};

struct Halves {
  Polygon below;  ///< empty: no part is below the plane
  Polygon above;
};

/// Corners on the plane belong to both halves.
Halves halved(const Polygon& polygon, const CuttingPlane& plane) {
  Halves halves;
  bool below = false;
  bool above = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& from = polygon[i];
    const Vector3& to = polygon[(i + 1) % polygon.size()];
    const double a = plane.distanceTo(from);
    const double b = plane.distanceTo(to);
    below = below || a < -kOnPlane;
    above = above || a > kOnPlane;
    if (a <= kOnPlane) halves.below.push_back(from);
    if (a >= -kOnPlane) halves.above.push_back(from);
    if (std::min(a, b) >= -kOnPlane || std::max(a, b) <= kOnPlane) continue;
    const Vector3 cut = from + a / (a - b) * (to - from);
    halves.below.push_back(cut);
    halves.above.push_back(cut);
  }
  if (!below) halves.below.clear();
  if (!above) halves.above.clear();
  return halves;
}

/// No piece crosses the surface, so that one point clearly off the surface decides for all of it.
Side sideOf(const Polygon& piece, const PlacedBody& other) {
  const auto decide = [&](const Vector3& p) {
    if (other.tree.nearest(p, kOnSurface).distance < kOnSurface) return Side::On;
    return other.contains(p) ? Side::Inside : Side::Outside;
  };
  const Vector3 middle = middleOf(piece);
  Side side = decide(middle);
  for (std::size_t i = 0; i < piece.size() && side == Side::On; ++i) {
    side = decide((middle + piece[i] + piece[(i + 1) % piece.size()]) / 3.0);
  }
  return side;
}

/// Cuts the surface of one body where it meets the surface of another one.
class SurfaceCut {
 public:
  using Take = std::function<void(const CutPiece&)>;

  SurfaceCut(const PlacedBody& body, const PlacedBody& other, const StopToken& stop)
      : body_(body), other_(other), stop_(stop) {}

  bool each(const Take& take) {
    for (std::uint32_t t = 0; t < body_.tree.triangles().size(); ++t) {
      const Triangle& triangle = body_.tree.triangles()[t];
      const Polygon whole(triangle.begin(), triangle.end());
      if (!boxOf(whole).intersects(other_.tree.box())) {
        take({whole, t, Side::Outside});
      } else if (!eachOf(whole, t, take)) {
        return false;
      }
    }
    return true;
  }

 private:
  std::vector<std::uint32_t> meeting(const Triangle& triangle) const {
    std::vector<std::uint32_t> others;
    const Box3 box = boxOf(triangle);
    other_.tree.visit(box, [&](std::uint32_t k) {
      if (!other_.normals[k].isZero() && trianglesMeet(triangle, other_.tree.triangles()[k])) others.push_back(k);
      return !stop_.stopRequested();
    });
    return others;
  }

  struct Piece {
    Polygon polygon;
    std::size_t next;  ///< index of the next triangle to compare it with
  };

  bool eachOf(const Polygon& whole, std::uint32_t number, const Take& take) {
    const std::vector<std::uint32_t> others = meeting(body_.tree.triangles()[number]);
    std::vector<Piece> open{{whole, 0}};
    while (!open.empty()) {
      if (stop_.stopRequested() || ++pieces_ > kMostPieces) return false;
      Piece piece = std::move(open.back());
      open.pop_back();
      const Box3 box = boxOf(piece.polygon);
      bool parted = false;
      for (; piece.next < others.size() && !parted; ++piece.next) {
        const Triangle& triangle = other_.tree.triangles()[others[piece.next]];
        if (!box.intersects(boxOf(triangle))) continue;
        Halves halves = halved(piece.polygon, {triangle[0], other_.normals[others[piece.next]]});
        parted = !halves.below.empty() && !halves.above.empty();
        if (!parted) continue;
        open.push_back({std::move(halves.below), piece.next + 1});
        open.push_back({std::move(halves.above), piece.next + 1});
      }
      if (parted) continue;
      const Side side = sideOf(piece.polygon, other_);
      take({std::move(piece.polygon), number, side});
    }
    return true;
  }

  const PlacedBody& body_;
  const PlacedBody& other_;
  const StopToken& stop_;
  std::size_t pieces_ = 0;
};

}  // namespace

Vector3 middleOf(const Polygon& polygon) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

bool cutSurface(const PlacedBody& body, const PlacedBody& other, const std::function<void(const CutPiece&)>& take,
                const StopToken& stop) {
  return SurfaceCut(body, other, stop).each(take);
}

}  // namespace glissade::evidence
