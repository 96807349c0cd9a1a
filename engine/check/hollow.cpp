#include "engine/check/hollow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/check/evidence.h"

namespace glissade::check {
namespace {

constexpr double kOnPlane = 1e-9;    ///< metres: corners nearer to a plane are not parted by it
constexpr double kOnSurface = 1e-8;  ///< metres: nearer points are not known to be inside or outside
constexpr std::size_t kMostPieces = 4'000'000;

/// Convex, its corners in the order of its triangle.
using Polygon = std::vector<Vector3>;

/// Of a polygon or a triangle.
template <class Corners>
Box3 boxOf(const Corners& corners) {
  Box3 box;
  for (const Vector3& corner : corners) box.extend(corner);
  return box;
}

Vector3 middleOf(const Polygon& polygon) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

struct CuttingPlane {
  Vector3 point;
  Vector3 normal;

  double distanceTo(const Vector3& p) const { return normal.dot(p - point); }
};

struct Halves {
  Polygon below;  ///< empty: nothing is below the plane
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

enum class Side { Inside, Outside, Unknown };

/// No piece crosses the surface, so that one point of it that is clearly off the surface decides for all.
Side sideOf(const Polygon& piece, const PlacedBody& other) {
  const auto decide = [&](const Vector3& p) {
    if (other.tree.nearest(p, kOnSurface).distance < kOnSurface) return Side::Unknown;
    return other.contains(p) ? Side::Inside : Side::Outside;
  };
  const Vector3 middle = middleOf(piece);
  Side side = decide(middle);
  for (std::size_t i = 0; i < piece.size() && side == Side::Unknown; ++i) {
    side = decide((middle + piece[i] + piece[(i + 1) % piece.size()]) / 3.0);
  }
  return side;
}

/// Cuts the surface of one body where it meets that of another one.
class SurfaceCut {
 public:
  SurfaceCut(const PlacedBody& body, const PlacedBody& other, const StopToken& stop)
      : body_(body), other_(other), stop_(stop) {}

  /// Tells of each piece of the surface on which side of the other one it is. Whether all were told.
  template <class Take>
  bool each(const Take& take) {
    for (std::uint32_t t = 0; t < body_.tree.triangles().size(); ++t) {
      const Triangle& triangle = body_.tree.triangles()[t];
      const Polygon whole(triangle.begin(), triangle.end());
      if (!boxOf(whole).intersects(other_.tree.box())) {
        take(whole, Side::Outside);
      } else if (!eachOf(whole, meeting(triangle), take)) {
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
    std::size_t next;  ///< of the triangles that it has to be compared with
  };

  template <class Take>
  bool eachOf(const Polygon& whole, const std::vector<std::uint32_t>& others, const Take& take) {
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
      if (!parted) take(piece.polygon, sideOf(piece.polygon, other_));
    }
    return true;
  }

  const PlacedBody& body_;
  const PlacedBody& other_;
  const StopToken& stop_;
  std::size_t pieces_ = 0;
};

void add(const Polygon& piece, bool turned, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), piece.begin(), piece.end());
  for (std::uint32_t i = 2; i < piece.size(); ++i) {
    const std::uint32_t a = first + i - 1;
    const std::uint32_t b = first + i;
    mesh.triangles.push_back(turned ? TriangleIndices{first, b, a} : TriangleIndices{first, a, b});
  }
}

/// The largest distance of points of pieces from a surface, to a hundredth. Over a piece the distance grows by no more
/// than its points move, and the distance from one triangle of the surface is largest at a corner.
class DeepestPoint {
 public:
  explicit DeepestPoint(const PlacedBody& in) : in_(in) {}

  void add(const Polygon& piece) {
    std::vector<Triangle> open;
    for (std::size_t i = 2; i < piece.size(); ++i) open.push_back({piece[0], piece[i - 1], piece[i]});
    while (!open.empty()) {
      const Triangle triangle = open.back();
      open.pop_back();
      const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
      const auto nearest = in_.tree.nearest(middle, std::numeric_limits<double>::infinity());
      const Triangle& surface = in_.tree.triangles()[nearest.triangle];
      double radius = 0.0;
      double atCorners = 0.0;
      for (const Vector3& corner : triangle) {
        radius = std::max(radius, (corner - middle).norm());
        atCorners = std::max(atCorners, (nearestPoint(surface, corner) - corner).norm());
      }
      depth_ = std::max(depth_, nearest.distance);
      if (std::min(nearest.distance + radius, atCorners) > kEnough * depth_ + kOnSurface) halve(triangle, open);
    }
  }
  double depth() const { return depth_; }

 private:
  static constexpr double kEnough = 1.01;

  /// At the middle of the longest edge.
  static void halve(const Triangle& triangle, std::vector<Triangle>& open) {
    std::size_t longest = 0;
    const auto lengthOf = [&](std::size_t edge) { return (triangle[(edge + 1) % 3] - triangle[edge]).squaredNorm(); };
    for (const std::size_t edge : {1, 2}) longest = lengthOf(edge) > lengthOf(longest) ? edge : longest;
    const Vector3& a = triangle[longest];
    const Vector3& b = triangle[(longest + 1) % 3];
    const Vector3& c = triangle[(longest + 2) % 3];
    const Vector3 middle = 0.5 * (a + b);
    open.push_back({a, middle, c});
    open.push_back({middle, b, c});
  }

  const PlacedBody& in_;
  double depth_ = 0.0;
};

}  // namespace

std::optional<Hollow> hollowed(const PlacedBody& body, const PlacedBody& guest, const StopToken& stop) {
  if (!body.interior || !guest.interior || !body.tree.box().intersects(guest.tree.box())) return std::nullopt;
  Hollow hollow;
  DeepestPoint inGuest(guest);
  DeepestPoint inBody(body);
  const bool cut = SurfaceCut(body, guest, stop).each([&](const Polygon& piece, Side side) {
    if (side == Side::Inside) {
      inGuest.add(piece);
    } else {
      add(piece, false, hollow.mesh);
    }
  });
  const bool walled = cut && SurfaceCut(guest, body, stop).each([&](const Polygon& piece, Side side) {
    if (side != Side::Inside) return;
    inBody.add(piece);
    add(piece, true, hollow.mesh);
  });
  const double a = inGuest.depth();
  const double b = inBody.depth();
  if (!walled || hollow.mesh.empty() || std::max(a, b) <= 0.0) return std::nullopt;
  hollow.depth = std::min(a, b) > 0.0 ? std::min(a, b) : std::max(a, b);
  hollow.mesh = welded(hollow.mesh);
  return hollow;
}

double hollowRoom(const PlacedBody& one, const PlacedBody& other) {
  return one.spacing + other.spacing +
         assembledMargin(std::max({one.radius, one.halfDiagonal, other.radius, other.halfDiagonal}));
}

}  // namespace glissade::check
